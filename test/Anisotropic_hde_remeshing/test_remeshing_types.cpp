// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Mesh and kernel types: every combination compiles, gives a valid mesh on the surface, and the same one, as far as the types
// hold the same numbers.

#include "remeshing_checks.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Cartesian;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;

// as the mesh of the kernel of the other tests, to compare and to measure
template <typename TriangleMesh, typename PointMap>
Mesh to_plain_mesh(const TriangleMesh& mesh, const PointMap points)
{
  Soup soup;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::size_t> indices;
  for (const auto v : vertices(mesh))
  {
    indices.emplace(v, soup.points.size());
    const auto& p = get(points, v);
    soup.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  for (const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    soup.triangles.push_back(
        {indices.at(source(h, mesh)), indices.at(target(h, mesh)), indices.at(target(next(h, mesh), mesh))});
  }
  return to_mesh(soup);
}

template <typename TriangleMesh>
TriangleMesh input()
{
  TriangleMesh mesh;
  const Soup soup = scaled(icosphere_soup(2), 1, 2, 5);
  typedef
      typename boost::property_traits<typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type>::value_type Point;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> descriptors;
  for (const Point_3& p : soup.points)
  {
    descriptors.push_back(add_vertex(mesh));
    put(CGAL::vertex_point, mesh, descriptors.back(), Point(p.x(), p.y(), p.z()));
  }
  for (const auto& t : soup.triangles)
    CGAL::Euler::add_face(
        std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 3>{
            {descriptors[t[0]], descriptors[t[1]], descriptors[t[2]]}},
        mesh);
  return mesh;
}

// the soup of the result does not depend on the type
// that of the instantiations that all tests share; other tags are a matter of test_determinism
typedef CGAL::Parallel_if_available_tag Tag;

template <typename TriangleMesh>
void test_type(const std::string& name, std::uint64_t& expected)
{
  TriangleMesh mesh = input<TriangleMesh>();
  const Mesh before = to_plain_mesh(mesh, get(CGAL::vertex_point, mesh));
  const auto result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::relative_sigma(0.05).number_of_target_faces(1000));
  CHECK(result.number_of_iterations == 10);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  const Mesh after = to_plain_mesh(mesh, get(CGAL::vertex_point, mesh));
  check_validity(name, before, after, CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag>(before));
  check_number_of_faces(after, 1000);
  if (expected == 0)
    expected = digest(after);
  CHECK(digest(after) == expected);
}

// a face graph whose points are the caller's own
template <typename TriangleMesh>
void test_external_points(const std::string& name, const std::uint64_t expected)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
  TriangleMesh mesh = input<TriangleMesh>();
  std::map<Vertex, Cartesian::Point_3> points;
  for (const auto v : vertices(mesh))
  {
    const auto& p = get(CGAL::vertex_point, mesh, v);
    points.emplace(v, Cartesian::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  }
  const boost::associative_property_map<std::map<Vertex, Cartesian::Point_3>> point_map(points);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh,
                                       params::relative_sigma(0.05).number_of_target_faces(1000).vertex_point_map(point_map));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  std::cout << name << std::endl;
  CHECK(digest(to_plain_mesh(mesh, point_map)) == expected);
}

// an own function on a mesh with exact points
void test_own_function_with_exact_points()
{
  typedef CGAL::Surface_mesh<Epeck::Point_3> Exact_mesh;
  Exact_mesh mesh = input<Exact_mesh>();
  const Mesh before = to_plain_mesh(mesh, mesh.points());
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::number_of_target_faces(700));
  check_validity("own function, exact points", before, to_plain_mesh(mesh, mesh.points()), Ellipsoid_function());
}

int main()
{
  std::uint64_t expected = 0;
  test_type<CGAL::Surface_mesh<Epick::Point_3>>("Surface_mesh, EPICK", expected);
  test_type<CGAL::Surface_mesh<Cartesian::Point_3>>("Surface_mesh, Simple_cartesian", expected);
  test_type<CGAL::Surface_mesh<Epeck::Point_3>>("Surface_mesh, EPECK", expected);
  test_type<CGAL::Polyhedron_3<Epick>>("Polyhedron_3, EPICK", expected);
  test_type<CGAL::Polyhedron_3<Cartesian, CGAL::Polyhedron_items_with_id_3>>("Polyhedron_3 with ids, Simple_cartesian",
                                                                             expected);
  test_type<CGAL::Polyhedron_3<Epeck>>("Polyhedron_3, EPECK", expected);
  test_external_points<CGAL::Surface_mesh<Epick::Point_3>>("Surface_mesh, external points", expected);
  test_external_points<CGAL::Polyhedron_3<Epick>>("Polyhedron_3, external points", expected);
  test_own_function_with_exact_points();
  return check_summary();
}
