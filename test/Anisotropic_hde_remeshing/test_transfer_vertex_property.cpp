// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Where the vertices of the result come from, and what is carried to them.

#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/transfer_vertex_property.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;

// the identity, carried as points, is the closest point of the input, and nothing of the input is nearer
template <typename TriangleMesh, typename LocationMap>
void check_locations(const TriangleMesh& input, const TriangleMesh& mesh, const LocationMap locations)
{
  const auto foot = get(CGAL::dynamic_vertex_property_t<Point_3>(), mesh);
  Hde::transfer_vertex_property(input, get(CGAL::vertex_point, input), mesh, locations, foot);
  double farthest = 0, excess = 0, least_weight = 1, off_sum = 0;
  std::size_t k = 0;
  for (const auto v : vertices(mesh))
  {
    const Point_3 p = get(CGAL::vertex_point, mesh, v);
    const double distance = std::sqrt(CGAL::squared_distance(p, get(foot, v)));
    farthest = (std::max)(farthest, distance);
    const std::array<double, 3>& weights = get(locations, v).barycentric_coordinates;
    for (const double weight : weights)
      least_weight = (std::min)(least_weight, weight);
    off_sum = (std::max)(off_sum, std::abs(weights[0] + weights[1] + weights[2] - 1));
    if (k++ % 50 != 0)
      continue;
    double least = 1e300;
    for (const auto f : faces(input))
    {
      const auto h = halfedge(f, input);
      const Kernel::Triangle_3 triangle(get(CGAL::vertex_point, input, source(h, input)),
                                        get(CGAL::vertex_point, input, target(h, input)),
                                        get(CGAL::vertex_point, input, target(next(h, input), input)));
      least = (std::min)(least, std::sqrt(CGAL::squared_distance(p, triangle)));
    }
    excess = (std::max)(excess, distance - least);
  }
  std::cout << "largest distance of a vertex from where it comes from: " << farthest << std::endl;
  CHECK(farthest <= 5e-3 * bounding_box_diagonal(input)); // of the sag of the input's faces
  CHECK(excess <= 1e-12);
  CHECK(least_weight >= 0);
  CHECK(off_sum <= 1e-12);
}

void test_surface_mesh()
{
  const Mesh input = ellipsoid(4);
  for (const std::size_t number_of_faces : {1500, 12000})
  {
    Mesh mesh = input;
    auto locations = mesh.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
    CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, Ellipsoid_function(),
        params::relative_sigma(0.05).number_of_target_faces(number_of_faces).vertex_location_map(locations));
    check_locations(input, mesh, locations);
  }
}

void test_polyhedron()
{
  Polyhedron mesh = to_mesh<Polyhedron>(scaled(icosphere_soup(3), 1, 2, 5));
  const Polyhedron input = mesh; // copy_face_graph() would change the order of its elements
  const auto locations = get(CGAL::dynamic_vertex_property_t<Hde::Input_location>(), mesh);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                       params::number_of_target_faces(3000).vertex_location_map(locations));
  check_locations(input, mesh, locations);
}

// a range, in a mesh whose first faces are not in it
void test_face_range()
{
  const Mesh input = ellipsoid(3);
  Mesh mesh = input;
  std::vector<Mesh::Face_index> range;
  for (const Mesh::Face_index f : mesh.faces())
    if (mesh.point(mesh.target(mesh.halfedge(f))).z() > 0)
      range.push_back(f);
  auto locations = mesh.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
  CGAL::anisotropic_hde_remeshing<Tag>(range, mesh, Ellipsoid_function(),
                                       params::number_of_target_faces(3000).vertex_location_map(locations));
  double farthest = 0;
  std::size_t number_of_located = 0;
  const auto foot = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:foot").first;
  Hde::transfer_vertex_property(input, input.points(), mesh, locations, foot);
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.point(v).z() > 0.5)
    {
      farthest = (std::max)(farthest, std::sqrt(CGAL::squared_distance(mesh.point(v), foot[v])));
      ++number_of_located;
    }
  std::cout << "in a range: " << farthest << " of " << number_of_located << std::endl;
  CHECK(number_of_located > 500);
  CHECK(farthest < 0.1);
}

// --- vertices that are not touched ---

// a mesh with garbage before, between and behind its faces, and two isolated vertices
Mesh with_garbage_and_isolated_vertices()
{
  Mesh mesh = ellipsoid(3);
  for (const std::size_t i : {0, 100, 700})
    CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(i))), mesh);
  mesh.add_vertex(Point_3(9, 9, 9));
  mesh.add_vertex(Point_3(8, 8, 8));
  CHECK(mesh.has_garbage());
  return mesh;
}

// Every vertex that was there before comes from itself, and all others are near where they come from. Isolated vertices come from
// nowhere, and the transfer refuses them, before it writes anything.
template <typename Remesh>
void check_untouched_vertices(const std::string& name, const Remesh& remesh)
{
  Mesh mesh = with_garbage_and_isolated_vertices();
  const Mesh input = mesh;
  auto locations = mesh.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
  remesh(mesh, locations);
  std::vector<Mesh::Vertex_index> isolated;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    CHECK(locations[v].has_face() != mesh.is_isolated(v));
    if (mesh.is_isolated(v))
      isolated.push_back(v);
  }
  CHECK(isolated.size() == 2);

  const Point_3 unwritten(7, 7, 7);
  auto foot = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:foot", unwritten).first;
  const auto transfer = [&] { Hde::transfer_vertex_property(input, input.points(), mesh, locations, foot); };
  CHECK(contains(invalid_argument_message(transfer), "has no location"));
  CHECK(std::all_of(mesh.vertices().begin(), mesh.vertices().end(),
                    [&](const Mesh::Vertex_index v) { return foot[v] == unwritten; }));
  for (const Mesh::Vertex_index v : isolated)
    mesh.remove_vertex(v);
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK_NO_THROW(transfer());
  std::size_t number_of_same = 0, number_of_wrong = 0;
  double farthest = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const bool was_there = input.has_valid_index(v) && !input.is_removed(v) && input.point(v) == mesh.point(v);
    number_of_same += was_there ? 1 : 0;
    number_of_wrong += was_there && foot[v] != mesh.point(v) ? 1 : 0;
    farthest = (std::max)(farthest, std::sqrt(CGAL::squared_distance(mesh.point(v), foot[v])));
  }
  std::cout << name << ": " << number_of_same << " vertices of " << mesh.number_of_vertices() << " stay, the farthest is at "
            << farthest << std::endl;
  CHECK(number_of_same > 100);
  CHECK(number_of_wrong == 0);
  CHECK(farthest < 0.1);
}

std::vector<Mesh::Face_index> upper_faces(const Mesh& mesh)
{
  std::vector<Mesh::Face_index> range;
  for (const Mesh::Face_index f : mesh.faces())
    if (mesh.point(mesh.target(mesh.halfedge(f))).z() > 0)
      range.push_back(f);
  return range;
}

struct Stop_at_once : Hde::Remeshing_visitor
{
  bool go_further() { return false; }
};

void test_untouched_vertices()
{
  typedef Mesh::Property_map<Mesh::Vertex_index, Hde::Input_location> Locations;
  const auto np = params::number_of_target_faces(3000);
  check_untouched_vertices("a range",
                           [&](Mesh& mesh, const Locations& locations) {
                             CGAL::anisotropic_hde_remeshing<Tag>(upper_faces(mesh), mesh, Ellipsoid_function(),
                                                                  np.vertex_location_map(locations));
                           });
  check_untouched_vertices("a range by measured error",
                           [](Mesh& mesh, const Locations& locations)
                           {
                             CGAL::anisotropic_hde_remeshing<Tag>(
                                 upper_faces(mesh), mesh, params::number_of_target_faces(300).vertex_location_map(locations));
                           });
  check_untouched_vertices(
      "constrained vertices",
      [&](Mesh& mesh, const Locations& locations)
      {
        auto is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:constrained", false).first;
        for (const Mesh::Vertex_index v : mesh.vertices())
          is_constrained[v] = std::size_t(v) % 4 == 0;
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                             np.vertex_is_constrained_map(is_constrained).vertex_location_map(locations));
      });
  check_untouched_vertices("no faces",
                           [&](Mesh& mesh, const Locations& locations)
                           {
                             const std::vector<Mesh::Face_index> none;
                             CGAL::anisotropic_hde_remeshing<Tag>(none, mesh, Ellipsoid_function(),
                                                                  np.vertex_location_map(locations));
                           });
  check_untouched_vertices("stopped",
                           [&](Mesh& mesh, const Locations& locations)
                           {
                             CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                                                  np.visitor(Stop_at_once()).vertex_location_map(locations));
                           });
}

// Two sheets at the same place: a fixed vertex comes from its own sheet. The other one comes first.
void test_touching_sheets()
{
  Soup soup = icosphere_soup(2);
  const std::size_t n = soup.points.size(), m = soup.triangles.size();
  for (std::size_t i = 0; i < n; ++i)
    soup.points.push_back(soup.points[i]);
  for (std::size_t k = 0; k < m; ++k)
    soup.triangles.push_back({soup.triangles[k][0] + n, soup.triangles[k][1] + n, soup.triangles[k][2] + n});
  Mesh mesh = to_mesh(soup);
  auto locations = mesh.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
  auto all = mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed", true).first;
  Mesh input = mesh;
  auto sheet = input.add_property_map<Mesh::Vertex_index, int>("v:sheet", 0).first;
  for (const Mesh::Vertex_index v : input.vertices())
    sheet[v] = std::size_t(v) < n ? 0 : 1;
  CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, Sphere_function(), params::number_of_iterations(1).vertex_is_constrained_map(all).vertex_location_map(locations));
  auto carried = mesh.add_property_map<Mesh::Vertex_index, int>("v:carried", 9).first;
  Hde::transfer_vertex_property(input, sheet, mesh, locations, carried);
  std::size_t number_of_wrong = 0;
  for (std::size_t i = 0; i < 2 * n; ++i)
  {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
    number_of_wrong += carried[v] != (i < n ? 0 : 1) ? 1 : 0;
  }
  CHECK(number_of_wrong == 0);
}

// every kind of values
void test_values()
{
  const Hde::Linear_interpolation interpolate;
  const std::array<double, 3> weights{{0.5, 0.25, 0.25}};
  CHECK(interpolate(std::array<double, 3>{{1, 2, 4}}, weights) == 2);
  CHECK(interpolate(std::array<float, 3>{{1, 2, 4}}, weights) == 2);
  CHECK(interpolate(std::array<int, 3>{{-1, -2, -5}}, weights) == -2);
  CHECK(interpolate(std::array<unsigned char, 3>{{255, 255, 253}}, weights) == 255); // 254.5
  CHECK(interpolate(std::array<bool, 3>{{true, false, false}}, {{0.6, 0.3, 0.1}}));
  CHECK(!interpolate(std::array<bool, 3>{{true, false, false}}, {{0.4, 0.3, 0.3}}));
  const double infinity = std::numeric_limits<double>::infinity(); // of weight 1, it is the mean, whatever the others are
  CHECK(interpolate(std::array<double, 3>{{infinity, 0.1, infinity}}, {{0, 1, 0}}) == 0.1);
  const long long large = (1ll << 60) + 1; // not a double
  CHECK(interpolate(std::array<long long, 3>{{0, 1, large}}, {{0, 0, 1}}) == large);
  CHECK(interpolate(std::array<Vector_3, 3>{{Vector_3(2, 0, 0), Vector_3(0, 4, 0), Vector_3(0, 0, 4)}}, weights) ==
        Vector_3(1, 1, 1));
  CHECK(interpolate(std::array<Point_3, 3>{{Point_3(2, 0, 0), Point_3(0, 4, 0), Point_3(0, 0, 4)}}, weights) ==
        Point_3(1, 1, 1));
  CHECK(interpolate(std::array<Kernel::Point_2, 3>{{Kernel::Point_2(2, 0), Kernel::Point_2(0, 4), Kernel::Point_2(0, 0)}},
                    weights) == Kernel::Point_2(1, 1));
  typedef std::array<double, 2> Uv;
  CHECK(interpolate(std::array<Uv, 3>{{Uv{{1, 0}}, Uv{{0, 2}}, Uv{{2, 2}}}}, weights) == Uv{{1, 1}});
  const CGAL::IO::Color color =
      interpolate(std::array<CGAL::IO::Color, 3>{{CGAL::IO::Color(200, 0, 0, 100), CGAL::IO::Color(0, 100, 0, 100),
                                                  CGAL::IO::Color(0, 0, 40, 100)}},
                  weights);
  CHECK(color == CGAL::IO::Color(100, 25, 10, 100));
}

void test_wrong_location()
{
  const Mesh input = icosphere(0);
  Mesh output;
  const Mesh::Vertex_index v = output.add_vertex(Point_3(0, 0, 0));
  auto locations = output.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
  auto values = output.add_property_map<Mesh::Vertex_index, Point_3>("v:value").first;
  const auto transfer = [&] { Hde::transfer_vertex_property(input, input.points(), output, locations, values); };
  CHECK(contains(invalid_argument_message(transfer), "vertex 0 of the output has no location")); // nobody has written it
  locations[v].face = 20;
  CHECK(contains(invalid_argument_message(transfer), "is 20"));
}

int main()
{
  test_surface_mesh();
  test_polyhedron();
  test_face_range();
  test_untouched_vertices();
  test_touching_sheets();
  test_values();
  test_wrong_location();
  return check_summary();
}
