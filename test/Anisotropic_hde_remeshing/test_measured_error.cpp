// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshing by measured error: samples, what is promised of every result, and how near it comes to the input.

#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Reference_samples.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef internal::Vector Vector;

// --- samples ---

// by the points of a fine grid on the triangle
void test_closest_point()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return Vector(number(random), number(random), number(random)); };
  for (int i = 0; i < 300; ++i)
  {
    const Vector a = point(), b = point(), c = i % 10 == 0 ? Vector((a + 3 * b) / 4) : point(), p = 2 * point();
    const internal::Closest_on_triangle answer = internal::closest_on_triangle(p, a, b, c);
    const Vector& t = answer.barycentric;
    CHECK(t.minCoeff() >= 0);
    CHECK_CLOSE(t.sum(), 1, 1e-12);
    CHECK_CLOSE((t[0] * a + t[1] * b + t[2] * c - p).squaredNorm(), answer.squared_distance, 1e-12);
    const int n = 60;
    double least = std::numeric_limits<double>::max();
    for (int j = 0; j <= n; ++j)
      for (int k = 0; j + k <= n; ++k)
        least = (std::min)(least, ((j * a + k * b + (n - j - k) * c) / n - p).norm());
    const double distance = std::sqrt(answer.squared_distance);
    CHECK(distance <= least + 1e-12);
    CHECK(distance >= least - 4. / n);
  }
}

void test_samples()
{
  const std::vector<Vector> points{Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 2, 0), Vector(1, 2, 1)};
  const std::vector<internal::Facet> facets{{0, 1, 2}, {1, 3, 2}};
  const auto square_of_linear = [](const Vector& p)
  {
    const double f = 1 + 2 * p[0] - 3 * p[1] + p[2];
    return f * f;
  };
  // the integral over a triangle of the square of a linear function
  double integral = 0, area = 0;
  for (const internal::Facet& f : facets)
  {
    const Vector &a = points[f[0]], &b = points[f[1]], &c = points[f[2]];
    const double size = (b - a).cross(c - a).norm() / 2;
    integral += size / 3 * (square_of_linear((a + b) / 2) + square_of_linear((b + c) / 2) + square_of_linear((c + a) / 2));
    area += size;
  }
  for (const double number : {1., 100., 5000.})
  {
    const internal::Reference_samples samples(points, facets, number);
    double sum = 0, weights = 0;
    std::set<std::array<double, 3>> places;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      CHECK(samples[i].area > 0);
      weights += samples[i].area;
      sum += samples[i].area * square_of_linear(samples[i].point);
      places.insert({samples[i].point[0], samples[i].point[1], samples[i].point[2]});
    }
    CHECK(double(samples.size()) >= number);
    CHECK(places.size() == samples.size());
    CHECK_CLOSE(weights, 1, 1e-5);
    CHECK_CLOSE(sum, integral / area, (number > 1 ? 2e-2 : 1e-5) * integral / area);
    for (const Vector& p : points)
      CHECK(places.count({p[0], p[1], p[2]}) == 1);
  }
}

// long facets get no more samples than all others
void test_samples_of_needles()
{
  std::vector<Vector> points;
  std::vector<internal::Facet> facets;
  const std::size_t n = 1000;
  for (std::size_t i = 0; i <= n; ++i)
  {
    points.emplace_back(double(i) / n, 0, 0);
    points.emplace_back(double(i) / n, 10, 0);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    facets.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    facets.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  const std::size_t number = 3000;
  const internal::Reference_samples samples(points, facets, double(number));
  CHECK(samples.size() <= points.size() + facets.size() + 2 * number);
}

// near points of a small area there are more samples, in proportion to it
void test_samples_by_areas()
{
  const std::vector<Vector> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  const std::vector<internal::Facet> facets{{0, 1, 2}, {3, 4, 5}};
  for (const double ratio : {1., 16., 1000.})
  {
    const internal::Reference_samples samples(points, facets, {1, 1, 1, ratio, ratio, ratio}, 5000);
    double small = 0, large = 0, area = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      (samples[i].point[0] < 2 ? small : large) += 1;
      area += samples[i].area;
    }
    CHECK(small + large >= 5000);
    CHECK(small >= ratio / 2 * large && small <= 2 * ratio * (large + 1)); // parts are halved
    CHECK_CLOSE(area, 1, 1e-5);
  }
}

// --- results ---

// By default the distance leads where few faces are asked for: it is less than by the embedding, at once in the mean and at most.
void test_distance(const std::string& name, const Mesh& input, const std::size_t number_of_faces, const double least_gain)
{
  Mesh by_error = input, by_embedding = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(by_error, params::number_of_target_faces(number_of_faces));
  CGAL::anisotropic_hde_remeshing<Tag>(
      by_embedding, params::number_of_target_faces(number_of_faces).remeshing_scheme(Hde::Remeshing_scheme::EMBEDDING));
  CHECK(result.sigma == 0); // there is no embedding
  CHECK(result.number_of_iterations > 0 && result.number_of_collapses > 0 && result.number_of_flips > 0);
  CHECK(result.number_of_faces == by_error.number_of_faces());
  check_number_of_faces(by_error, number_of_faces);
  check_same_topology(input, by_error);
  CHECK(!PMP::does_self_intersect(by_error));
  const Hde::Distance_measures distance = Hde::measure_distance<Tag>(by_error, input),
                               other = Hde::measure_distance<Tag>(by_embedding, input);
  const Hde::Shape_measures shape = Hde::measure_shape(by_error);
  std::cout << name << ": rms " << distance.rms() << " (embedding " << other.rms() << "), largest " << distance.max() << " ("
            << other.max() << "), aspect ratio " << shape.aspect_ratio_mean << std::endl;
  // exact facets, as of a block: the embedding keeps them, and nothing is left to gain but the rounding of the fit
  const bool is_kept_by_embedding = other.max() <= 1e-9;
  CHECK(is_kept_by_embedding ? distance.rms() < 1e-6 : distance.rms() * least_gain < other.rms());
  CHECK(is_kept_by_embedding ? distance.max() < 1e-5 : distance.max() < other.max());
}

// which scheme the default is
void test_default()
{
  const Mesh input = icosphere(3);
  const auto sigma_of = [&](const auto& np)
  {
    Mesh mesh = input;
    return CGAL::anisotropic_hde_remeshing<Tag>(mesh, np).sigma;
  };
  CHECK(sigma_of(params::number_of_target_faces(500)) == 0);
  CHECK(sigma_of(params::number_of_target_faces(500).remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR)) == 0);
  CHECK(sigma_of(params::number_of_target_faces(1200)) > 0);
  CHECK(sigma_of(params::number_of_target_faces(1200).remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR)) == 0);
  CHECK(sigma_of(params::number_of_target_faces(1400)) > 0);
  CHECK(sigma_of(params::number_of_target_faces(1400).remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR)) == 0);
  CHECK(sigma_of(params::number_of_target_faces(500).sigma(0.1)) == 0.1);
  CHECK(sigma_of(params::number_of_target_faces(500).number_of_patches(3)) > 0);
  CHECK(sigma_of(params::default_values()) > 0);
  // a function of the caller's
  Mesh mesh = input;
  CHECK(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1}, params::number_of_target_faces(500)).sigma > 0);
  mesh = input;
  CHECK(
      CGAL::anisotropic_hde_remeshing<Tag>(
          mesh, Sphere_function{1}, params::number_of_target_faces(500).remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR))
          .sigma == 0);
}

void test_threads()
{
  const Mesh input = bumpy_sphere(4);
  Mesh one = input, other = input;
  CGAL::anisotropic_hde_remeshing<CGAL::Sequential_tag>(one, params::number_of_target_faces(700));
  CGAL::anisotropic_hde_remeshing<Tag>(other, params::number_of_target_faces(700));
  CHECK(digest(one) == digest(other));
}

// Boundaries keep their corners and stay on their polylines, constrained vertices and edges their places.
void test_constraints()
{
  const Mesh input = hills(40);
  Mesh mesh = input;
  auto is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_constrained", false).first;
  std::set<Point_3> kept;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (std::size_t(v) % 97 == 0)
    {
      is_constrained[v] = true;
      kept.insert(mesh.point(v));
    }
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(600).vertex_is_constrained_map(is_constrained));
  check_number_of_faces(mesh, 600);
  check_same_topology(input, mesh);
  std::set<Point_3> points;
  CGAL::Bbox_3 box;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    points.insert(mesh.point(v));
    box += mesh.point(v).bbox();
  }
  for (const Point_3& p : kept)
    CHECK(points.count(p) == 1);
  CGAL::Bbox_3 old_box;
  for (const Mesh::Vertex_index v : input.vertices())
    old_box += input.point(v).bbox();
  CHECK(box.xmin() == old_box.xmin() && box.xmax() == old_box.xmax() && box.ymin() == old_box.ymin() &&
        box.ymax() == old_box.ymax()); // the sides of the square
}

void test_face_range()
{
  Mesh mesh = bumpy_sphere(4);
  const Mesh input = mesh;
  std::vector<Mesh::Face_index> range;
  std::map<Mesh::Face_index, std::set<Point_3>> rest;
  for (const Mesh::Face_index f : mesh.faces())
  {
    std::set<Point_3> corners;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.insert(mesh.point(v));
    if (std::all_of(corners.begin(), corners.end(), [](const Point_3& p) { return p.z() > 0; }))
      range.push_back(f);
    else
      rest[f] = corners;
  }
  CGAL::anisotropic_hde_remeshing<Tag>(range, mesh, params::number_of_target_faces(range.size() / 4));
  check_same_topology(input, mesh);
  CHECK(mesh.number_of_faces() < input.number_of_faces() - range.size() / 2);
  for (const auto& face : rest)
  {
    std::set<Point_3> corners;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face.first)))
      corners.insert(mesh.point(v));
    CHECK(corners == face.second);
  }
}

// a cube keeps its edges and corners
void test_creases()
{
  const Mesh input = cube(12);
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::sharp_angle(30).number_of_target_faces(300));
  CHECK(result.number_of_regions == 6);
  CHECK(result.curves_after.number_of_curves == 12 && result.curves_after.number_of_corners == 8);
  CHECK_CLOSE(result.curves_after.length, result.curves_before.length, 1e-9 * result.curves_before.length);
  check_number_of_faces(mesh, 300);
  check_same_topology(input, mesh);
  const Hde::Distance_measures distance = Hde::measure_distance<Tag>(mesh, input);
  std::cout << "cube: largest distance " << distance.max() << std::endl;
  CHECK(distance.max() < 1e-9);
}

void test_stopping()
{
  const Mesh input = bumpy_sphere(3);
  check_stopping(
      input, 40, 3,
      [](Mesh& mesh, auto& visitor)
      { return CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(300).visitor(std::ref(visitor))); },
      [&](const Hde::Remeshing_result& result, const Mesh& mesh)
      {
        if (result.was_stopped && result.number_of_iterations == 0)
          CHECK(digest(mesh) == digest(input));
      });
}

// two sheets, nearer to each other than the faces are long
void test_self_intersections()
{
  Mesh outer = bumpy_sphere(4), mesh = outer;
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> copies;
  for (const Mesh::Vertex_index v : outer.vertices())
    copies[v] = mesh.add_vertex(CGAL::ORIGIN + 0.99 * (outer.point(v) - CGAL::ORIGIN));
  for (const Mesh::Face_index f : outer.faces())
  {
    std::vector<Mesh::Vertex_index> corners;
    for (const Mesh::Vertex_index v : outer.vertices_around_face(outer.halfedge(f)))
      corners.push_back(copies[v]);
    mesh.add_face(corners[0], corners[2], corners[1]);
  }
  const Mesh input = mesh;
  CHECK(!PMP::does_self_intersect(input));
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(1500).do_self_intersection_tests(true));
  check_same_topology(input, mesh);
  CHECK(!PMP::does_self_intersect(mesh));
  CHECK(mesh.number_of_faces() < input.number_of_faces() / 2);
}

// With a bound on the aspect ratio, far fewer faces are beyond it, they are counted, and it costs distance. A weight does the same.
void test_shape_of_faces()
{
  const Mesh input = bumpy_sphere(4);
  const double bound = 3;
  const auto share_beyond = [&](const auto& np)
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.number_of_target_faces(1000));
    std::size_t number = 0;
    for (const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                    &c = mesh.point(mesh.target(mesh.next(h)));
      const double longest =
          (std::max)({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
      number += longest > bound * 2 * std::sqrt(CGAL::squared_area(a, b, c)) ? 1 : 0;
    }
    const std::size_t told = result.number_of_faces_beyond_aspect_ratio;
    CHECK(told == number || told == 0);
    CHECK(result.warnings().empty() == (told == 0));
    const double rms = Hde::measure_distance<Tag>(mesh, input).rms();
    std::cout << "beyond an aspect ratio of " << bound << ": " << number << " of " << mesh.number_of_faces() << " faces, told "
              << told << ", rms " << rms << std::endl;
    remeshing_checks::check_same_topology(input, mesh);
    return std::make_pair(double(number) / double(mesh.number_of_faces()), rms);
  };
  const auto free = share_beyond(params::shape_weight(0)), usual = share_beyond(params::do_split(true)),
             heavy = share_beyond(params::shape_weight(20)), bounded = share_beyond(params::aspect_ratio_bound(bound));
  CHECK(bounded.first < usual.first / 2);
  CHECK(heavy.first < usual.first && usual.first < free.first);
  CHECK(free.second < 1.05 * usual.second);
  CHECK(usual.second < bounded.second);
}

int main()
{
  test_closest_point();
  test_samples();
  test_samples_of_needles();
  test_samples_by_areas();
  test_distance("bumpy sphere", bumpy_sphere(5), 1500, 1.5);
  test_distance("hills", hills(60), 800, 1.5);
  test_distance("block", l_block(16), 400, 5);
  test_default();
  test_threads();
  test_constraints();
  test_face_range();
  test_creases();
  test_stopping();
  test_self_intersections();
  test_shape_of_faces();
  return check_summary();
}
