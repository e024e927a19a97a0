// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What Rbf_implicit_function makes of its input: points with normals, isolated and duplicate vertices, sheets close to each
// other, coordinates of any scale, and input that it must refuse.

#include "check.h"
#include "shapes.h"

#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;

typedef CGAL::Rbf_implicit_function<Kernel> Function;
typedef std::pair<Point_3, Vector_3> Point_with_normal;
typedef std::vector<Point_with_normal> Points_with_normals;

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

Points_with_normals points_with_normals(const Mesh& mesh, const Ellipsoid_function& exact = Ellipsoid_function())
{
  Points_with_normals result;
  for (const Mesh::Vertex_index v : mesh.vertices())
    result.emplace_back(mesh.point(v), exact.gradient(mesh.point(v)));
  return result;
}

// points close to the ellipsoid, on it, inside and outside
std::vector<Point_3> test_points()
{
  std::vector<Point_3> result;
  for (const Point_3& q : spiral_points(1000))
    for (const double factor : {0.99, 1., 1.01})
      result.emplace_back(factor * q.x(), 2 * factor * q.y(), 5 * factor * q.z());
  return result;
}

template <typename F, typename G>
double largest_difference(const F& f, const G& g)
{
  double result = 0;
  for (const Point_3& p : test_points())
    result = (std::max)(result, std::abs(f(p) - g(p)));
  return result;
}

void test_points_with_normals()
{
  const Mesh mesh = ellipsoid(4);
  const Points_with_normals points = points_with_normals(mesh);
  const Function from_mesh(mesh), from_points(points);
  CHECK(from_points.diagnostics().number_of_points == points.size());
  // the offsets and the normals differ a little
  const double difference = largest_difference(from_mesh, from_points);
  std::cout << "from mesh and from points: " << difference << std::endl;
  CHECK(difference < 1e-3);
  for (const Point_with_normal& p : points)
    CHECK(std::abs(from_points(p.first)) < 1e-9);

  // property maps of the caller, other containers
  std::vector<std::size_t> indices;
  std::vector<Point_3> positions;
  std::vector<Vector_3> normals;
  for (const Point_with_normal& p : points)
  {
    indices.push_back(indices.size());
    positions.push_back(p.first);
    normals.push_back(17 * p.second); // of any length
  }
  const Function from_indices(
      indices,
      CGAL::parameters::point_map(CGAL::make_property_map(positions)).normal_map(CGAL::make_property_map(normals)));
  CHECK(largest_difference(from_points, from_indices) < 1e-9);
}

void test_point_map_of_mesh()
{
  const Mesh mesh = ellipsoid(3);
  Mesh moved = mesh;
  auto positions = moved.add_property_map<Mesh::Vertex_index, Point_3>("v:position").first;
  for (const Mesh::Vertex_index v : moved.vertices())
  {
    positions[v] = moved.point(v);
    moved.point(v) = Point_3(0, 0, 0);
  }
  CHECK(largest_difference(Function(mesh), Function(moved, CGAL::parameters::vertex_point_map(positions))) == 0);
}

void test_isolated_vertices()
{
  const Mesh mesh = ellipsoid(3);
  Mesh with_isolated = mesh;
  for (int i = 0; i < 7; ++i)
    with_isolated.add_vertex(Point_3(0.1 * i, 0, 0));
  with_isolated.add_vertex(mesh.point(Mesh::Vertex_index(0)));
  with_isolated.add_vertex(Point_3(nan_value, 0, 0)); // nobody looks at it
  const Function f(mesh), g(with_isolated);
  CHECK(f.diagnostics().number_of_isolated_vertices == 0);
  CHECK(g.diagnostics().number_of_isolated_vertices == 9);
  CHECK(g.diagnostics().number_of_points == mesh.number_of_vertices());
  CHECK(largest_difference(f, g) == 0);
}

void test_duplicate_points()
{
  Points_with_normals points = points_with_normals(ellipsoid(3));
  const Function f(points);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; i += 3)
    points.push_back(points[i]);
  const Function g(points);
  CHECK(f.diagnostics().number_of_duplicate_points == 0);
  CHECK(g.diagnostics().number_of_duplicate_points == (n + 2) / 3);
  CHECK(g.diagnostics().number_of_points == n);
  CHECK(g.diagnostics().patches_on_fallback == 0);
  CHECK(largest_difference(f, g) < 1e-9);

  // a point twice with opposite normals has no side: no off-surface point, but the surface passes through it
  Points_with_normals opposite = points_with_normals(ellipsoid(3));
  opposite.emplace_back(opposite[5].first, -opposite[5].second);
  const Function h(opposite);
  CHECK(h.diagnostics().number_of_duplicate_points == 1);
  CHECK(std::abs(h(opposite[5].first)) < 1e-9);
  CHECK(h.gradient(opposite[5].first) * opposite[5].second > 0);
}

// Two sheets that face each other over a gap narrower than the offset: with the offsets as they are, the off-surface points
// of one would lie behind the other.
void test_close_sheets()
{
  Points_with_normals points;
  const double gap = 0.04;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
    {
      points.emplace_back(Point_3(0.1 * i, 0.1 * j, 0), Vector_3(0, 0, 1));
      points.emplace_back(Point_3(0.1 * i, 0.1 * j, gap), Vector_3(0, 0, -1));
    }
  const Function f(points, CGAL::parameters::offset_distance(0.05));
  CHECK(f.diagnostics().number_of_shortened_offsets == points.size());
  std::size_t wrong = 0;
  for (int i = 4; i < 32; ++i)
    for (int j = 4; j < 32; ++j)
    {
      wrong += f(Point_3(0.055 * i, 0.055 * j, 0.5 * gap)) > 0 ? 0 : 1;
      wrong += f(Point_3(0.055 * i, 0.055 * j, -0.1 * gap)) < 0 ? 0 : 1;
      wrong += f(Point_3(0.055 * i, 0.055 * j, 1.1 * gap)) < 0 ? 0 : 1;
    }
  std::cout << "wrong signs between close sheets: " << wrong << std::endl;
  CHECK(wrong == 0);
}

// A scaled input gives the scaled function. The shape has no symmetry: where two points are equally far along an axis, the
// last bit decides in which patch they are.
void test_scale()
{
  Soup soup = scaled(icosphere_soup(3), 1, 2, 5);
  for (Point_3& p : soup.points)
    p = Point_3(p.x() + 0.1 * p.z() + 0.02 * p.z() * p.z(), p.y() + 0.1 * p.x() * p.z(), p.z() + 0.1 * p.y());
  const Function f(to_mesh(soup));
  for (const double scale : {1e-6, 1e6})
  {
    const Function g(to_mesh(scaled(soup, scale, scale, scale)));
    double value = 0, gradient = 0;
    for (const Point_3& p : test_points())
    {
      const Point_3 q = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN);
      value = (std::max)(value, std::abs(f(p) - g(q) / scale));
      gradient = (std::max)(gradient, std::sqrt((f.gradient(p) - g.gradient(q)).squared_length()));
    }
    std::cout << "scaled by " << scale << ": " << value << " " << gradient << std::endl;
    CHECK(value < 1e-8);
    CHECK(gradient < 1e-7);
  }
}

void test_few_points()
{
  // a tetrahedron has 4 on- and 4 off-surface points
  Mesh tetrahedron;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), tetrahedron);
  const Function f(tetrahedron);
  CHECK(f(Point_3(0.2, 0.2, 0.2)) < 0);
  CHECK(f(Point_3(2, 2, 2)) > 0);
  // a flat one: the polynomials are not determined by its vertices alone
  Mesh square;
  CGAL::make_quad(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), square);
  CGAL::Euler::split_face(halfedge(*faces(square).begin(), square),
                          next(next(halfedge(*faces(square).begin(), square), square), square), square);
  const Function g(square);
  const double up = g(Point_3(0.4, 0.6, 0.1)), down = g(Point_3(0.4, 0.6, -0.1));
  CHECK(up * down < 0);
  CHECK(std::isfinite(up) && std::isfinite(down));
}

template <typename Input>
std::string message_of(const Input& input)
{
  return invalid_argument_message([&] { Function f(input); });
}

template <typename NamedParameters>
std::string message_of(const Mesh& mesh, const NamedParameters& np)
{
  return invalid_argument_message([&] { Function f(mesh, np); });
}

void test_invalid_input()
{
  CHECK(!message_of(Mesh()).empty());
  CHECK(!message_of(Points_with_normals()).empty());
  Mesh only_isolated;
  only_isolated.add_vertex(Point_3(0, 0, 0));
  CHECK(!message_of(only_isolated).empty());

  for (const double bad : {nan_value, infinity, -infinity})
  {
    Mesh mesh = ellipsoid(2);
    mesh.point(Mesh::Vertex_index(17)) = Point_3(0, bad, 0);
    CHECK(contains(message_of(mesh), "point of vertex 17"));
    Points_with_normals points = points_with_normals(ellipsoid(2));
    points[18].second = Vector_3(0, 0, bad);
    CHECK(contains(message_of(points), "normal of vertex 18"));
  }

  // all faces degenerate: on a line, and in a point
  for (const double length : {1., 0.})
  {
    Mesh mesh;
    const auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(length, 0, 0)),
               c = mesh.add_vertex(Point_3(2 * length, 0, 0));
    mesh.add_face(a, b, c);
    CHECK(contains(message_of(mesh), "degenerate"));
  }
}

void test_invalid_parameters()
{
  using namespace CGAL::parameters;
  const Mesh mesh = ellipsoid(1);
  CHECK(contains(message_of(mesh, number_of_patches(0)), "number_of_patches is 0"));
  CHECK(contains(message_of(mesh, number_of_patches(-3)), "number_of_patches is -3"));
  for (const double bad : {-1., nan_value, infinity})
  {
    CHECK(contains(message_of(mesh, patch_overlap(bad)), "patch_overlap is"));
    CHECK(contains(message_of(mesh, offset_distance(bad)), "offset_distance is"));
  }
  CHECK(contains(message_of(mesh, offset_distance(0)), "offset_distance is 0"));
  // at the edge of what is allowed
  CHECK_NO_THROW(Function(mesh, patch_overlap(0)));
  CHECK_NO_THROW(Function(mesh, number_of_patches(1000000)));
}

int main()
{
  test_points_with_normals();
  test_point_map_of_mesh();
  test_isolated_vertices();
  test_duplicate_points();
  test_close_sheets();
  test_scale();
  test_few_points();
  test_invalid_input();
  test_invalid_parameters();
  return check_summary();
}
