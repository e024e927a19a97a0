// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The same mesh, bit by bit: from run to run, for any number of threads, whatever class holds the mesh.

#include "remeshing_checks.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// the bits of values and gradients near the mesh
template <typename Function>
std::vector<double> values(const Function& function, const Mesh& mesh)
{
  std::vector<double> result;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const auto at_p = function.value_and_gradient(CGAL::midpoint(mesh.point(v), mesh.point(Mesh::Vertex_index(0))));
    result.insert(result.end(), {at_p.first, at_p.second.x(), at_p.second.y(), at_p.second.z()});
  }
  return result;
}

// the function is built and the mesh remeshed with the same tag
template <typename Tag>
std::uint64_t digest_of_rbf_remeshing(const Mesh& input, const double sigma, const std::size_t number_of_faces,
                                      std::vector<double>& function_values)
{
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(input);
  function_values = values(function, input);
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, function, params::sigma(sigma * bounding_box_diagonal(input)).number_of_target_faces(number_of_faces));
  return digest(mesh);
}

void test_threads(const std::string& name, const Mesh& input, const double sigma, const std::size_t number_of_faces)
{
  std::vector<double> expected_values, function_values;
  const std::uint64_t expected = digest_of_rbf_remeshing<CGAL::Sequential_tag>(input, sigma, number_of_faces, expected_values);
  std::cout << name << ": " << std::hex << expected << std::dec << std::endl;
  CHECK(digest_of_rbf_remeshing<CGAL::Sequential_tag>(input, sigma, number_of_faces, function_values) == expected);
  CHECK(function_values == expected_values);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t number_of_threads : {1, 3, 8})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    CHECK(digest_of_rbf_remeshing<CGAL::Parallel_tag>(input, sigma, number_of_faces, function_values) == expected);
    CHECK(function_values == expected_values);
  }
#endif
  // another request must give another mesh, or the digest shows nothing
  CHECK(digest_of_rbf_remeshing<CGAL::Sequential_tag>(input, 1.01 * sigma, number_of_faces, function_values) != expected);
}

// constrained edges, fixed vertices and a range of faces; garbage is not part of the digest
template <typename Tag>
std::uint64_t digest_with_constraints(const Mesh& input)
{
  Mesh mesh = input;
  std::vector<Mesh::Face_index> range;
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  auto is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_constrained", false).first;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Point_3& p = mesh.point(mesh.target(mesh.halfedge(f)));
    patch[f] = int(std::floor(20 * p.x()));
    if (p.y() > 0)
      range.push_back(f);
  }
  for (const Mesh::Vertex_index v : mesh.vertices())
    is_constrained[v] = int(v) % 97 == 0;
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(mesh);
  CGAL::anisotropic_hde_remeshing<Tag>(
      range, mesh, function,
      params::number_of_target_faces(9000).face_patch_map(patch).vertex_is_constrained_map(is_constrained));
  return digest(mesh);
}

void test_constraints(const Mesh& input)
{
  const std::uint64_t expected = digest_with_constraints<CGAL::Sequential_tag>(input);
  std::cout << "with constraints: " << std::hex << expected << std::dec << std::endl;
  CHECK(expected != digest(input));
  CHECK(digest_with_constraints<CGAL::Sequential_tag>(input) == expected);
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t number_of_threads : {1, 3, 8})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    CHECK(digest_with_constraints<CGAL::Parallel_tag>(input) == expected);
  }
#endif
}

Mesh scan(const std::string& name)
{
  Mesh mesh;
  CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh));
  return mesh;
}

void test_analytic_function()
{
  const auto digest_of = [](const auto tag)
  {
    Mesh mesh = torus(60, 20);
    CGAL::anisotropic_hde_remeshing<decltype(tag)>(mesh, Torus_function(), params::sigma(0.1).number_of_target_faces(6000));
    return digest(mesh);
  };
  CHECK(digest_of(CGAL::Sequential_tag()) == digest_of(CGAL::Parallel_if_available_tag()));
}

// sizes at vertices, and borders on the surface
void test_sizes_and_borders()
{
  const auto digest_of = [](const auto tag, const double gradation)
  {
    Mesh mesh = half_sphere(20);
    auto sizes = mesh.add_property_map<Mesh::Vertex_index, double>("v:size").first;
    for (const Mesh::Vertex_index v : mesh.vertices())
      sizes[v] = mesh.point(v).x() < 0 ? 0.03 : 0.1;
    CGAL::anisotropic_hde_remeshing<decltype(tag)>(mesh, Sphere_function(),
                                                   params::sizing_field(sizes).gradation(gradation).project_borders(true));
    return digest(mesh);
  };
  const std::uint64_t expected = digest_of(CGAL::Sequential_tag(), 0.3);
  CHECK(digest_of(CGAL::Parallel_if_available_tag(), 0.3) == expected);
  CHECK(digest_of(CGAL::Sequential_tag(), 0.31) != expected);
}

// Other mesh classes take the same way, given the same order of the elements, which a mesh built from the same soup has.
template <typename Function>
void test_polyhedron(const Soup& soup, const Function& function)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  Mesh mesh = to_mesh(soup);
  Polyhedron polyhedron = to_mesh<Polyhedron>(soup);
  if (!CHECK(digest(polyhedron) == digest(mesh)))
    return;
  const auto np = params::sigma(0.2).number_of_target_faces(2500);
  CGAL::anisotropic_hde_remeshing(mesh, function, np);
  CGAL::anisotropic_hde_remeshing(polyhedron, function, np);
  CHECK(CGAL::is_valid_polygon_mesh(polyhedron));
  CHECK(digest(polyhedron) == digest(mesh));
}

// the points of the caller may be anywhere; those that the mesh has of its own are left alone
void test_point_map()
{
  Mesh expected = ellipsoid(3);
  Mesh mesh = expected;
  auto positions = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:position").first;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    positions[v] = mesh.point(v);
    mesh.point(v) = Point_3(7, 7, 7);
  }
  const auto np = params::sigma(0.5).number_of_target_faces(1000);
  CGAL::anisotropic_hde_remeshing(expected, Ellipsoid_function(), np);
  CGAL::anisotropic_hde_remeshing(mesh, Ellipsoid_function(),
                                  params::sigma(0.5).number_of_target_faces(1000).vertex_point_map(positions));
  CHECK(mesh.number_of_vertices() == expected.number_of_vertices());
  bool is_same = true;
  for (const Mesh::Vertex_index v : expected.vertices())
    is_same = is_same && positions[v] == expected.point(v);
  CHECK(is_same);
  for (const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = positions[v];
  CHECK(digest(mesh) == digest(expected));
}

// the call that builds the function itself gives what the two steps give
void test_one_call()
{
  Mesh mesh = ellipsoid(3), expected = mesh;
  const auto np = params::sigma(0.5).number_of_target_faces(2000).patch_overlap(2);
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, np);
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> function(expected, np);
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(expected, function, np);
  CHECK(digest(mesh) == digest(expected));
}

int main()
{
  test_threads("ellipsoid", ellipsoid(4), 0.15, 6000);
  test_threads("half sphere", half_sphere(20), 0.1, 4000);
  test_threads("elephant", scan("elephant.off"), 0.01, 8000);
  test_threads("lion head, with a boundary", scan("lion-head.off"), 0.01, 15000);
  test_constraints(scan("elephant.off"));
  test_analytic_function();
  test_sizes_and_borders();
  test_polyhedron(scaled(icosphere_soup(3), 1, 2, 5), Ellipsoid_function());
  test_polyhedron(half_sphere_soup(16), Sphere_function());
  test_point_map();
  test_one_call();
  return check_summary();
}
