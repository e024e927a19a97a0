// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Borders that are put on the function, with project_borders: in their planes, with their corners.

#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

typedef CGAL::Parallel_if_available_tag Tag;

typedef std::function<double(const Point_3&)> Distance_to_planes;

struct Border
{
  double from_surface = 0, from_planes = 0; // the largest distances of its vertices
  std::size_t size = 0;
};

template <typename Function>
Border measure_border(const Mesh& mesh, const Function& function, const Distance_to_planes& distance_to_planes)
{
  Border result;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.is_border(v))
    {
      const Point_3& p = mesh.point(v);
      const double slope = std::sqrt(function.gradient(p).squared_length());
      result.from_surface = (std::max)(result.from_surface, std::abs(function(p)) / slope);
      result.from_planes = (std::max)(result.from_planes, distance_to_planes(p));
      ++result.size;
    }
  return result;
}

// Without the parameter the border stays off the surface; with it, it is on the surface and in the planes.
template <typename Function, typename NamedParameters>
Mesh check_borders(const std::string& name, const Mesh& input, const Function& function,
                   const Distance_to_planes& distance_to_planes, const NamedParameters& np)
{
  const double diagonal = bounding_box_diagonal(input);
  Mesh stays = input, mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(stays, function, np.project_borders(false));
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, np.project_borders(true));
  const Border before = measure_border(stays, function, distance_to_planes),
               after = measure_border(mesh, function, distance_to_planes);
  std::cout << name << ": " << mesh.number_of_faces() << " faces, " << after.size << " at the border, from the surface "
            << after.from_surface << " instead of " << before.from_surface << ", from the planes " << after.from_planes
            << " instead of " << before.from_planes << ", off the surface " << result.number_of_unprojected_vertices
            << std::endl;
  check_validity(name, input, mesh, function);
  CHECK(before.from_surface > 1e-4 * diagonal);
  CHECK(after.from_surface <= 1e-9 * diagonal);
  CHECK(after.from_planes <= 1e-9 * diagonal);
  CHECK(result.number_of_unprojected_vertices == 0);
  return mesh;
}

// the plane goes through the facets
void test_clipped_sphere()
{
  const CGAL::Plane_3<Kernel> plane(0.3, 0.5, 1, -0.4);
  Mesh input = icosphere(3);
  CGAL::Polygon_mesh_processing::clip(input, plane);
  input.collect_garbage();
  const auto distance = [=](const Point_3& p) { return std::sqrt(CGAL::squared_distance(p, plane)); };
  for (const std::size_t number_of_faces : {300, 1500, 6000})
    check_borders("clipped sphere", input, Sphere_function(), distance,
                  params::relative_sigma(0.02).number_of_target_faces(number_of_faces));
  const Mesh mesh = check_borders("clipped sphere, projected only", input, Sphere_function(), distance,
                                  params::sigma(0).number_of_iterations(0));
  CHECK(mesh.number_of_vertices() == input.number_of_vertices());
}

// --- a gyroid in a box ---

struct Gyroid
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  static Point_3 phase(const Point_3& p) { return Point_3(2 * pi * p.x() + 0.7, 2 * pi * p.y() + 0.3, 2 * pi * p.z() + 1.1); }

  FT operator()(const Point_3& p) const
  {
    const Point_3 q = phase(p);
    return std::sin(q.x()) * std::cos(q.y()) + std::sin(q.y()) * std::cos(q.z()) + std::sin(q.z()) * std::cos(q.x());
  }
  Vector_3 gradient(const Point_3& p) const
  {
    const Point_3 q = phase(p);
    return 2 * pi *
           Vector_3(std::cos(q.x()) * std::cos(q.y()) - std::sin(q.z()) * std::sin(q.x()),
                    std::cos(q.y()) * std::cos(q.z()) - std::sin(q.x()) * std::sin(q.y()),
                    std::cos(q.z()) * std::cos(q.x()) - std::sin(q.y()) * std::sin(q.z()));
  }
};

// The zero set in the unit cube by marching tetrahedra, six for each cell of a grid, linear on their edges.
class Marching_tetrahedra
{
public:
  template <typename Function>
  Mesh operator()(const Function& f, const int n)
  {
    static constexpr std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z)
          for (const std::array<int, 3>& order : orders)
          {
            std::array<Corner, 4> corners;
            corners[0] = {{x, y, z}};
            for (std::size_t k = 0; k < 3; ++k)
            {
              corners[k + 1] = corners[k];
              ++corners[k + 1][std::size_t(order[k])];
            }
            add_tetrahedron(f, n, corners);
          }
    return to_mesh(m_soup);
  }

private:
  typedef std::array<int, 3> Corner;

  template <typename Function>
  void add_tetrahedron(const Function& f, const int n, const std::array<Corner, 4>& corners)
  {
    std::vector<Corner> inside, outside;
    for (const Corner& c : corners)
      (f(point(c, n)) < 0 ? inside : outside).push_back(c);
    if (inside.size() == 2)
    {
      add_triangle(f, n, {{{inside[0], outside[0]}, {inside[0], outside[1]}, {inside[1], outside[0]}}});
      add_triangle(f, n, {{{inside[1], outside[1]}, {inside[0], outside[1]}, {inside[1], outside[0]}}});
    }
    else if (inside.size() == 1)
      add_triangle(f, n, {{{inside[0], outside[0]}, {inside[0], outside[1]}, {inside[0], outside[2]}}});
    else if (outside.size() == 1)
      add_triangle(f, n, {{{inside[0], outside[0]}, {inside[1], outside[0]}, {inside[2], outside[0]}}});
  }

  // looks outward
  template <typename Function>
  void add_triangle(const Function& f, const int n, const std::array<std::pair<Corner, Corner>, 3>& edges)
  {
    std::array<std::size_t, 3> face;
    for (std::size_t k = 0; k < 3; ++k)
      face[k] = vertex(f, n, edges[k]);
    const Point_3 &a = m_soup.points[face[0]], &b = m_soup.points[face[1]], &c = m_soup.points[face[2]];
    if (CGAL::cross_product(b - a, c - a) * f.gradient(CGAL::centroid(a, b, c)) < 0)
      std::swap(face[1], face[2]);
    m_soup.triangles.push_back({face[0], face[1], face[2]});
  }

  template <typename Function>
  std::size_t vertex(const Function& f, const int n, const std::pair<Corner, Corner>& edge)
  {
    const auto added = m_vertices.emplace(edge, m_soup.points.size());
    if (added.second)
    {
      const Point_3 p = point(edge.first, n), q = point(edge.second, n);
      m_soup.points.push_back(p + f(p) / (f(p) - f(q)) * (q - p));
    }
    return added.first->second;
  }

  static Point_3 point(const Corner& c, const int n) { return Point_3(double(c[0]) / n, double(c[1]) / n, double(c[2]) / n); }

  Soup m_soup;
  std::map<std::pair<Corner, Corner>, std::size_t> m_vertices;
};

// from the sides of the unit cube
double distance_to_sides(const Point_3& p)
{
  double least = 1;
  for (int i = 0; i < 3; ++i)
    least = (std::min)({least, std::abs(p[i]), std::abs(p[i] - 1)});
  return least;
}

std::size_t number_of_points_on_edges(const Mesh& mesh)
{
  std::size_t number = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    int sides = 0;
    for (int i = 0; i < 3; ++i)
      sides += (std::min)(std::abs(mesh.point(v)[i]), std::abs(mesh.point(v)[i] - 1)) < 1e-9 ? 1 : 0;
    number += sides >= 2 ? 1 : 0;
  }
  return number;
}

void test_gyroid()
{
  const Mesh input = Marching_tetrahedra()(Gyroid(), 14);
  const std::size_t number_of_corners = number_of_points_on_edges(input);
  CHECK(number_of_corners >= 6);
  const Mesh mesh =
      check_borders("gyroid", input, Gyroid(), distance_to_sides, params::relative_sigma(0.02).number_of_target_faces(6000));
  std::cout << number_of_corners << " points on edges of the box, " << number_of_points_on_edges(mesh) << " after" << std::endl;
  CHECK(number_of_points_on_edges(mesh) == number_of_corners);
}

// What is constrained stays, and what keeps its descriptor moves, too: corners of borders.
void test_constraints()
{
  const Mesh input = Marching_tetrahedra()(Gyroid(), 14);
  Mesh mesh = input;
  auto constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:constrained", false).first;
  std::vector<std::pair<Mesh::Vertex_index, Point_3>> points;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.point(v).x() == 0)
    {
      constrained[v] = true;
      points.emplace_back(v, mesh.point(v));
    }
  CHECK(points.size() > 10);
  CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, Gyroid(), params::vertex_is_constrained_map(constrained).project_borders(true).target_edge_length(0.05));
  for (const auto& kept : points)
    CHECK(mesh.point(kept.first) == kept.second);
  std::size_t number = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.is_border(v) && mesh.point(v).x() > 0.1)
    {
      CHECK(std::abs(Gyroid()(mesh.point(v))) < 1e-8);
      CHECK(distance_to_sides(mesh.point(v)) < 1e-9);
      ++number;
    }
  CHECK(number > 100);

  mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Gyroid(), params::protect_constraints(true).project_borders(true));
  CHECK(measure_border(mesh, Gyroid(), distance_to_sides).from_surface ==
        measure_border(input, Gyroid(), distance_to_sides).from_surface);
}

// the function that is built; and it is built, though fewer faces are asked for
void test_built_function()
{
  Mesh mesh = half_sphere(12);
  const CGAL::Rbf_implicit_function<CGAL::Simple_cartesian<double>, CGAL::Polyharmonic_rbf, Tag> function(mesh);
  const double diagonal = bounding_box_diagonal(mesh);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(400).project_borders(true));
  double from_surface = 0, from_plane = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.is_border(v))
    {
      const CGAL::Simple_cartesian<double>::Point_3 p(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
      from_surface = (std::max)(from_surface, std::abs(function(p)));
      from_plane = (std::max)(from_plane, std::abs(p.z()));
    }
  std::cout << "built function: border from the surface " << from_surface << ", from the plane " << from_plane << std::endl;
  CHECK(from_surface <= 2e-9 * diagonal);
  CHECK(from_plane <= 1e-9 * diagonal);
}

// Borders that are on the surface, and straight, stay as they are; a square has corners without a way.
void test_straight_borders()
{
  struct Plane_function
  {
    typedef Kernel::FT FT;
    typedef shapes::Point_3 Point_3;
    typedef shapes::Vector_3 Vector_3;
    FT operator()(const Point_3& p) const { return p.z(); }
    Vector_3 gradient(const Point_3&) const { return Vector_3(0, 0, 1); }
  };
  Mesh square;
  const auto a = square.add_vertex(Point_3(0, 0, 0)), b = square.add_vertex(Point_3(1, 0, 0)),
             c = square.add_vertex(Point_3(1, 1, 0)), d = square.add_vertex(Point_3(0, 1, 0));
  square.add_face(a, b, c);
  square.add_face(a, c, d);
  Mesh mesh = square, stays = square;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Plane_function(), params::target_edge_length(0.1).project_borders(true));
  CGAL::anisotropic_hde_remeshing<Tag>(stays, Plane_function(), params::target_edge_length(0.1));
  CHECK(digest(mesh) == digest(stays));
}

int main()
{
  test_clipped_sphere();
  test_gyroid();
  test_constraints();
  test_built_function();
  test_straight_borders();
  return check_summary();
}
