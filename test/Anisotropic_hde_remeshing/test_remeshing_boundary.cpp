// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshing of surfaces with boundary: the new boundary lies on the old one, corners stay, so does the topology.

#include "polylines.h"
#include "remeshing_checks.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

Polyline boundary(const Mesh& mesh)
{
  Polyline result;
  for (const Mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.is_border(h))
      result.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return result;
}

// `sag`: how far, over the diagonal, chords of the length of the new edges may lie from the old boundary
void check_boundary(const Mesh& before, const Mesh& after, const double sag)
{
  const double diagonal = bounding_box_diagonal(before);
  const Polyline old_boundary = boundary(before), new_boundary = boundary(after);
  const double off = largest_distance(new_boundary, old_boundary) / diagonal,
               missed = largest_distance(old_boundary, new_boundary) / diagonal,
               ratio = length(new_boundary) / length(old_boundary);
  std::cout << "  boundary: " << new_boundary.size() << " edges, distance/D " << off << ", from the old one " << missed
            << ", length " << ratio << std::endl;
  CHECK(off <= 1e-12);
  CHECK(missed <= sag);
  CHECK(ratio <= 1 + 1e-9);
  CHECK(ratio > 0.98);
}

std::size_t number_of_edges_at(const Mesh& mesh, const Point_3& p)
{
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.point(v) == p)
      return mesh.is_border(v) ? mesh.degree(v) : 0;
  return 0;
}

template <typename Function>
Mesh remeshed(const std::string& name, const Mesh& input, const Function& function, const double sigma,
              const std::size_t number_of_faces, const double sag)
{
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, function, params::sigma(sigma * bounding_box_diagonal(input)).number_of_target_faces(number_of_faces));
  check_validity(name + ", sigma " + std::to_string(sigma) + " D", input, mesh, function);
  check_number_of_faces(mesh, number_of_faces);
  check_quality(mesh, function, result, bounds_for_grids());
  check_boundary(input, mesh, sag);
  return mesh;
}

void test_half_sphere()
{
  const Mesh input = half_sphere(24); // 3456 faces
  CHECK(Hde::measure_topology(input).number_of_boundary_loops == 1);
  for (const double sigma : {0., 0.02, 0.2})
    for (const std::size_t number_of_faces : {1000, 3456, 10000})
      remeshed("half sphere", input, Sphere_function(), sigma, number_of_faces, 3e-3);
}

void test_cylinder()
{
  const Mesh input = cylinder(80, 30, 2.5); // 4800 faces
  CHECK(Hde::measure_topology(input).number_of_boundary_loops == 2);
  for (const double sigma : {0.01, 0.1})
    for (const std::size_t number_of_faces : {1500, 8000})
      remeshed("cylinder", input, Cylinder_function(), sigma, number_of_faces, 3e-3);
}

void test_corners()
{
  const Mesh input = hills(40); // 3200 faces
  for (const double sigma : {0.01, 0.05})
    for (const std::size_t number_of_faces : {800, 3200, 8000})
    {
      const Mesh mesh = remeshed("hills", input, Hills_function(), sigma, number_of_faces, 3e-3);
      for (const double x : {0., 2.})
        for (const double y : {0., 2.})
          CHECK(number_of_edges_at(mesh, Point_3(x, y, Hills_function::height(x, y))) >= 2);
    }
}

// the whole, with a scan
void test_scan()
{
  Mesh input;
  if (!CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(CGAL::data_file_path("meshes/lion-head.off"), input)))
    return;
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(input);
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::number_of_target_faces(12000));
  check_validity("lion head", input, mesh, function);
  check_number_of_faces(mesh, 12000);
  check_quality(mesh, function, result);
  check_boundary(input, mesh, 3e-3);
}

// The smallest boundaries: a triangle has nothing but corners, a tetrahedron without a face nothing but boundary but for one
// vertex.
void test_tiny_meshes()
{
  Mesh triangle;
  CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), triangle);
  struct Plane_function : Hills_function
  {
    FT operator()(const Point_3& p) const { return p.z(); }
    Vector_3 gradient(const Point_3&) const { return Vector_3(0, 0, 1); }
  };
  for (const std::size_t number_of_faces : {1, 100})
  {
    Mesh mesh = triangle;
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Plane_function(), params::number_of_target_faces(number_of_faces));
    check_validity("triangle", triangle, mesh, Plane_function());
    check_boundary(triangle, mesh, 1e-12);
  }
  Mesh open_tetrahedron;
  CGAL::make_tetrahedron(Point_3(1, 1, 1), Point_3(-1, -1, 1), Point_3(-1, 1, -1), Point_3(1, -1, -1), open_tetrahedron);
  CGAL::Euler::remove_face(halfedge(*faces(open_tetrahedron).begin(), open_tetrahedron), open_tetrahedron);
  open_tetrahedron.collect_garbage();
  Mesh mesh = open_tetrahedron;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{std::sqrt(3.)}, params::number_of_target_faces(500));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(Hde::measure_topology(mesh).euler_characteristic == 1);
  check_boundary(open_tetrahedron, mesh, 1e-12);
}

int main()
{
  test_half_sphere();
  test_cylinder();
  test_corners();
  test_scan();
  test_tiny_meshes();
  return check_summary();
}
