// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Named shapes and analytic functions for the tests: small meshes whose geometry is known exactly.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_SHAPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_SHAPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace shapes {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

constexpr double pi = 3.14159265358979323846;

// --- Functions: models of ImplicitFunctionWithGradient, negative inside ---

// the signed distance to a sphere about the origin
struct Sphere_function
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  double radius = 1;

  FT operator()(const Point_3& p) const { return std::sqrt((p - CGAL::ORIGIN).squared_length()) - radius; }
  Vector_3 gradient(const Point_3& p) const
  {
    const Vector_3 v = p - CGAL::ORIGIN;
    return v / std::sqrt(v.squared_length());
  }
};

// |(x/a, y/b, z/c)| - 1: no distance, and its gradient is no unit vector
struct Ellipsoid_function
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  double a = 1, b = 2, c = 5;

  FT operator()(const Point_3& p) const { return norm(p) - 1; }
  Vector_3 gradient(const Point_3& p) const { return Vector_3(p.x() / (a * a), p.y() / (b * b), p.z() / (c * c)) / norm(p); }

private:
  double norm(const Point_3& p) const
  {
    return std::sqrt(p.x() * p.x() / (a * a) + p.y() * p.y() / (b * b) + p.z() * p.z() / (c * c));
  }
};

// the signed distance to a torus about the axis of z
struct Torus_function
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  double large_radius = 1, small_radius = 0.25;

  FT operator()(const Point_3& p) const { return std::hypot(std::hypot(p.x(), p.y()) - large_radius, p.z()) - small_radius; }
  Vector_3 gradient(const Point_3& p) const
  {
    const double radius = std::hypot(p.x(), p.y()), distance = std::hypot(radius - large_radius, p.z());
    const double out = (radius - large_radius) / distance;
    return Vector_3(out * p.x() / radius, out * p.y() / radius, p.z() / distance);
  }
};

// the signed distance to the infinite cylinder about the axis of z
struct Cylinder_function
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  double radius = 1;

  FT operator()(const Point_3& p) const { return std::hypot(p.x(), p.y()) - radius; }
  Vector_3 gradient(const Point_3& p) const
  {
    const double r = std::hypot(p.x(), p.y());
    return Vector_3(p.x() / r, p.y() / r, 0);
  }
};

// z - h(x, y) for the hills of `hills()`; above is outside
struct Hills_function
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  static double height(const double x, const double y) { return 0.12 * std::sin(5 * x) * std::cos(4 * y); }

  FT operator()(const Point_3& p) const { return p.z() - height(p.x(), p.y()); }
  Vector_3 gradient(const Point_3& p) const
  {
    return Vector_3(-0.6 * std::cos(5 * p.x()) * std::cos(4 * p.y()), 0.48 * std::sin(5 * p.x()) * std::sin(4 * p.y()), 1);
  }
};

// --- Meshes ---

struct Soup
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

template <typename TriangleMesh = Mesh>
TriangleMesh to_mesh(const Soup& soup)
{
  TriangleMesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  return mesh;
}

// the icosahedron in the unit sphere, its faces divided in four `level` times: 20 * 4^level faces, looking outward
inline Soup icosphere_soup(const unsigned int level)
{
  const double g = 0.5 * (1 + std::sqrt(5.));
  Soup soup;
  const auto add = [&soup](const double x, const double y, const double z)
  {
    const double length = std::sqrt(x * x + y * y + z * z);
    soup.points.emplace_back(x / length, y / length, z / length);
    return soup.points.size() - 1;
  };
  for (const double s : {-1., 1.})
    for (const double t : {-g, g})
    {
      add(0, s, t);
      add(s, t, 0);
      add(t, 0, s);
    }
  // the faces are the triples of points at the distance of an edge
  const double squared_edge = 4 / (1 + g * g) * 1.0001;
  const std::vector<Point_3>& p = soup.points;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k)
        if (CGAL::squared_distance(p[i], p[j]) < squared_edge && CGAL::squared_distance(p[j], p[k]) < squared_edge &&
            CGAL::squared_distance(p[k], p[i]) < squared_edge)
        {
          const bool is_outward = CGAL::cross_product(p[j] - p[i], p[k] - p[i]) * (p[i] - CGAL::ORIGIN) > 0;
          soup.triangles.push_back(is_outward ? std::array<std::size_t, 3>{i, j, k} : std::array<std::size_t, 3>{i, k, j});
        }
  for (unsigned int l = 0; l < level; ++l)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
    const auto midpoint = [&](const std::size_t a, const std::size_t b)
    {
      const auto inserted = midpoints.emplace(std::minmax(a, b), soup.points.size());
      if (inserted.second)
      {
        const Vector_3 sum = (soup.points[a] - CGAL::ORIGIN) + (soup.points[b] - CGAL::ORIGIN);
        add(sum.x(), sum.y(), sum.z());
      }
      return inserted.first->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const std::array<std::size_t, 3>& t : soup.triangles)
    {
      const std::size_t a = midpoint(t[1], t[2]), b = midpoint(t[2], t[0]), c = midpoint(t[0], t[1]);
      finer.insert(finer.end(), {{t[0], c, b}, {t[1], a, c}, {t[2], b, a}, {a, b, c}});
    }
    soup.triangles.swap(finer);
  }
  return soup;
}

inline Soup scaled(Soup soup, const double x, const double y, const double z)
{
  for (Point_3& p : soup.points)
    p = Point_3(x * p.x(), y * p.y(), z * p.z());
  return soup;
}

inline Mesh icosphere(const unsigned int level, const double radius = 1)
{
  return to_mesh(scaled(icosphere_soup(level), radius, radius, radius));
}

// 20 * 4^level faces, vertices exactly on the ellipsoid
inline Mesh ellipsoid(const unsigned int level, const Ellipsoid_function& f = Ellipsoid_function())
{
  return to_mesh(scaled(icosphere_soup(level), f.a, f.b, f.c));
}

// a sphere with bumps of several sizes
inline Mesh bumpy_sphere(const unsigned int level)
{
  Mesh mesh = icosphere(level);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    const double height = 1 + 0.1 * std::sin(5 * p.x()) * std::cos(4 * p.y()) + 0.02 * std::sin(17 * p.z() + 3 * p.x());
    mesh.point(v) = CGAL::ORIGIN + height * p;
  }
  return mesh;
}

// 2 * around * across faces
inline Mesh torus(const std::size_t around, const std::size_t across, const Torus_function& f = Torus_function())
{
  Soup soup;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j)
    {
      const double u = 2 * pi * double(i) / double(around), v = 2 * pi * double(j) / double(across);
      const double radius = f.large_radius + f.small_radius * std::cos(v);
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), f.small_radius * std::sin(v));
      const std::size_t next_i = (i + 1) % around, next_j = (j + 1) % across;
      const std::size_t a = i * across + j, b = next_i * across + j, c = next_i * across + next_j, d = i * across + next_j;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return to_mesh(soup);
}

// open at both ends: two boundary circles, 2 * around * along faces
inline Mesh cylinder(const std::size_t around, const std::size_t along, const double height, const double radius = 1)
{
  Soup soup;
  for (std::size_t j = 0; j <= along; ++j)
    for (std::size_t i = 0; i < around; ++i)
    {
      const double u = 2 * pi * double(i) / double(around);
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), height * double(j) / double(along));
    }
  for (std::size_t j = 0; j < along; ++j)
    for (std::size_t i = 0; i < around; ++i)
    {
      const std::size_t next = (i + 1) % around;
      const std::size_t a = j * around + i, b = j * around + next, c = b + around, d = a + around;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return to_mesh(soup);
}

// the upper half of the unit sphere: rings of 6, 12, 18, ... vertices about the pole, the last of them the boundary;
// 6 * rings^2 faces
inline Soup half_sphere_soup(const std::size_t rings)
{
  Soup soup;
  soup.points.emplace_back(0, 0, 1);
  const auto index = [](const std::size_t ring, const std::size_t i)
  { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring); };
  for (std::size_t ring = 1; ring <= rings; ++ring)
  {
    const double polar = 0.5 * pi * double(ring) / double(rings);
    for (std::size_t i = 0; i < 6 * ring; ++i)
    {
      const double u = 2 * pi * double(i) / double(6 * ring);
      soup.points.emplace_back(std::sin(polar) * std::cos(u), std::sin(polar) * std::sin(u),
                               ring == rings ? 0. : std::cos(polar));
    }
    for (std::size_t side = 0; side < 6; ++side)
      for (std::size_t i = 0; i < ring; ++i)
      {
        const std::size_t outer = side * ring + i, inner = side * (ring - 1) + i;
        soup.triangles.push_back({index(ring, outer), index(ring, outer + 1), index(ring - 1, inner)});
        if (i + 1 < ring)
          soup.triangles.push_back({index(ring - 1, inner), index(ring, outer + 1), index(ring - 1, inner + 1)});
      }
  }
  return soup;
}

inline Mesh half_sphere(const std::size_t rings) { return to_mesh(half_sphere_soup(rings)); }

// a hilly landscape over the square [0,2]^2, looking up: one boundary curve with four corners, 2 * n^2 faces
inline Mesh hills(const std::size_t n)
{
  Soup soup;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double x = 2 * double(i) / double(n), y = 2 * double(j) / double(n);
      soup.points.emplace_back(x, y, Hills_function::height(x, y));
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return to_mesh(soup);
}

// a closed cylinder of radius 1 about the axis of z, from z = -1 to 1, with a sharp circle at either end: `rows` rows of squares
// around, vertices exactly on the circles, caps of rings about their centres; 2 * segments * (rows + 2 * rings - 1) faces
inline Mesh capped_cylinder(const unsigned int segments, const unsigned int rows)
{
  const std::size_t n = segments, rings = (std::max)(std::size_t(1), std::size_t(std::lround(n / (2 * pi))));
  Soup soup;
  const auto add_circle = [&](const double radius, const double z)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const double u = 2 * pi * double(i) / double(n);
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), z);
    }
  };
  // from the centre below over the side to the centre above
  soup.points.emplace_back(0, 0, -1);
  for (std::size_t k = 1; k < rings; ++k)
    add_circle(double(k) / double(rings), -1);
  for (std::size_t j = 0; j <= rows; ++j)
    add_circle(1, j == rows ? 1 : 2 * double(j) / double(rows) - 1);
  for (std::size_t k = rings - 1; k > 0; --k)
    add_circle(double(k) / double(rings), 1);
  soup.points.emplace_back(0, 0, 1);
  const std::size_t circles = (soup.points.size() - 2) / n, top = soup.points.size() - 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = (i + 1) % n;
    soup.triangles.push_back({0, 1 + next, 1 + i});
    for (std::size_t j = 0; j + 1 < circles; ++j)
    {
      const std::size_t a = 1 + j * n + i, b = 1 + j * n + next, c = b + n, d = a + n;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
    soup.triangles.push_back({top, top - n + i, top - n + next});
  }
  return to_mesh(soup);
}

// the union of unit cubes, each given by its least corner, with n x n squares on every side of a cube that is on the surface
inline Mesh union_of_cubes(const std::vector<std::array<int, 3>>& cubes, const unsigned int n)
{
  const int m = int(n);
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> indices;
  const auto index = [&](const std::array<int, 3>& p)
  {
    const auto inserted = indices.emplace(p, soup.points.size());
    if (inserted.second)
      soup.points.emplace_back(double(p[0]) / m, double(p[1]) / m, double(p[2]) / m);
    return inserted.first->second;
  };
  for (const std::array<int, 3>& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1})
      {
        std::array<int, 3> neighbor = cube;
        neighbor[axis] += 2 * side - 1;
        if (std::find(cubes.begin(), cubes.end(), neighbor) != cubes.end())
          continue;
        const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3, v = (axis + (side == 1 ? 2 : 1)) % 3; // (u, v, outward)
        for (int i = 0; i < m; ++i)
          for (int j = 0; j < m; ++j)
          {
            std::array<int, 3> a{m * cube[0], m * cube[1], m * cube[2]};
            a[axis] += m * side;
            a[u] += i;
            a[v] += j;
            std::array<int, 3> b = a, c = a, d = a;
            ++b[u], ++c[u], ++c[v], ++d[v];
            soup.triangles.push_back({index(a), index(b), index(c)});
            soup.triangles.push_back({index(a), index(c), index(d)});
          }
      }
  return to_mesh(soup);
}

// [0,1]^3, 12 * n^2 faces
inline Mesh cube(const unsigned int n) { return union_of_cubes({{{0, 0, 0}}}, n); }

// [0,2]^2 x [0,1] without [1,2]^2: eight sides, of which two are not convex; 28 * n^2 faces
inline Mesh l_block(const unsigned int n) { return union_of_cubes({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, n); }

// --- Little helpers ---

template <typename TriangleMesh>
double bounding_box_diagonal(const TriangleMesh& mesh)
{
  CGAL::Bbox_3 box;
  const auto vpm = get(CGAL::vertex_point, mesh);
  for (const auto v : vertices(mesh))
    box += get(vpm, v).bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// `n` points spread evenly over the unit sphere, at no vertex of an icosphere
inline std::vector<Point_3> spiral_points(const std::size_t n)
{
  std::vector<Point_3> points;
  const double golden_angle = pi * (3 - std::sqrt(5.));
  for (std::size_t i = 0; i < n; ++i)
  {
    const double z = 1 - (2 * double(i) + 1) / double(n), radius = std::sqrt(1 - z * z), u = golden_angle * double(i);
    points.emplace_back(radius * std::cos(u), radius * std::sin(u), z);
  }
  return points;
}

// what the std::invalid_argument says that `call` throws; empty if it throws none. Other exceptions pass.
template <typename Call>
std::string invalid_argument_message(const Call& call)
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

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace shapes

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_SHAPES_H
