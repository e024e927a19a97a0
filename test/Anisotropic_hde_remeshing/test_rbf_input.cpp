// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What Rbf_implicit_function makes of its input: points with normals, isolated and duplicate vertices, sheets close to each
// other, coordinates of any scale, few and degenerate points, shapes sampled too coarsely, and input that it must refuse.

#include "awkward_shapes.h"
#include "check.h"
#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Random.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/boost/graph/copy_face_graph.h>
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

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;
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
      indices, params::point_map(CGAL::make_property_map(positions)).normal_map(CGAL::make_property_map(normals)));
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
  CHECK(largest_difference(Function(mesh), Function(moved, params::vertex_point_map(positions))) == 0);
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
  CHECK(g.diagnostics().number_of_points - g.diagnostics().number_of_points_on_facets == mesh.number_of_vertices());
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
  const Function f(points, params::offset_distance(0.05));
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

// A shell thinner than a twentieth of the distance between its points: nothing but the facets tells how near the other side is. It
// is right in the middle and on both sides, and a shell as thick as a fifth is interpolated.
void test_thin_shell()
{
  for (const double gap : {0.004, 0.02})
  {
    const Function f(shapes::to_mesh(awkward_shapes::turned_shell(4, gap)), params::default_values());
    std::size_t wrong = 0;
    for (const Point_3& p : spiral_points(2000))
    {
      const auto at = [&](const double radius) { return f(CGAL::ORIGIN + radius * (p - CGAL::ORIGIN)); };
      wrong += (at(1 - gap / 2) < 0 ? 0 : 1) + (at(1 + gap) > 0 ? 0 : 1) + (at(1 - 2 * gap) > 0 ? 0 : 1);
    }
    std::cout << "wrong signs around a shell of " << gap << ": " << wrong << ", " << f.diagnostics().patches_on_fallback
              << " of " << f.diagnostics().number_of_patches << " patches on fallback" << std::endl;
    CHECK(wrong == 0);
    CHECK((f.diagnostics().patches_on_fallback == 0) == (gap > 0.01));
  }
}

// no value, gradient, Hessian or curvature is anything but a number: about the points, far away, and at `points` themselves
template <typename F>
void check_finite(const F& f, const std::vector<Point_3>& points)
{
  const Kernel::Sphere_3 sphere = f.bounding_sphere();
  const double radius = std::sqrt(sphere.squared_radius());
  CHECK(std::isfinite(radius) && radius > 0);
  std::vector<Point_3> all = points;
  for (const double factor : {0., 0.1, 0.5, 1., 2., 10., 1e3, 1e6})
    for (const Point_3& q : spiral_points(30))
      all.push_back(sphere.center() + factor * radius * (q - CGAL::ORIGIN));
  std::size_t not_finite = 0;
  for (const Point_3& p : all)
  {
    const auto at_p = f.value_and_gradient(p);
    const auto curvatures = f.principal_curvatures(p);
    const bool is_finite = std::isfinite(at_p.first) && std::isfinite(at_p.second.x() + at_p.second.y() + at_p.second.z()) &&
                           f.hessian(p).allFinite() && std::isfinite(curvatures.min_curvature) &&
                           std::isfinite(curvatures.max_curvature);
    not_finite += is_finite ? 0 : 1;
  }
  CHECK(not_finite == 0);
}

template <typename F>
void check_finite(const F& f, const Points_with_normals& points)
{
  std::vector<Point_3> positions;
  for (const Point_with_normal& p : points)
    positions.push_back(p.first);
  check_finite(f, positions);
}

// The largest difference of the values over the diagonal, and of the gradients, of the functions of a shape and of its image
// under p -> scale p + translation, about the vertices.
std::pair<double, double> difference_to_image(const Soup& soup, const double scale, const Vector_3& translation)
{
  const auto image = [&](const Point_3& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN) + translation; };
  Soup moved = soup;
  for (Point_3& p : moved.points)
    p = image(p);
  const Mesh mesh = to_mesh(soup);
  const Function f(mesh), g(to_mesh(moved));
  CHECK(f.diagnostics().number_of_patches == g.diagnostics().number_of_patches);
  double value = 0, gradient = 0;
  CGAL::Random random(31);
  for (const Point_3& p : soup.points)
  {
    const Point_3 q = p + Vector_3(random.get_double(-0.1, 0.1), random.get_double(-0.1, 0.1), random.get_double(-0.1, 0.1));
    value = (std::max)(value, std::abs(f(q) - g(image(q)) / scale));
    gradient = (std::max)(gradient, std::sqrt((f.gradient(q) - g.gradient(image(q))).squared_length()));
  }
  return std::make_pair(value / bounding_box_diagonal(mesh), gradient);
}

Soup torus_soup(const std::size_t around, const std::size_t across)
{
  Soup soup;
  const Mesh mesh = torus(around, across);
  for (const Mesh::Vertex_index v : mesh.vertices())
    soup.points.push_back(mesh.point(v));
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  return soup;
}

// A scaled or moved input gives the scaled or moved function, also of shapes with symmetries, where the last bit of a
// coordinate must not decide in which patch a point is.
void test_scale()
{
  Soup bent = scaled(icosphere_soup(3), 1, 2, 5);
  for (Point_3& p : bent.points)
    p = Point_3(p.x() + 0.1 * p.z() + 0.02 * p.z() * p.z(), p.y() + 0.1 * p.x() * p.z(), p.z() + 0.1 * p.y());
  const std::pair<const char*, Soup> shapes[] = {
      {"bent ellipsoid", bent}, {"sphere", icosphere_soup(3)}, {"torus", torus_soup(60, 20)}};
  for (const auto& [name, soup] : shapes)
  {
    for (const double scale : {1e-6, 1e6})
    {
      const std::pair<double, double> difference = difference_to_image(soup, scale, CGAL::NULL_VECTOR);
      std::cout << name << " scaled by " << scale << ": " << difference.first << " " << difference.second << std::endl;
      CHECK(difference.first <= 1e-9);
      CHECK(difference.second <= 1e-7);
    }
    const double distance = 1000 * bounding_box_diagonal(to_mesh(soup));
    const std::pair<double, double> difference =
        difference_to_image(soup, 1, Vector_3(distance, -0.7 * distance, 0.3 * distance));
    std::cout << name << " moved: " << difference.first << " " << difference.second << std::endl;
    CHECK(difference.first <= 1e-6);
    CHECK(difference.second <= 1e-4);
  }
}

// As large and as small as doubles go, the function is built, and the sign is right.
void test_extreme_scale()
{
  for (const double scale : {1e-300, 1e-200, 1e-100, 1e100, 1e149 / 5})
  {
    const auto check = [&](const auto& input)
    {
      const Function f(input);
      CHECK(f.diagnostics().number_of_points - f.diagnostics().number_of_points_on_facets == 642);
      CHECK(f.diagnostics().patches_on_fallback == 0);
      CHECK(f.diagnostics().worst_value_residual <= 1e-9 * scale);
      for (const Point_3& p : test_points())
        CHECK(std::isfinite(f(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN))));
      for (const double factor : {0.1, 0.9, 1.1, 2.})
        CHECK((f(Point_3(factor * scale, 0, 0)) > 0) == (factor > 1));
      CHECK_CLOSE(f.gradient(Point_3(scale, 0, 0)).x(), 1, 0.01);
    };
    CHECK_NO_THROW(check(to_mesh(scaled(icosphere_soup(3), scale, 2 * scale, 5 * scale))));
    Points_with_normals points = points_with_normals(ellipsoid(3));
    for (Point_with_normal& p : points)
      p = Point_with_normal(CGAL::ORIGIN + scale * (p.first - CGAL::ORIGIN), scale * p.second);
    CHECK_NO_THROW(check(points));
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
  check_finite(f, {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)});

  // a point alone has no distance to others
  CHECK(!invalid_argument_message([] { Function(Points_with_normals{{Point_3(1, 2, 3), Vector_3(0, 0, 1)}}); }).empty());

  // fewer points than polynomials, and up to where their number changes
  for (int n = 2; n <= 9; ++n)
  {
    Points_with_normals points;
    for (int i = 0; i < n; ++i)
      points.emplace_back(Point_3(std::cos(2. * i), std::sin(3. * i), 0.1 * i), Vector_3(0, 0, 1));
    const Function g(points);
    CHECK(g.diagnostics().number_of_points == std::size_t(n));
    check_finite(g, points);
    for (const Point_with_normal& p : points)
    {
      CHECK(std::abs(g(p.first)) <= 1e-9);
      CHECK(g(p.first + 0.02 * p.second) > 0);
      CHECK(g(p.first - 0.02 * p.second) < 0);
    }
  }
}

// The polynomials are not determined by the vertices alone, and the interpolant of a plane is its distance.
template <typename Input>
void check_plane(const Input& input)
{
  const Function f(input, params::close_holes(false)); // closed, it would not be a plane
  double value = 0, gradient = 0, hessian = 0;
  std::vector<Point_3> points;
  for (double x = -0.5; x < 3; x += 0.17)
    for (double y = -0.5; y < 3; y += 0.19)
      for (const double z : {-1., -0.1, -0.01, 0., 0.02, 0.3})
        points.emplace_back(x, y, z);
  for (const Point_3& p : points)
    if (p.x() > 0 && p.x() < 2 && p.y() > 0 && p.y() < 2)
    {
      value = (std::max)(value, std::abs(f(p) - p.z()));
      gradient = (std::max)(gradient, std::sqrt((f.gradient(p) - Vector_3(0, 0, 1)).squared_length()));
      hessian = (std::max)(hessian, f.hessian(p).norm());
    }
  std::cout << "plane: " << value << " " << gradient << " " << hessian << std::endl;
  CHECK(value <= 1e-12);
  CHECK(gradient <= 1e-10);
  CHECK(hessian <= 1e-8);
  check_finite(f, points);
}

void test_degenerate_positions()
{
  Mesh grid = hills(20);
  Points_with_normals points;
  for (const Mesh::Vertex_index v : grid.vertices())
  {
    grid.point(v) = Point_3(grid.point(v).x(), grid.point(v).y(), 0);
    points.emplace_back(grid.point(v), Vector_3(0, 0, 1));
  }
  check_plane(grid);
  check_plane(points);
  Mesh square;
  CGAL::make_quad(Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(2, 2, 0), Point_3(0, 2, 0), square);
  CGAL::Euler::split_face(halfedge(*faces(square).begin(), square),
                          next(next(halfedge(*faces(square).begin(), square), square), square), square);
  check_finite(Function(square), {Point_3(0, 0, 0), Point_3(1, 1, 0)});
  CHECK(Function(square)(Point_3(0.9, 0.8, 0.1)) * Function(square)(Point_3(0.9, 0.8, -0.1)) < 0);

  // on a line
  points.clear();
  for (int i = 0; i < 60; ++i)
    points.emplace_back(Point_3(0.1 * i, 0.2 * i, 0), Vector_3(0, 0, 1));
  const Function f(points);
  check_finite(f, points);
  for (const Point_with_normal& p : points)
    for (const double z : {-0.3, -0.1, 0., 0.1, 0.3})
      CHECK_CLOSE(f(p.first + z * p.second), z, 1e-9);

  // faces without area, whose points have normals all the same: these are the surface, far away, too
  Mesh needles;
  for (int i = 0; i < 12; ++i)
    CGAL::make_triangle(Point_3(i, 0, 0), Point_3(i + 0.5, 0, 0), Point_3(i + 0.9, 0, 0), needles);
  auto normals = needles.add_property_map<Mesh::Vertex_index, Vector_3>("v:normal", Vector_3(0, 0, 1)).first;
  const Function g(needles, params::vertex_normal_map(normals));
  for (const double z : {-100., -0.5, 0.5, 100.})
    CHECK(std::isfinite(g(Point_3(5, 0, z))) && g(Point_3(5, 0, z)) * z > 0);
}

void test_normals()
{
  Points_with_normals points = points_with_normals(ellipsoid(3));
  for (std::size_t i = 0; i < points.size(); i += 2)
    points[i].second = Vector_3(0, 0, 0);
  const Function f(points);
  CHECK(f.diagnostics().number_of_points_without_normal == points.size() / 2);
  check_finite(f, points);
  double residual = 0;
  for (const Point_with_normal& p : points)
    residual = (std::max)(residual, std::abs(f(p.first)));
  CHECK(residual <= 1e-9);
  for (const Point_3& q : spiral_points(500))
    for (const double factor : {0.5, 0.9, 1.1, 2.})
      CHECK((f(Point_3(factor * q.x(), 2 * factor * q.y(), 5 * factor * q.z())) < 0) == (factor < 1));
  for (Point_with_normal& p : points)
    p.second = Vector_3(0, 0, 0);
  CHECK(contains(invalid_argument_message([&] { Function g(points); }), "normal"));
}

// spheres side by side, a small dense one among them, and one in another, hollow
void test_components()
{
  const std::pair<double, Point_3> spheres[] = {
      {1, Point_3(0, 0, 0)}, {0.1, Point_3(1.3, 0, 0)}, {2, Point_3(0, 0, 4)}, {0.5, Point_3(0, 0, 4)}};
  Mesh mesh;
  for (const auto& [radius, centre] : spheres)
  {
    Mesh sphere = icosphere(3, radius);
    for (const Mesh::Vertex_index v : sphere.vertices())
      sphere.point(v) = centre + (sphere.point(v) - CGAL::ORIGIN);
    if (radius == 0.5)
      CGAL::Polygon_mesh_processing::reverse_face_orientations(sphere);
    CGAL::copy_face_graph(sphere, mesh);
  }
  const Function f(mesh);
  std::cout << "components: patches on fallback " << f.diagnostics().patches_on_fallback << std::endl;
  std::vector<Point_3> points(mesh.points().begin(), mesh.points().end());
  check_finite(f, points);
  std::size_t wrong = 0;
  for (const auto& [radius, centre] : spheres)
    for (const Point_3& q : spiral_points(300))
      for (const double factor : {0.3, 0.5, 0.8, 0.95, 1.05, 1.2}) // the largest is hollow below 0.25
        wrong += (f(centre + factor * radius * (q - CGAL::ORIGIN)) < 0) == ((factor < 1) == (radius != 0.5)) ? 0 : 1;
  CHECK(wrong == 0);
  CHECK(f(Point_3(1.1, 0, 0)) > 0 && f(Point_3(100, 20, 3)) > 0);
}

void test_open_surfaces()
{
  const Function f(hills(20), params::close_holes(false));
  std::size_t wrong = 0;
  std::vector<Point_3> points;
  for (double x = 0.05; x < 2; x += 0.05)
    for (double y = 0.05; y < 2; y += 0.05)
      for (const double z : {-2., -0.5, -0.1, -0.02, 0.02, 0.1, 0.5, 2.})
      {
        points.emplace_back(x, y, Hills_function::height(x, y) + z);
        wrong += (f(points.back()) > 0) == (z > 0) ? 0 : 1;
      }
  CHECK(wrong == 0);
  check_finite(f, points);
  const Mesh half = half_sphere(10);
  check_finite(Function(half), std::vector<Point_3>(half.points().begin(), half.points().end()));
}

Mesh triangulated_cube()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), Point_3(0, 1, 1),
                        Point_3(0, 0, 1), Point_3(1, 0, 1), Point_3(1, 1, 1), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

// what is sampled too coarsely is answered by the input itself, and the diagnostics say so
void test_fallback()
{
  const Mesh cube = triangulated_cube();
  const Function f(cube);
  CHECK(f.diagnostics().patches_on_fallback == f.diagnostics().number_of_patches);
  for (const Point_3& q : spiral_points(500))
    for (const double factor : {0.3, 0.49, 0.6, 1., 3.})
    {
      const Point_3 p = Point_3(0.5, 0.5, 0.5) + factor * (q - CGAL::ORIGIN);
      double inside = 1;
      for (int k = 0; k < 3; ++k)
        inside = (std::min)({inside, p[k], 1 - p[k]});
      CHECK((f(p) < 0) == (inside > 0));
      CHECK(inside < 0 || std::abs(f(p) + inside) <= 1e-12);
    }
  check_finite(f, std::vector<Point_3>(cube.points().begin(), cube.points().end()));
  // Newton's steps end on it, along normals that do not jump at the edges
  for (double x = 0.05; x < 1; x += 0.05)
    for (const double z : {0.9, 0.98, 1.02, 1.1})
    {
      const Point_3 p(x, 0.4, z);
      const auto at_p = f.value_and_gradient(p);
      const Point_3 q = p - at_p.first / at_p.second.squared_length() * at_p.second;
      CHECK(std::abs(f(q)) <= 0.3 * std::abs(at_p.first));
    }
  CHECK((f.gradient(Point_3(0.999, 0.5, 1)) - f.gradient(Point_3(1, 0.5, 0.999))).squared_length() < 0.01);
}

struct Expected_patches
{
  const char* name;
  std::size_t least_on_fallback, most_on_fallback, least_repaired;
};

// Coarse parts of machines are repaired or left to the input. Of the camel nothing is to be repaired, since points on its facets
// stand for vertices. The signs are a test of the corpus.
void test_self_check()
{
  for (const Expected_patches& expected : {Expected_patches{"anchor", 1, 1000, 0}, Expected_patches{"cheese", 5, 1000, 1},
                                           Expected_patches{"elephant", 0, 0, 0}, Expected_patches{"camel", 0, 7, 0}})
  {
    Mesh mesh;
    const std::string file = CGAL::data_file_path(std::string("meshes/") + expected.name + ".off");
    if (!CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh)))
      continue;
    const Function f(mesh);
    const auto& diagnostics = f.diagnostics();
    std::cout << expected.name << ": of " << diagnostics.number_of_patches << " patches on fallback "
              << diagnostics.patches_on_fallback << ", repaired " << diagnostics.patches_repaired << ", failed checks "
              << diagnostics.number_of_failed_checks << std::endl;
    CHECK(diagnostics.patches_on_fallback >= expected.least_on_fallback);
    CHECK(diagnostics.patches_on_fallback <= expected.most_on_fallback);
    CHECK(diagnostics.patches_on_fallback < diagnostics.number_of_patches);
    CHECK(diagnostics.patches_repaired >= expected.least_repaired);
    CHECK(diagnostics.number_of_failed_checks <= diagnostics.number_of_points / 10);
  }
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
  using namespace CGAL::Anisotropic_hde_remeshing::parameters;
  const Mesh mesh = ellipsoid(1);
  CHECK(contains(message_of(mesh, number_of_patches(0)), "number_of_patches is 0"));
  CHECK(contains(message_of(mesh, number_of_patches(-3)), "number_of_patches is -3"));
  for (const double bad : {-1., nan_value, infinity})
  {
    CHECK(contains(message_of(mesh, patch_overlap(bad)), "patch_overlap is"));
    CHECK(contains(message_of(mesh, offset_distance(bad)), "offset_distance is"));
    CHECK(contains(message_of(mesh, relative_offset_distance(bad)), "relative_offset_distance is"));
    CHECK(contains(message_of(mesh, smoothing(bad)), "smoothing is"));
  }
  CHECK(contains(message_of(mesh, offset_distance(0)), "offset_distance is 0"));
  // at the edge of what is allowed
  CHECK_NO_THROW(Function(mesh, patch_overlap(0)));
  CHECK_NO_THROW(Function(mesh, number_of_patches(1000000)));
  CHECK_NO_THROW(Function(mesh, smoothing(0).two_sided_offsets(true).relative_offset_distance(1)));
  const Function strange(mesh, smoothing(1e6).relative_offset_distance(50));
  check_finite(strange, std::vector<Point_3>(mesh.points().begin(), mesh.points().end()));
}

int main()
{
  test_points_with_normals();
  test_point_map_of_mesh();
  test_isolated_vertices();
  test_duplicate_points();
  test_close_sheets();
  test_thin_shell();
  test_scale();
  test_extreme_scale();
  test_few_points();
  test_degenerate_positions();
  test_normals();
  test_components();
  test_open_surfaces();
  test_fallback();
  test_self_check();
  test_invalid_input();
  test_invalid_parameters();
  return check_summary();
}
