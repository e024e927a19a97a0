// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The pieces of surfaces with sharp edges: planes are exact, cylinders and spheres close, also at and beyond their sharp edges.

#include "check.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#include <CGAL/Piecewise_rbf_implicit_function.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace shapes;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
using CGAL::Anisotropic_hde_remeshing::Piece_kind;
typedef CGAL::Piecewise_rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Regions;

Regions regions_of(Mesh& mesh, const double angle = 30)
{
  const Regions regions = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  const auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  CGAL::Anisotropic_hde_remeshing::detect_surface_regions(mesh, is_crease, regions, params::sharp_angle(angle));
  return regions;
}

// the largest value at the vertices of the faces of a piece
template <typename Piecewise>
double largest_value(const Mesh& mesh, const Regions regions, const Piecewise& function)
{
  double largest = 0;
  for (const Mesh::Face_index f : mesh.faces())
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      largest = (std::max)(largest, std::abs(function.piece(regions[f])(mesh.point(v))));
  return largest;
}

void test_planes()
{
  for (const unsigned int n : {1, 9})
    for (Mesh mesh : {cube(n), l_block(n)})
    {
      const Regions regions = regions_of(mesh);
      const Function function(mesh, regions);
      CHECK(function.number_of_pieces() == (mesh.number_of_faces() == 12 * n * n ? 6 : 8));
      CHECK(function.diagnostics().number_of_planes == function.number_of_pieces());
      CHECK(largest_value(mesh, regions, function) == 0);
      for (const Mesh::Face_index f : mesh.faces())
      {
        const auto h = mesh.halfedge(f);
        const Point_3 p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)), r = mesh.point(mesh.target(mesh.next(h)));
        const Vector_3 normal = CGAL::unit_normal(p, q, r), gradient = function.piece(regions[f]).gradient(r);
        CHECK((gradient - normal).squared_length() == 0);
        CHECK_CLOSE(function.piece(regions[f])(p + 3 * normal), 3, 1e-14);
      }
    }
  // in any position
  Mesh mesh = cube(6);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Point_3 p = mesh.point(v);
    mesh.point(v) =
        Point_3(10 + 2 * p.x() - p.y() + 2 * p.z(), 2 * p.x() + 2 * p.y() - p.z(), 20 - p.x() + 2 * p.y() + 2 * p.z());
  }
  const Regions regions = regions_of(mesh);
  const Function function(mesh, regions);
  CHECK(function.diagnostics().number_of_planes == 6);
  CHECK(largest_value(mesh, regions, function) <= 1e-14);
}

// The sides of a cylinder on the exact cylinder, also between the columns, at its ends and a little beyond. Normals are turned by at
// most half of what those of the facets are.
void test_cylinder(const unsigned int segments, const unsigned int rows, const double tolerance)
{
  Mesh mesh = capped_cylinder(segments, rows);
  const Regions regions = regions_of(mesh);
  const Function function(mesh, regions);
  CHECK(function.number_of_pieces() == 3);
  CHECK(function.diagnostics().number_of_planes == 2 && function.diagnostics().number_of_fields == 1);
  CHECK(function.diagnostics().patches_on_fallback == 0);
  CHECK(largest_value(mesh, regions, function) <= 1e-11);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Function::Piece& piece = function.piece(i);
    if (piece.kind() == Piece_kind::PLANE)
      continue;
    double largest = 0, turned = 0, wrong = 0;
    for (const double z : {-1.02, -1., -0.99, -0.5, 0., 0.7, 0.999, 1., 1.02})
      for (int k = 0; k < 997; ++k)
      {
        const double u = 2 * pi * k / 997, h = 1e-5;
        const Point_3 p(std::cos(u), std::sin(u), z);
        const auto at_p = piece.value_and_gradient(p);
        CHECK(at_p.first == piece(p) && at_p.second == piece.gradient(p));
        largest = (std::max)(largest, std::abs(at_p.first));
        turned = (std::max)(turned, (at_p.second - Vector_3(p.x(), p.y(), 0)).squared_length());
        for (const Vector_3& d : {Vector_3(h, 0, 0), Vector_3(0, h, 0), Vector_3(0, 0, h)})
          wrong = (std::max)(wrong, std::abs((piece(p + d) - piece(p - d)) / 2 - at_p.second * d) / h);
      }
    CHECK_CLOSE(largest, 0, tolerance);
    CHECK_CLOSE(std::sqrt(turned), 0, pi / segments / 2);
    CHECK_CLOSE(wrong, 0, 1e-6);
  }
}

// two patches of one sphere: each is the sphere on both sides of their border
void test_hemispheres()
{
  Mesh mesh = icosphere(4);
  const Regions regions = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  for (const Mesh::Face_index f : mesh.faces())
  {
    double z = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      z += mesh.point(v).z();
    regions[f] = z > 0 ? 0 : 1;
  }
  const Function function(mesh, regions, params::number_of_patches(60));
  CHECK(function.diagnostics().number_of_fields == 2 && function.diagnostics().number_of_patches >= 60);
  double largest = 0;
  for (const Point_3& p : spiral_points(5000))
    for (const std::size_t i : {0, 1})
      if ((i == 0 ? 1 : -1) * p.z() > -0.05)
        largest = (std::max)(largest, std::abs(function.piece(i)(p)));
  CHECK_CLOSE(largest, 0, 2e-3);
}

// small regions are their facets, which go on along their tangents; regions without an area are nothing
void test_small_regions()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(2, 0, 0)),
             c = mesh.add_vertex(Point_3(2, 1, 0.2)), d = mesh.add_vertex(Point_3(0, 1, 0.2)),
             e = mesh.add_vertex(Point_3(2, 2, 0)), f = mesh.add_vertex(Point_3(0, 2, 0)),
             g = mesh.add_vertex(Point_3(4, 0, 0)), h = mesh.add_vertex(Point_3(6, 0, 0));
  const Regions regions = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  for (const auto& face : {mesh.add_face(a, b, c), mesh.add_face(a, c, d), mesh.add_face(d, c, e), mesh.add_face(d, e, f)})
    regions[face] = 0;
  regions[mesh.add_face(b, g, h)] = 1;
  const Function function(mesh, regions);
  const auto& piece = function.piece(0);
  CHECK(piece.kind() == Piece_kind::CLOSEST_POINT && function.piece(1).kind() == Piece_kind::NONE);
  CHECK(function.piece(1)(Point_3(1, 2, 3)) == 1 && function.piece(1).gradient(Point_3(1, 2, 3)) == CGAL::NULL_VECTOR);
  CHECK(largest_value(mesh, regions, function) <= 1);
  CHECK_CLOSE(piece(Point_3(1, 0.5, 0.1)), 0, 1e-14);
  CHECK_CLOSE(piece(Point_3(1, -0.5, -0.1)), 0, 0.01); // beyond the boundary
  CHECK(piece(Point_3(1, 0.5, 0.3)) > 0 && piece(Point_3(1, 0.5, -0.3)) < 0);
  CHECK(piece(Point_3(1, -0.2, 0.3)) > 0 && piece(Point_3(1, -0.2, -0.3)) < 0);
}

// the same function for any number of threads, bit by bit
void test_threads()
{
  Mesh mesh = capped_cylinder(40, 60);
  const Regions regions = regions_of(mesh);
  for (const Mesh::Face_index f : mesh.faces()) // small regions, too
    if (regions[f] == 1)
      regions[f] = mesh.point(mesh.target(mesh.halfedge(f))).x() > 0 ? 3 : 1;
  const auto values = [&](const auto& function)
  {
    std::vector<double> result;
    for (std::size_t i = 0; i < function.number_of_pieces(); ++i)
      for (const Point_3& p : spiral_points(300))
        for (const double factor : {0.9, 1., 1.3})
        {
          const auto at_p = function.piece(i).value_and_gradient(CGAL::ORIGIN + factor * (p - CGAL::ORIGIN));
          result.insert(result.end(), {at_p.first, at_p.second.x(), at_p.second.y(), at_p.second.z()});
        }
    return result;
  };
  typedef CGAL::Piecewise_rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Sequential_tag> Sequential_function;
  const std::vector<double> expected = values(Sequential_function(mesh, regions));
  CHECK(values(Sequential_function(mesh, regions)) == expected);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t number_of_threads : {1, 2, 4})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    CHECK(values(Function(mesh, regions)) == expected);
  }
#endif
}

// asks from the calling thread only, and stops at the question of this number
struct Stopping_visitor : public CGAL::Anisotropic_hde_remeshing::Remeshing_visitor
{
  explicit Stopping_visitor(const int last) : last(last) {}

  bool go_further()
  {
    CHECK(std::this_thread::get_id() == owner);
    return ++*questions < last;
  }

  int last;
  std::thread::id owner = std::this_thread::get_id();
  std::shared_ptr<int> questions = std::make_shared<int>(0);
};

void test_visitor()
{
  typedef CGAL::Anisotropic_hde_remeshing::Interrupted Interrupted;
  Mesh many, large = icosphere(5);
  for (int i = 0; i < 300; ++i) // small regions
  {
    Mesh sphere = icosphere(2);
    for (const Mesh::Vertex_index v : sphere.vertices())
      sphere.point(v) = sphere.point(v) + Vector_3(3 * i, 0, 0);
    many += sphere;
  }
  for (Mesh* mesh : {&many, &large})
  {
    const Regions regions = regions_of(*mesh, 90);
    for (const int last : {1, 2, 5})
    {
      const Stopping_visitor visitor(last);
      CHECK_THROWS(Function(*mesh, regions, params::visitor(visitor)), Interrupted);
      CHECK(*visitor.questions == last);
    }
    const Stopping_visitor patient((std::numeric_limits<int>::max)());
    CHECK_NO_THROW(Function(*mesh, regions, params::visitor(patient)));
    CHECK(*patient.questions >= 5);
  }
}

void test_invalid_input()
{
  Mesh mesh = cube(2);
  const Regions regions = regions_of(mesh);
  const auto message = [&](const auto& np) { return invalid_argument_message([&] { Function f(mesh, regions, np); }); };
  CHECK(message(CGAL::parameters::default_values()).empty());
  CHECK(contains(message(params::number_of_patches(0)), "number_of_patches is 0"));
  CHECK(contains(message(params::patch_overlap(-1)), "patch_overlap is -1"));
  CHECK_THROWS(Function(mesh, regions).piece(0)(Point_3(0, 0, std::numeric_limits<double>::quiet_NaN())),
               std::invalid_argument);
  regions[Mesh::Face_index(5)] = 1000;
  CHECK(contains(message(CGAL::parameters::default_values()), "region is 1000"));
  regions[Mesh::Face_index(5)] = 8;
  CHECK(contains(message(CGAL::parameters::default_values()), "region 6 has none"));
  regions[Mesh::Face_index(5)] = 0;
  mesh.point(Mesh::Vertex_index(4)) = Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  CHECK(contains(message(CGAL::parameters::default_values()), "point of vertex 4"));
  CHECK_THROWS(Function(Mesh(), Regions()), std::invalid_argument);
}

int main()
{
  test_planes();
  test_cylinder(64, 100, 1e-4);
  test_cylinder(64, 20, 1e-4);
  // with few rows, half of the height of a side over its chord: the facets say no more
  for (const auto& [segments, rows] : {std::make_pair(64u, 1u), std::make_pair(32u, 2u), std::make_pair(24u, 1u)})
    test_cylinder(segments, rows, (1 - std::cos(pi / segments)) / 2);
  test_hemispheres();
  test_small_regions();
  test_threads();
  test_visitor();
  test_invalid_input();
  return check_summary();
}
