// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The named parameter sizing_field: functions of a point, property maps and PMP's sizing fields, with any embedding, and gradation.

#include "check.h"
#include "length_checks.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#if __has_include(<CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>)
#  include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#  include <CGAL/Polygon_mesh_processing/Uniform_sizing_field.h>
#  define HAS_SIZING_FIELDS_OF_CGAL
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef Mesh::Vertex_index Vertex;

// grows from 0.05 to 0.15 on a sphere of radius 1
template <typename Point>
double size_at_height(const Point& p)
{
  return 0.1 + 0.05 * CGAL::to_double(p.z());
}
double size_of_point(const Point_3& p) { return size_at_height(p); }

template <typename Field>
Mesh remeshed(const Field& field)
{
  Mesh mesh = icosphere(4);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1}, params::sizing_field(field));
  remeshing_checks::check_same_topology(icosphere(4), mesh);
  check_lengths(mesh, size_of_point, 1);
  return mesh;
}

struct Uncopied_field
{
  Uncopied_field() = default;
  Uncopied_field(const Uncopied_field&) = delete;
  double operator()(const Point_3& p) const { return size_at_height(p); }
};

// as CGAL's, of which those before 6.0 have none
struct Field_of_mesh
{
  double at(const Vertex v, const Mesh& mesh) const { return size_at_height(mesh.point(v)); }
};

// however a size is given, it is kept; functions give the same mesh, bit by bit, and so do sizes at vertices
void test_kinds()
{
  const Mesh by_function = remeshed(size_of_point);
  const auto lambda = [](const Point_3& p) { return size_at_height(p); };
  const Uncopied_field uncopied;
  CHECK(remeshing_checks::digest(remeshed(lambda)) == remeshing_checks::digest(by_function));
  CHECK(remeshing_checks::digest(remeshed(std::function<double(const Point_3&)>(lambda))) ==
        remeshing_checks::digest(by_function));
  CHECK(remeshing_checks::digest(remeshed(std::ref(uncopied))) == remeshing_checks::digest(by_function));

  Mesh mesh = icosphere(4);
  std::map<Vertex, double> sizes;
  for (const Vertex v : mesh.vertices())
    sizes[v] = size_at_height(mesh.point(v));
  const Mesh by_vertex = remeshed(boost::associative_property_map<std::map<Vertex, double>>(sizes));
  CHECK(remeshing_checks::digest(remeshed(Field_of_mesh())) == remeshing_checks::digest(by_vertex));
  CHECK(remeshing_checks::digest(by_vertex) != remeshing_checks::digest(by_function)); // linear on facets

  auto map = mesh.add_property_map<Vertex, double>("v:size").first;
  for (const Vertex v : mesh.vertices())
    map[v] = sizes[v];
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1}, params::sizing_field(map));
  CHECK(remeshing_checks::digest(mesh) == remeshing_checks::digest(by_vertex));
}

// on the surface through the vertices, on a part of a mesh, and in other kernels and meshes
void test_overloads()
{
  const auto field = [](const auto& p) { return size_at_height(p); };
  Mesh mesh = icosphere(4);
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::sizing_field(field));
  CHECK(result.binding_target == Hde::Target::EDGE_LENGTH && result.sigma == 0);
  CHECK_CLOSE(result.target_edge_length, 1, 1e-12);
  check_lengths(mesh, size_of_point, 1);

  // sizes are asked for at the vertices of the range only
  mesh = icosphere(4);
  std::vector<Mesh::Face_index> upper;
  std::map<Vertex, double> sizes;
  for (const Mesh::Face_index f : mesh.faces())
  {
    double z = 0;
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      z += mesh.point(v).z();
    if (z > 0)
      upper.push_back(f);
  }
  for (const Mesh::Face_index f : upper)
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      sizes[v] = 0.15;
  const std::size_t number_of_others = mesh.number_of_faces() - upper.size();
  CGAL::anisotropic_hde_remeshing<Tag>(upper, mesh, Sphere_function{1},
                                       params::sizing_field(boost::associative_property_map<std::map<Vertex, double>>(sizes)));
  const double expected = 2 * CGAL_PI / (std::sqrt(3.) / 4 * 0.15 * 0.15);
  CHECK(std::abs(double(mesh.number_of_faces() - number_of_others) / expected - 1) < 0.2);

  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  CGAL::Polyhedron_3<Exact> polyhedron;
  CGAL::copy_face_graph(icosphere(3), polyhedron);
  CGAL::anisotropic_hde_remeshing<Tag>(polyhedron, Sphere_function{1},
                                       params::sizing_field([](const Exact::Point_3& p) { return p.z() / 10 + 0.3; }));
  CHECK(polyhedron.is_valid() && polyhedron.size_of_facets() < 1000);
}

double mean_of_areas_over_sizes(const Mesh& mesh, const double size)
{
  double area = 0;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
    area += std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
  }
  return area / double(mesh.number_of_faces()) / (std::sqrt(3.) / 4 * size * size);
}

// with any embedding: a size everywhere is a target length, or with a metric the area of the faces
void test_embeddings()
{
  Ellipsoid_function function;
  const auto size = [](const Point_3&) { return 0.2; };
  const auto number_of_faces = [&](const auto& np)
  {
    Mesh mesh = ellipsoid(4);
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, np);
    return double(mesh.number_of_faces());
  };
  CHECK_CLOSE(number_of_faces(params::sigma(0.5).sizing_field(size)) /
                  number_of_faces(params::sigma(0.5).target_edge_length(0.2)),
              1, 0.01);
  CHECK_CLOSE(number_of_faces(params::relative_sigma(0.05).sizing_field(size)) /
                  number_of_faces(params::relative_sigma(0.05).target_edge_length(0.2)),
              1, 0.01);
  CHECK_CLOSE(number_of_faces(params::sizing_field(size)) / number_of_faces(params::sigma(0).target_edge_length(0.2)), 1, 0.01);

  Mesh isotropic = ellipsoid(4);
  CGAL::anisotropic_hde_remeshing<Tag>(isotropic, function, params::sizing_field(size));
  const auto check_metric = [&](const auto& metric)
  {
    Mesh mesh = ellipsoid(4);
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::embedding(metric).sizing_field(size));
    const double ratio = mean_of_areas_over_sizes(mesh, 0.2);
    std::cout << "metric: areas over those wanted " << ratio << ", aspect ratio " << Hde::measure_shape(mesh).aspect_ratio_mean
              << std::endl;
    CHECK_CLOSE(ratio, 1, 0.15);
    CHECK(Hde::measure_shape(mesh).aspect_ratio_mean > 1.1 * Hde::measure_shape(isotropic).aspect_ratio_mean);
  };
  check_metric(Hde::Curvature_metric(2));
  check_metric(Hde::Adaptive_normal_embedding());
}

// a number of faces: the sizes are proportions
void test_number_of_faces()
{
  Mesh mesh = icosphere(4);
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, Sphere_function{1}, params::sizing_field(size_of_point).number_of_target_faces(3000));
  CHECK(std::abs(double(mesh.number_of_faces()) - 3000) < 60);
  check_lengths(mesh, size_of_point, result.target_edge_length);
}

// The limit is the largest sizes that are not above the given ones and grow by no more than asked along edges.
void test_limit_of_gradation()
{
  const Mesh mesh = icosphere(2);
  std::vector<Hde::internal::Vector> points;
  for (const Vertex v : mesh.vertices())
    points.push_back(Hde::internal::Vector(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  std::vector<Hde::internal::Facet> facets;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    facets.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  for (const double gradation : {0.01, 0.3, 10.})
  {
    std::vector<double> given;
    for (std::size_t i = 0; i < points.size(); ++i)
      given.push_back(0.1 + 0.9 * std::fmod(0.6180339887 * double(i), 1.));
    std::vector<double> limited = given, slow = given;
    Hde::internal::limit_gradation(limited, points, facets, gradation);
    for (bool is_changed = true; is_changed;)
    {
      is_changed = false;
      for (const auto& f : facets)
        for (std::size_t k = 0; k < 3; ++k)
          for (const auto& edge : {std::make_pair(f[k], f[(k + 1) % 3]), std::make_pair(f[(k + 1) % 3], f[k])})
          {
            const double largest = slow[edge.first] + gradation * (points[edge.second] - points[edge.first]).norm();
            is_changed = is_changed || slow[edge.second] > largest;
            slow[edge.second] = (std::min)(slow[edge.second], largest);
          }
    }
    CHECK(limited == slow);
    CHECK((limited == given) == (gradation > 5));
  }
}

// A field with a jump: with a gradation, sizes grow gradually from the small ones, whichever kind it is.
void test_gradation()
{
  const double gradation = 0.25, small = 0.05, large = 0.4;
  const auto jump = [=](const Point_3& p) { return p.z() < -0.8 ? small : large; };
  // the way from the cap, along the sphere; the edges of the input are up to 0.08 long
  const auto allowed = [=](const Point_3& p)
  {
    const double way =
        std::acos(-0.8) - std::acos((std::min)((std::max)(p.z() / std::sqrt((p - CGAL::ORIGIN).squared_length()), -1.), 1.));
    return (std::min)(large, small + gradation * 1.15 * (std::max)(way + 0.1, 0.));
  };
  const auto number_of_large_edges = [&](const Mesh& mesh)
  {
    std::size_t number = 0;
    for (const auto e : mesh.edges())
    {
      const Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
      number += std::sqrt(CGAL::squared_distance(p, q)) > 1.45 * allowed(CGAL::midpoint(p, q)) ? 1 : 0;
    }
    return number;
  };
  const auto remesh = [&](const auto& np)
  {
    Mesh mesh = icosphere(5);
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1}, np);
    return mesh;
  };
  Mesh input = icosphere(5);
  std::map<Vertex, double> sizes;
  for (const Vertex v : input.vertices())
    sizes[v] = jump(input.point(v));
  const boost::associative_property_map<std::map<Vertex, double>> map(sizes);
  const std::size_t without = number_of_large_edges(remesh(params::sizing_field(jump)));
  const Mesh by_function = remesh(params::sizing_field(jump).gradation(gradation)),
             by_map = remesh(params::gradation(gradation).sizing_field(map));
  std::cout << "edges that are too long: " << without << " without gradation, " << number_of_large_edges(by_function) << " of "
            << by_function.number_of_edges() << " with it, " << number_of_large_edges(by_map) << " of sizes at vertices"
            << std::endl;
  CHECK(without > 30);
  CHECK(number_of_large_edges(by_function) < 5);
  CHECK(number_of_large_edges(by_map) < 5);
  CHECK(Hde::measure_shape(by_function).aspect_ratio_max < 3);
}

template <typename NamedParameters>
void check_refused(const std::string& text, const NamedParameters& np)
{
  Mesh mesh = icosphere(2);
  const std::string message =
      invalid_argument_message([&] { CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1}, np); });
  if (!CHECK(contains(message, text)))
    std::cout << "  the message is: " << message << std::endl;
  CHECK(remeshing_checks::digest(mesh) == remeshing_checks::digest(icosphere(2)));
}

void test_bad_sizes()
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::pair<double, std::string> bad :
       {std::make_pair(0., " is 0"), std::make_pair(-2.5, " is -2.5"), std::make_pair(infinity, " is inf"),
        std::make_pair(std::numeric_limits<double>::quiet_NaN(), " is ")})
  {
    const auto size = [=](const Point_3& p) { return p.z() > 0.5 ? bad.first : 0.3; };
    check_refused("sizing field" + bad.second, params::sizing_field(size));
    check_refused("sizing field" + bad.second, params::sizing_field(size).gradation(0.3));
    check_refused("sizing field" + bad.second, params::sizing_field(size).embedding(Hde::Curvature_metric(2)));
    const Mesh mesh = icosphere(2);
    std::map<Vertex, double> sizes;
    for (const Vertex v : mesh.vertices())
      sizes[v] = size(mesh.point(v));
    check_refused("sizing field" + bad.second,
                  params::sizing_field(boost::associative_property_map<std::map<Vertex, double>>(sizes)));
  }
  for (const std::pair<double, std::string> bad : {std::make_pair(0., "gradation is 0"), std::make_pair(-1., "gradation is -1"),
                                                   std::make_pair(infinity, "gradation is inf")})
    check_refused(bad.second, params::sizing_field(size_of_point).gradation(bad.first));
  check_refused("sizing_field", params::sizing_field([](const Point_3&) { return 1e-9; })); // too many faces
}

void test_fields_of_cgal()
{
#ifdef HAS_SIZING_FIELDS_OF_CGAL
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh = icosphere(4);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1},
                                       params::sizing_field(PMP::Uniform_sizing_field<Mesh>(0.1, mesh)));
  check_lengths(
      mesh, [](const Point_3&) { return 0.1; }, 1);

  // on a sphere it has one size, too
  const double tolerance = 1e-3;
  mesh = icosphere(4);
  const PMP::Adaptive_sizing_field<Mesh> adaptive(tolerance, std::make_pair(0.01, 1.), faces(mesh), mesh);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1}, params::sizing_field(adaptive));
  const double size = std::sqrt(6 * tolerance - 3 * tolerance * tolerance);
  check_lengths(
      mesh, [=](const Point_3&) { return size; }, 1);
#else
  std::cout << "this CGAL has no sizing fields" << std::endl;
#endif
}

int main()
{
  test_kinds();
  test_overloads();
  test_embeddings();
  test_number_of_faces();
  test_limit_of_gradation();
  test_gradation();
  test_bad_sizes();
  test_fields_of_cgal();
  return check_summary();
}
