// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The quality measures on shapes whose figures are known.

#include "check.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

// the signed distance to a sphere about the origin
struct Sphere_function
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return std::sqrt((p - CGAL::ORIGIN).squared_length()) - radius; }
  Vector_3 gradient(const Point_3& p) const
  {
    const Vector_3 v = p - CGAL::ORIGIN;
    return v / std::sqrt(v.squared_length());
  }

  double radius;
};

// the plane z = 0, with a gradient that is no unit vector, in one call for both
struct Plane_function
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return 4 * p.z(); }
  Vector_3 gradient(const Point_3&) const { return Vector_3(0, 0, 4); }
  std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const { return {(*this)(p), gradient(p)}; }
};

Mesh triangle(const Point_3& p, const Point_3& q, const Point_3& r)
{
  Mesh mesh;
  CGAL::make_triangle(p, q, r, mesh);
  return mesh;
}

// a triangulation of the unit sphere about the origin: the icosahedron, after some subdivisions
Mesh icosphere(const unsigned int level)
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(level));
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Vector_3 from_centre = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + from_centre / std::sqrt(from_centre.squared_length());
  }
  return mesh;
}

// a square grid of n by n cells of side 1 / n at a height
template <typename SomeMesh>
SomeMesh grid(const int n, const double height)
{
  typedef typename boost::property_traits<typename boost::property_map<SomeMesh, CGAL::vertex_point_t>::type>::value_type P;
  SomeMesh mesh;
  CGAL::make_grid(
      n, n, mesh,
      [=](std::size_t i, std::size_t j) { return P(static_cast<double>(i) / n, static_cast<double>(j) / n, height); }, true);
  return mesh;
}

// the message of the exception; empty if none is thrown
template <typename Call>
std::string message_of(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return std::string();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void test_aspect_ratio()
{
  CHECK_CLOSE(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, std::sqrt(0.75), 0)), 1, 1e-15);
  // right isosceles: R = sqrt(2) / 2, r = 1 - sqrt(2) / 2
  const double right_isosceles = std::sqrt(2.) / (4 - 2 * std::sqrt(2.));
  CHECK_CLOSE(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)), right_isosceles, 1e-15);
  CHECK_CLOSE(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(0, 0, 4)), 1.25, 1e-15); // R 2.5, r 1
  CHECK_CLOSE(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(3e-160, 0, 0), Point_3(0, 0, 4e-160)), 1.25, 1e-12);
  CHECK_CLOSE(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(3e150, 0, 0), Point_3(0, 0, 4e150)), 1.25, 1e-12);
  CHECK(std::isinf(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(0.1, 0.1, 0.1), Point_3(0.7, 0.7, 0.7))));
  CHECK(std::isinf(Hde::aspect_ratio(Point_3(1, 2, 3), Point_3(1, 2, 3), Point_3(1, 2, 3))));
  typedef CGAL::Exact_predicates_exact_constructions_kernel::Point_3 Exact_point;
  CHECK_CLOSE(Hde::aspect_ratio(Exact_point(0, 0, 0), Exact_point(3, 0, 0), Exact_point(0, 0, 4)), 1.25, 1e-15);
  // a needle: q = a^2 / (8 h^2) or so, with no digit lost
  CHECK_CLOSE(Hde::aspect_ratio(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 1e-9, 0)) / (1 / 8e-18), 1, 1e-8);
}

void test_shape()
{
  Mesh mesh = triangle(Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(0, 4, 0));
  Hde::Shape_measures shape = Hde::measure_shape(mesh);
  CHECK_CLOSE(shape.aspect_ratio_mean, 1.25, 1e-14);
  CHECK_CLOSE(shape.aspect_ratio_p99, 1.25, 1e-14);
  CHECK_CLOSE(shape.aspect_ratio_max, 1.25, 1e-14);
  CHECK(shape.number_of_degenerate_faces == 0);

  // beside it a face of three points on a line: the largest is infinite, the mean is not
  CGAL::make_triangle(Point_3(5, 0, 0), Point_3(6, 0, 0), Point_3(7, 0, 0), mesh);
  shape = Hde::measure_shape(mesh);
  CHECK(shape.number_of_degenerate_faces == 1);
  CHECK_CLOSE(shape.aspect_ratio_mean, 1.25, 1e-14);
  CHECK(std::isinf(shape.aspect_ratio_max));

  // two faces on both sides of an edge, which fold over it from 143.13 degrees on, in any unit
  for (const double unit : {1e-300, 1., 1e300})
    for (const double degrees : {0., 90., 143., 143.3, 179.})
    {
      const double turn = degrees * CGAL_PI / 180;
      Mesh book;
      const auto add = [&](const double x, const double y, const double z)
      { return book.add_vertex(Point_3(unit * x, unit * y, unit * z)); };
      const auto a = add(0, 0, 0), b = add(1, 0, 0), c = add(0.5, 1, 0), d = add(0.5, -std::cos(turn), std::sin(turn));
      book.add_face(a, b, c);
      book.add_face(b, a, d);
      CHECK(Hde::measure_shape(book).number_of_folded_edges == std::size_t(degrees > 143.2));
    }

  CHECK_CLOSE(Hde::measure_shape(icosphere(0)).aspect_ratio_max, 1, 1e-14);
  CHECK_CLOSE(Hde::measure_shape(grid<Mesh>(20, 0)).aspect_ratio_p99, std::sqrt(2.) / (4 - 2 * std::sqrt(2.)), 1e-12);
  CHECK(Hde::measure_shape(Mesh()).aspect_ratio_max == 0);
}

void test_topology()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), mesh);
  Hde::Topology_measures topology = Hde::measure_topology(mesh);
  CHECK(topology.number_of_vertices == 4 && topology.number_of_edges == 6 && topology.number_of_faces == 4);
  CHECK(topology.euler_characteristic == 2 && topology.number_of_components == 1);
  CHECK(topology.number_of_boundary_loops == 0 && topology.number_of_boundary_edges == 0);
  CHECK(topology.valence_6_share == 0 && topology.number_of_interior_vertices == 4);

  // a second component with a boundary, a vertex without a face, and a gap among the indices
  mesh.add_vertex(Point_3(9, 9, 9));
  CGAL::make_triangle(Point_3(5, 0, 0), Point_3(6, 0, 0), Point_3(6, 1, 0), mesh);
  const auto removed = CGAL::make_triangle(Point_3(5, 0, 0), Point_3(6, 0, 0), Point_3(6, 1, 0), mesh);
  CGAL::Euler::remove_face(removed, mesh);
  CGAL::make_triangle(Point_3(7, 0, 0), Point_3(8, 0, 0), Point_3(8, 1, 0), mesh);
  topology = Hde::measure_topology(mesh);
  CHECK(topology.number_of_vertices == 10 && topology.number_of_isolated_vertices == 1);
  CHECK(topology.number_of_components == 3 && topology.number_of_boundary_loops == 2);
  CHECK(topology.number_of_boundary_edges == 6 && topology.euler_characteristic == 4);
  CHECK(topology.number_of_interior_vertices == 4);

  topology = Hde::measure_topology(grid<Mesh>(10, 0));
  CHECK(topology.euler_characteristic == 1 && topology.number_of_boundary_loops == 1);
  CHECK(topology.number_of_interior_vertices == 81);
  CHECK_CLOSE(topology.valence_6_share, 1, 0);

  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  topology = Hde::measure_topology(grid<Polyhedron>(10, 0));
  CHECK(topology.number_of_faces == 200 && topology.number_of_boundary_loops == 1);
}

void test_embedding()
{
  // Flat: the normals do not differ and the lengths are those in space.
  const Plane_function plane{};
  Mesh mesh = triangle(Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(0, 4, 0));
  Hde::Embedding_measures measures = Hde::measure_embedding(mesh, plane, params::sigma(7.));
  CHECK_CLOSE(measures.edge_length_mean, std::cbrt(60.), 1e-14);
  CHECK_CLOSE(measures.target_edge_length, std::cbrt(60.), 1e-14);
  CHECK_CLOSE(measures.minimum_angle_least, std::atan2(3., 4.) * 180 / CGAL_PI, 1e-12);
  CHECK_CLOSE(measures.share_within_half, 1, 0);
  CHECK(measures.sigma == 7 && measures.number_of_folded_faces == 0);
  measures = Hde::measure_embedding(mesh, plane, params::sigma(7.).target_edge_length(5.5));
  CHECK_CLOSE(measures.share_within_half, 1, 0);            // [2.75, 8.25]
  CHECK_CLOSE(measures.share_within_sqrt_2, 2 / 3., 1e-15); // [3.85, 7.755]
  CHECK_CLOSE(Hde::measure_embedding(mesh, plane).sigma, 0.05, 1e-15);

  // Unit sphere: the normals are the points, every length is sqrt(1 + sigma^2) times that in space.
  const Mesh sphere = icosphere(3);
  const Sphere_function function{1};
  const double in_space = Hde::measure_embedding(sphere, function, params::sigma(0.)).edge_length_mean;
  measures = Hde::measure_embedding(sphere, function, params::sigma(2.));
  CHECK_CLOSE(measures.edge_length_mean, std::sqrt(5.) * in_space, 1e-13);
  CHECK(measures.number_of_folded_faces == 0);
  const Hde::Embedding_measures parallel =
      Hde::measure_embedding<CGAL::Parallel_if_available_tag>(sphere, function, params::sigma(2.));
  CHECK(parallel.edge_length_mean == measures.edge_length_mean);
  CHECK(parallel.minimum_angle_mean == measures.minimum_angle_mean);
  CHECK_CLOSE(Hde::measure_embedding(icosphere(0), function, params::sigma(2.)).minimum_angle_least, 60, 1e-10);
}

void test_folded_faces()
{
  const Plane_function plane{};
  Mesh mesh = grid<Mesh>(4, 0);
  const std::size_t front = Hde::measure_embedding(mesh, plane).number_of_folded_faces;
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  const std::size_t back = Hde::measure_embedding(mesh, plane).number_of_folded_faces;
  CHECK(front + back == 32 && front * back == 0);

  // A vertex carried to the other side of a neighbour turns over the faces between them.
  Mesh sphere = icosphere(2);
  const Sphere_function function{1};
  const Mesh::Halfedge_index h = *sphere.halfedges().begin();
  const Vector_3 step = sphere.point(sphere.target(h)) - sphere.point(sphere.source(h));
  sphere.point(sphere.source(h)) = sphere.point(sphere.target(h)) + 0.3 * step;
  CHECK(Hde::measure_embedding(sphere, function).number_of_folded_faces >= 1);

  // a degenerate face has no side to turn
  const Mesh flat = triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(2, 0, 0));
  CHECK(Hde::measure_embedding(flat, plane).number_of_folded_faces == 0);
  CHECK(Hde::measure_embedding(flat, plane).minimum_angle_least == 0);
}

void test_distance_to_zero_set()
{
  const Plane_function plane{};
  Hde::Zero_set_measures measures = Hde::measure_distance_to_zero_set(grid<Mesh>(10, 0.25), plane);
  CHECK_CLOSE(measures.face_rms, 0.25, 1e-15);
  CHECK_CLOSE(measures.face_max, 0.25, 1e-15);
  CHECK_CLOSE(measures.interior_vertex_max, 0.25, 1e-15);
  CHECK_CLOSE(measures.boundary_vertex_max, 0.25, 1e-15);
  CHECK(measures.number_of_samples == 200000);

  // A triangle that rises from 0 to 1: the mean of h^2 over the area is 1/6.
  measures = Hde::measure_distance_to_zero_set(triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 1)), plane);
  CHECK_CLOSE(measures.face_rms, std::sqrt(1 / 6.), 1e-4);
  CHECK(measures.face_max > 0.99 && measures.face_max < 1);
  CHECK(measures.interior_vertex_max == 0);
  CHECK_CLOSE(measures.boundary_vertex_max, 1, 0);

  // The vertices of the icosphere are on the sphere, its faces inside: by at most the height of the largest face.
  const Mesh sphere = icosphere(3);
  const Sphere_function function{1};
  measures = Hde::measure_distance_to_zero_set(sphere, function, params::number_of_points_on_faces(50000));
  CHECK(measures.interior_vertex_max < 1e-15 && measures.boundary_vertex_max == 0);
  CHECK(measures.number_of_samples == 50000);
  double height = 0;
  for (const Mesh::Face_index f : sphere.faces())
  {
    const auto h = sphere.halfedge(f);
    const Point_3 c = CGAL::centroid(sphere.point(sphere.source(h)), sphere.point(sphere.target(h)),
                                     sphere.point(sphere.target(sphere.next(h))));
    height = (std::max)(height, 1 - std::sqrt((c - CGAL::ORIGIN).squared_length()));
  }
  CHECK(measures.face_max <= height * 1.001 && measures.face_max > 0.95 * height);
  const Hde::Zero_set_measures parallel = Hde::measure_distance_to_zero_set<CGAL::Parallel_if_available_tag>(
      sphere, function, params::number_of_points_on_faces(50000));
  CHECK(parallel.face_rms == measures.face_rms && parallel.face_max == measures.face_max);
}

void test_distance()
{
  // parallel squares, the second twice as large: from the first everything is at 0.5, from the second its far corner
  const Mesh low = grid<Mesh>(8, 0);
  Mesh high = grid<Mesh>(3, 0.5);
  const auto samples = params::number_of_points_on_faces(20000);
  Hde::Distance_measures measures = Hde::measure_distance(low, high, samples);
  CHECK_CLOSE(measures.rms(), 0.5, 1e-12);
  CHECK_CLOSE(measures.max(), 0.5, 1e-12);
  for (const Mesh::Vertex_index v : high.vertices())
    high.point(v) = Point_3(2 * high.point(v).x(), 2 * high.point(v).y(), 0.5);
  measures = Hde::measure_distance(low, high, samples);
  CHECK_CLOSE(measures.rms_from_first, 0.5, 1e-12);
  CHECK_CLOSE(measures.max_from_first, 0.5, 1e-12);
  CHECK_CLOSE(measures.max_from_second, 1.5, 1e-12); // (1, 1, 0.5): one of the vertices
  CHECK_CLOSE(measures.max(), 1.5, 1e-12);
  // 1/4 + the mean of max(x - 1, 0)^2 + max(y - 1, 0)^2 over [0, 2]^2, which is 1/3
  CHECK_CLOSE(measures.rms_from_second, std::sqrt(0.25 + 1 / 3.), 2e-4);
  const Hde::Distance_measures parallel = Hde::measure_distance<CGAL::Parallel_if_available_tag>(low, high, samples);
  CHECK(parallel.rms_from_first == measures.rms_from_first && parallel.rms_from_second == measures.rms_from_second);
  CHECK(Hde::measure_distance(low, low, samples).max() < 1e-15);
}

// x^2 + y^2 / 4 + z^2 / 25 - 1: no distance, to first order wrong by far where its gradient is small
struct Ellipsoid_function
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return p.x() * p.x() + p.y() * p.y() / 4 + p.z() * p.z() / 25 - 1; }
  Vector_3 gradient(const Point_3& p) const { return Vector_3(2 * p.x(), p.y() / 2, 2 * p.z() / 25); }
};

// the distance by trying a million points of the ellipsoid, hence no more than 0.002 too large
double distance_by_trying(const Point_3& p)
{
  double least = std::numeric_limits<double>::infinity();
  const int n = 1000;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const double theta = 3.14159265358979323846 * i / n, phi = 2 * 3.14159265358979323846 * j / n;
      const Point_3 q(std::sin(theta) * std::cos(phi), 2 * std::sin(theta) * std::sin(phi), 5 * std::cos(theta));
      least = (std::min)(least, CGAL::squared_distance(p, q));
    }
  return std::sqrt(least);
}

void test_true_distance()
{
  const Ellipsoid_function ellipsoid;
  const auto distance = Hde::internal::zero_set_distance(ellipsoid, 11.);
  for (const Point_3& p : {Point_3(0.6, 0, 0), Point_3(0.5, 1, 1), Point_3(0.9, 0.2, -2), Point_3(0.2, 0.1, 4.9),
                           Point_3(1, 2, 5), Point_3(-1, 0.5, 3), Point_3(0.6, 1.2, 1.4), Point_3(-2, 3, 4)})
  {
    const double found = distance(Hde::internal::Vector(p.x(), p.y(), p.z())), expected = distance_by_trying(p);
    CHECK(found <= expected * (1 + 1e-4));
    CHECK(found >= expected - 0.002 - 1e-4);
  }
  CHECK(std::isinf(distance(Hde::internal::Vector(0, 0, 0)))); // no way leads from here
  const Hde::internal::Vector corner(0, 2, 0);
  CHECK_CLOSE(distance(Hde::internal::Vector(0, 0, 0), corner, 0), 2, 1e-12); // but that to a neighbour

  // A triangle of points of the equator through the centre: to first order the largest distance has no bound. Its points are
  // 1 - r from the sphere, r their distance from the centre.
  struct Squared : Ellipsoid_function
  {
    FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
    Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
  };
  const double h = std::sqrt(0.75);
  const Point_3 a(1, 0, 0), b(-0.5, h, 0), c(-0.5, -h, 0);
  const Hde::Zero_set_measures measures = Hde::measure_distance_to_zero_set(triangle(a, b, c), Squared());
  double mean_square = 0, number = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j, ++number)
    {
      const double u = (i + 1. / 3) / n, v = (j + 1. / 3) / n;
      const double r = std::sqrt(((a + u * (b - a) + v * (c - a)) - CGAL::ORIGIN).squared_length());
      mean_square += (1 - r) * (1 - r);
    }
  CHECK_CLOSE(measures.face_rms, std::sqrt(mean_square / number), 0.01);
  CHECK(measures.face_max > 0.99 && measures.face_max <= 1);
  CHECK(measures.boundary_vertex_max < 1e-15);
}

void test_invalid_parameters()
{
  using namespace CGAL::Anisotropic_hde_remeshing::parameters;
  const Mesh mesh = icosphere(1);
  const double nan_value = std::nan("");
  for (const double bad : {-1., nan_value})
  {
    CHECK(contains(message_of([&] { Hde::measure_embedding(mesh, Sphere_function{1}, sigma(bad)); }), "sigma is"));
    CHECK(contains(message_of([&] { Hde::measure_embedding(mesh, Sphere_function{1}, target_edge_length(bad)); }),
                   "target_edge_length is"));
    CHECK(contains(message_of([&] { Hde::measure_distance(mesh, mesh, number_of_points_on_faces(bad)); }),
                   "number_of_points_on_faces is"));
  }
  CHECK(contains(message_of([&] { Hde::measure_distance_to_zero_set(mesh, Sphere_function{1}, number_of_points_on_faces(0)); }),
                 "number_of_points_on_faces is 0"));
}

void test_invalid_meshes()
{
  Mesh quadrangle;
  const Mesh::Vertex_index a = quadrangle.add_vertex(Point_3(0, 0, 0)), b = quadrangle.add_vertex(Point_3(1, 0, 0)),
                           c = quadrangle.add_vertex(Point_3(1, 1, 0)), d = quadrangle.add_vertex(Point_3(0, 1, 0));
  quadrangle.add_face(a, b, c, d);
  Mesh not_finite = icosphere(1);
  not_finite.point(Mesh::Vertex_index(7)) = Point_3(0, std::nan(""), 0);
  const auto check = [](const Mesh& mesh, const char* message)
  {
    CHECK(contains(message_of([&] { Hde::measure_topology(mesh); }), message));
    CHECK(contains(message_of([&] { Hde::measure_shape(mesh); }), message));
    CHECK(contains(message_of([&] { Hde::measure_embedding(mesh, Sphere_function{1}); }), message));
    CHECK(contains(message_of([&] { Hde::measure_distance_to_zero_set(mesh, Sphere_function{1}); }), message));
    CHECK(contains(message_of([&] { Hde::measure_distance(mesh, icosphere(1)); }), message));
    CHECK(contains(message_of([&] { Hde::measure_distance(icosphere(1), mesh); }), message));
  };
  check(quadrangle, "face 0 is not a triangle");
  check(not_finite, "the point of vertex 7 is");
}

int main()
{
  test_invalid_meshes();
  test_aspect_ratio();
  test_shape();
  test_topology();
  test_embedding();
  test_folded_faces();
  test_distance_to_zero_set();
  test_distance();
  test_true_distance();
  test_invalid_parameters();
  return check_summary();
}
