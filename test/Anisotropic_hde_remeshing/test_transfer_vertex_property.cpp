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
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

// every kind of values
void test_values()
{
  const Hde::Linear_interpolation interpolate;
  const std::array<double, 3> weights{{0.5, 0.25, 0.25}};
  CHECK(interpolate(std::array<double, 3>{{1, 2, 4}}, weights) == 2);
  CHECK(interpolate(std::array<float, 3>{{1, 2, 4}}, weights) == 2);
  CHECK(interpolate(std::array<int, 3>{{-1, -2, -5}}, weights) == -2);
  CHECK(interpolate(std::array<unsigned char, 3>{{255, 255, 253}}, weights) == 255); // 254.5
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
  locations[v].face = 20;
  CHECK(contains(
      invalid_argument_message([&] { Hde::transfer_vertex_property(input, input.points(), output, locations, values); }),
      "is 20"));
}

int main()
{
  test_surface_mesh();
  test_polyhedron();
  test_face_range();
  test_values();
  test_wrong_location();
  return check_summary();
}
