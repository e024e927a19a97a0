// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
// Other embeddings than the paper's: metrics of the curvature are positive definite, bounded and graded and bring meshes near the
// best distance; fields refine where they vary.

#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Interpolated_vertex_field.h>
#include <CGAL/Anisotropic_hde_remeshing/Scalar_field_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/approximation_bounds.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_updater.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::Matrix2d random_symmetric(std::mt19937& random, const double magnitude)
{
  std::uniform_real_distribution<double> number(-magnitude, magnitude);
  Eigen::Matrix2d m;
  m(0, 0) = number(random);
  m(1, 1) = number(random);
  m(0, 1) = m(1, 0) = number(random);
  return m;
}

template <typename Metric>
void check_positive_definite(const Metric& metric)
{
  std::mt19937 random(1);
  for (const double magnitude : {0., 1e-12, 1e-3, 1., 1e3, 1e9})
    for (int i = 0; i < 50; ++i)
    {
      const Eigen::Matrix2d m = metric.of_shape_operator(random_symmetric(random, magnitude));
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(m);
      CHECK(m.allFinite() && solver.eigenvalues()[0] > 0 && m == m.transpose());
    }
}

void test_metric_of_curvature()
{
  for (const double p : {1., 2., 7.5, infinity})
    check_positive_definite(Hde::Curvature_metric(p));
  check_positive_definite(Hde::Adaptive_normal_embedding());

  // det|S|^(-1/(2p+2)) |S|, where the regularisation is negligible and both curvatures have one sign
  Eigen::Matrix2d shape_operator;
  shape_operator << 50, 20, 20, 90;
  for (const double p : {1., 2., infinity})
  {
    const double factor = std::isinf(p) ? 1 : std::pow(shape_operator.determinant(), -1 / (2 * p + 2));
    CHECK((Hde::Curvature_metric(p).of_shape_operator(shape_operator) - factor * shape_operator).norm() <
          1e-3 * factor * shape_operator.norm());
    // the absolute value: the same for the other side of the surface
    CHECK((Hde::Curvature_metric(p).of_shape_operator(-shape_operator) - factor * shape_operator).norm() <
          1e-3 * factor * shape_operator.norm());
  }
  // I + S^2 / |K|
  const Eigen::Matrix2d adaptive = Eigen::Matrix2d::Identity() + shape_operator * shape_operator / shape_operator.determinant();
  CHECK((Hde::Adaptive_normal_embedding().of_shape_operator(shape_operator) - adaptive).norm() < 0.1 * adaptive.norm());

  CHECK(contains(invalid_argument_message([] { Hde::Curvature_metric(0.9); }), "p of Curvature_metric is 0.9"));
  CHECK_THROWS(Hde::Curvature_metric(std::nan("")), std::invalid_argument);
  Hde::Metric_bounds bounds;
  bounds.gradation = 1;
  CHECK(contains(invalid_argument_message([&] { Hde::Curvature_metric(2, bounds); }), "Metric_bounds::gradation is 1"));
  bounds = Hde::Metric_bounds();
  bounds.shortest_edge = 0.5;
  CHECK_THROWS(Hde::Adaptive_normal_embedding(bounds), std::invalid_argument);
  bounds = Hde::Metric_bounds();
  bounds.turn = 0;
  CHECK_THROWS(Hde::Curvature_metric(2, bounds), std::invalid_argument);
}

void test_metric_intersection()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, 2 * pi);
  for (int i = 0; i < 200; ++i)
  {
    const Eigen::Matrix2d r = random_symmetric(random, 1), s = random_symmetric(random, 3);
    const Eigen::Matrix2d a = r * r + 0.01 * Eigen::Matrix2d::Identity(), b = s * s + 0.01 * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d both = internal::metric_intersection(a, b);
    for (int k = 0; k < 10; ++k)
    {
      const double t = angle(random);
      const Eigen::Vector2d e(std::cos(t), std::sin(t));
      CHECK(e.dot(both * e) >= (1 - 1e-9) * (std::max)(e.dot(a * e), e.dot(b * e)));
    }
    CHECK((internal::metric_intersection(b, a) - both).norm() < 1e-6 * both.norm());
    CHECK((internal::metric_intersection(a, 0.5 * a) - a).norm() < 1e-9 * a.norm());
    CHECK((internal::bounded_metric(a, 5, 7) - internal::bounded_metric(a, 5, 7).transpose()).norm() == 0);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(internal::bounded_metric(a, 0.5, 2));
    CHECK(solver.eigenvalues()[0] >= 0.5 - 1e-12 && solver.eigenvalues()[1] <= 2 + 1e-12);
  }
}

// On a mesh whose curvature varies by a large factor from vertex to vertex: lengths along an edge in the metrics of its ends differ
// by no more than the gradation says; bounds hold; lengths of the sides of faces obey the triangle inequality up to interpolation.
void test_gradation()
{
  typedef Hde::Curvature_metric Metric;
  typedef internal::Metric_embedding<Metric> Embedding;
  typedef internal::Working_mesh<Embedding::Vertex_data> Working_mesh;
  const Mesh input = ellipsoid(4, Ellipsoid_function{0.05, 1, 1});
  Working_mesh mesh;
  std::vector<internal::Vertex_index> vertices;
  for (const Mesh::Vertex_index v : input.vertices())
  {
    const Point_3 p = input.point(v);
    const Vector_3 g = Ellipsoid_function{0.05, 1, 1}.gradient(p);
    Working_mesh::Vertex vertex;
    vertex.point = internal::Vector(p.x(), p.y(), p.z());
    vertex.normal = internal::Vector(g.x(), g.y(), g.z()).normalized();
    vertices.push_back(mesh.add_vertex(vertex));
  }
  for (const Mesh::Face_index f : input.faces())
  {
    std::array<internal::Vertex_index, 3> corners;
    std::size_t k = 0;
    for (const Mesh::Vertex_index v : input.vertices_around_face(input.halfedge(f)))
      corners[k++] = vertices[v];
    mesh.add_face(corners[0], corners[1], corners[2]);
  }
  const double diagonal = bounding_box_diagonal(input), length = 0.1;
  const auto largest_violation = [&](const Metric& metric)
  {
    internal::Interruption never;
    const Embedding embedding(metric);
    internal::Metric_updater<Tag, Working_mesh, Embedding>(mesh, embedding, diagonal, length, never)();
    double largest = 0;
    for (const internal::Halfedge_index h : mesh.halfedges())
    {
      const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
      const internal::Vector edge = b.point - a.point;
      const double at_a = std::sqrt(a.squared_length(edge)) / length, at_b = std::sqrt(b.squared_length(edge)) / length;
      // the metric of a, grown along the edge, is no more than that of b
      largest = (std::max)(largest, at_a / (1 + at_a * std::log(Hde::Metric_bounds().gradation)) / at_b);
    }
    return largest;
  };
  const double with = largest_violation(Metric(2));
  Hde::Metric_bounds loose;
  loose.gradation = 1e9;
  const double without = largest_violation(Metric(2, loose));
  std::cout << "gradation: " << with << ", without a limit " << without << std::endl;
  CHECK(with < 1.1); // edges bend, and sweeps stop when little changes
  CHECK(without > 1.3);

  largest_violation(Metric(2));
  const Embedding metric(Metric(2));
  double worst = 0;
  for (const internal::Face_index f : mesh.faces())
  {
    const internal::Triangle t(mesh.halfedge(f), mesh);
    const auto &a = mesh.point(t.a), &b = mesh.point(t.b), &c = mesh.point(t.c);
    const double ab = std::sqrt(metric.squared_length(a, b)), bc = std::sqrt(metric.squared_length(b, c)),
                 ca = std::sqrt(metric.squared_length(c, a));
    CHECK(ab > 0 && bc > 0 && ca > 0);
    worst = (std::max)({worst, ab / (bc + ca), bc / (ca + ab), ca / (ab + bc)});
  }
  std::cout << "triangle inequality: " << worst << std::endl;
  CHECK(worst < 1.1);
}

template <typename Function>
double rms_over_bound(const Mesh& mesh, const Function& function)
{
  return Hde::measure_distance_to_zero_set(mesh, function).face_rms / Hde::approximation_bounds(mesh, function).rms_on_surface;
}

void test_remeshing_with_metrics()
{
  const Mesh input = ellipsoid(5), ring = torus(256, 64);
  for (const double p : {1., 2., infinity})
  {
    Mesh mesh = input, same = input, other = ring;
    const auto np = params::embedding(Hde::Curvature_metric(p)).number_of_target_faces(5000);
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), np);
    remeshing_checks::check_validity("ellipsoid", input, mesh, Ellipsoid_function());
    remeshing_checks::check_number_of_faces(mesh, 5000);
    CHECK(result.binding_target == Hde::Target::NUMBER_OF_FACES);
    CGAL::anisotropic_hde_remeshing(same, Ellipsoid_function(), np);
    CHECK(remeshing_checks::digest(mesh) == remeshing_checks::digest(same));
    CGAL::anisotropic_hde_remeshing<Tag>(other, Torus_function(), np);
    remeshing_checks::check_validity("torus", ring, other, Torus_function());
    const double on_ellipsoid = rms_over_bound(mesh, Ellipsoid_function()), on_torus = rms_over_bound(other, Torus_function());
    std::cout << "p " << p << ": rms over the bound " << on_ellipsoid << ", torus " << on_torus << std::endl;
    CHECK(on_ellipsoid < 1.2);
    CHECK(on_torus < 1.3);
  }
  // the paper's embedding is further from it
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::relative_sigma(0.15).number_of_target_faces(5000));
  CHECK(rms_over_bound(mesh, Ellipsoid_function()) > 1.25);

  mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                       params::embedding(Hde::Adaptive_normal_embedding()).number_of_target_faces(5000));
  remeshing_checks::check_validity("adaptive", input, mesh, Ellipsoid_function());
  remeshing_checks::check_number_of_faces(mesh, 5000);
}

// the same mesh in another unit, a power of two: the same connectivity, with a target length, too
void test_units()
{
  const double unit = 1024;
  const Mesh input = ellipsoid(4);
  Mesh large = input;
  for (const Mesh::Vertex_index v : large.vertices())
    large.point(v) = CGAL::ORIGIN + unit * (large.point(v) - CGAL::ORIGIN);
  struct Large_ellipsoid : Ellipsoid_function
  {
    FT operator()(const Point_3& p) const { return Ellipsoid_function::operator()(CGAL::ORIGIN + (p - CGAL::ORIGIN) / 1024.); }
    Vector_3 gradient(const Point_3& p) const
    {
      return Ellipsoid_function::gradient(CGAL::ORIGIN + (p - CGAL::ORIGIN) / 1024.) / 1024.;
    }
  };
  const Hde::Curvature_metric metric(infinity);
  Mesh mesh = input;
  const double length = 0.3;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::embedding(metric).target_edge_length(length));
  CGAL::anisotropic_hde_remeshing<Tag>(large, Large_ellipsoid(),
                                       params::embedding(metric).target_edge_length(length * metric.unit_of_lengths(unit)));
  CHECK(result.binding_target == Hde::Target::EDGE_LENGTH);
  CHECK_CLOSE(result.target_edge_length, length, 1e-12);
  CHECK(mesh.number_of_faces() == large.number_of_faces());
  double largest = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    largest = (std::max)(
        largest, std::sqrt(CGAL::squared_distance(CGAL::ORIGIN + unit * (mesh.point(v) - CGAL::ORIGIN), large.point(v))));
  CHECK(largest < 1e-9 * unit);
}

// one type for all fields, as each is compiled with the whole remesher
typedef std::function<double(const Point_3&)> Field;

Hde::Scalar_field_embedding<Point_3, Field> embedding_of(const double sigma, const double tau, const Field& field)
{
  return Hde::scalar_field_embedding<Point_3>(sigma, tau, field);
}

// a steep front
double front(const Point_3& p) { return std::tanh(30 * p.z()); }

// root mean square over the surface of the difference between the front and its interpolation on the faces
double interpolation_error(const Mesh& mesh)
{
  static constexpr int n = 6;
  double sum = 0, area = 0;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
    const double weight = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
      {
        const double u = (i + 1. / 3) / n, v = (j + 1. / 3) / n;
        const double interpolated = (1 - u - v) * front(a) + u * front(b) + v * front(c);
        const double difference = interpolated - front(a + u * (b - a) + v * (c - a));
        sum += weight * difference * difference;
        area += weight;
      }
  }
  return std::sqrt(sum / area);
}

void test_fields()
{
  const Mesh input = icosphere(5);
  const Sphere_function sphere;

  // a front takes a fifth of the faces of a uniform mesh of the same error
  Mesh adapted = input, uniform = input;
  CGAL::anisotropic_hde_remeshing<Tag>(adapted, sphere,
                                       params::embedding(embedding_of(0, 1, front)).number_of_target_faces(4000));
  CGAL::anisotropic_hde_remeshing<Tag>(uniform, sphere, params::sigma(0).number_of_target_faces(20000));
  const double of_adapted = interpolation_error(adapted), of_uniform = interpolation_error(uniform);
  std::cout << "front: error with 4000 faces " << of_adapted << ", uniform with 20000 " << of_uniform << std::endl;
  CHECK(of_adapted <= of_uniform);
  remeshing_checks::check_validity("front", input, adapted, sphere);

  // what does not vary changes nothing; a vector counts as its components
  Mesh plain = input, constant = input, vector = input, weighted = input;
  CGAL::anisotropic_hde_remeshing<Tag>(plain, sphere, params::sigma(0.1).number_of_target_faces(2000));
  CGAL::anisotropic_hde_remeshing<Tag>(
      constant, sphere,
      params::embedding(embedding_of(0.1, 5, [](const Point_3&) { return 7.; })).number_of_target_faces(2000));
  CHECK_CLOSE(double(plain.number_of_faces()), double(constant.number_of_faces()), 10);
  CHECK_CLOSE(Hde::measure_embedding(plain, sphere, params::sigma(0.1)).edge_length_mean,
              Hde::measure_embedding(constant, sphere, params::sigma(0.1)).edge_length_mean, 1e-3);
  const auto two = [](const Point_3& p) { return std::array<double, 2>{{0.5 * p.x(), 0.5 * p.x()}}; };
  const auto one = [](const Point_3& p) { return std::sqrt(0.5) * p.x(); };
  CGAL::anisotropic_hde_remeshing<Tag>(
      vector, sphere, params::embedding(Hde::scalar_field_embedding<Point_3>(0.1, 2, two)).number_of_target_faces(2000));
  CGAL::anisotropic_hde_remeshing<Tag>(weighted, sphere,
                                       params::embedding(embedding_of(0.1, 2, one)).number_of_target_faces(2000));
  CHECK_CLOSE(double(vector.number_of_faces()), double(weighted.number_of_faces()), 20);
  CHECK_CLOSE(CGAL::bounding_box(vector.points().begin(), vector.points().end()).xmax(), 1, 0.05);

  // a field that is not finite: the exception reaches the caller, and the mesh is as it was
  Mesh refused = input;
  const auto bad = [](const Point_3& p) { return p.z() > 0.9 ? std::nan("") : 0.; };
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(refused, sphere, params::embedding(embedding_of(0, 1, bad))),
               std::domain_error);
  CHECK(remeshing_checks::digest(refused) == remeshing_checks::digest(input));
  CHECK_THROWS(embedding_of(0, -1, front), std::invalid_argument);
  CHECK_THROWS(embedding_of(infinity, 1, front), std::invalid_argument);

  // numbers at vertices, linear on faces
  Mesh mesh = input;
  auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:value").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    values[v] = 1 + mesh.point(v).x() - 2 * mesh.point(v).z();
  const Hde::Interpolated_vertex_field field(mesh, values);
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
    const Point_3 p = a + 0.2 * (b - a) + 0.3 * (c - a);
    CHECK_CLOSE(field(p), 1 + p.x() - 2 * p.z(), 1e-12);
  }
  CHECK_THROWS(Hde::Interpolated_vertex_field(Mesh(), values), std::invalid_argument);
}

// Stops once the field has been asked for a vertex so often since the last iteration, wherever the remeshing is by then: that
// takes so long that the visitor is asked next.
struct Stopping_visitor : Hde::Remeshing_visitor
{
  struct State
  {
    std::atomic<bool> is_last{false}, is_stopped{false};
    std::atomic<std::size_t> number_of_values{0}; // since then
    std::size_t limit;
  };
  State* state;

  void progress(const double share)
  {
    if (share >= 1)
      state->is_last = true;
  }
  bool go_further() { return !state->is_stopped; }

  static Field field(State& state)
  {
    return [&state](const Point_3&)
    {
      if (state.is_last && ++state.number_of_values == state.limit)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(8));
        state.is_stopped = true;
      }
      return 0.;
    };
  }
};

// Vertices that are new when it is stopped are on the surface, too: of one iteration so many edges are left to be split for the error
// that it is nearly all that happens after the last projection of all vertices.
void test_stopping_while_refining()
{
  const Mesh input = ellipsoid(3);
  const auto remesh = [&](const std::size_t limit)
  {
    Stopping_visitor::State state;
    state.limit = limit;
    Stopping_visitor visitor;
    visitor.state = &state;
    Mesh mesh = input;
    const Hde::Remeshing_result result =
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                             params::embedding(embedding_of(0.5, 1, Stopping_visitor::field(state)))
                                                 .relative_approximation_error(5e-4)
                                                 .number_of_iterations(1)
                                                 .visitor(visitor));
    remeshing_checks::check_validity("stopped at value " + std::to_string(limit), input, mesh, Ellipsoid_function());
    CHECK(result.was_stopped == state.is_stopped);
    CHECK(std::isinf(result.approximation_error) == result.was_stopped);
    CHECK(result.number_of_unprojected_vertices == 0);
    return std::make_pair(mesh.number_of_vertices(), std::size_t(state.number_of_values));
  };
  const auto all = remesh(0), before = remesh(1);
  std::cout << "values of " << all.first << " vertices since the last iteration: " << all.second << ", before the refinement "
            << before.first << " vertices" << std::endl;
  CHECK(all.first > before.first + 500);
  const std::size_t first = before.first + 1, steps = 12;
  for (std::size_t k = 0; k < steps; ++k)
    remesh(first + k * (all.second - first) / steps);
}

int main()
{
  test_metric_of_curvature();
  test_metric_intersection();
  test_gradation();
  test_remeshing_with_metrics();
  test_units();
  test_fields();
  test_stopping_while_refining();
  return check_summary();
}
