// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Shapes whose meshes have something wrong, or that are seldom thought of: cracks, walls, faces without area, outlines, noise.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FLAWED_SHAPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FLAWED_SHAPES_H

#include "awkward_shapes.h"
#include "polygon_soups.h"
#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace flawed_shapes {

using polygon_soups::Polygon_soup;
using shapes::Mesh;
using shapes::pi;
using shapes::Point_3;
using shapes::Soup;

// each polygon has points of its own, rounded
template <typename Rounded>
Polygon_soup torn(const Polygon_soup& soup, const Rounded& rounded)
{
  Polygon_soup result;
  for (const auto& polygon : soup.polygons)
  {
    result.polygons.emplace_back();
    for (const std::size_t i : polygon)
    {
      const Point_3& p = soup.points[i];
      result.polygons.back().push_back(result.points.size());
      result.points.push_back(Point_3(rounded(p.x()), rounded(p.y()), rounded(p.z())));
    }
  }
  return result;
}

// `rings` rings of `sides` points about the first one; height and radius are those of the outermost ring at an angle
template <typename Radius, typename Height>
Mesh rings(const std::size_t sides, const std::size_t number, const Radius& radius, const Height& height)
{
  Soup soup;
  soup.points.push_back(Point_3(0, 0, 0));
  for (std::size_t k = 1; k <= number; ++k)
    for (std::size_t i = 0; i < sides; ++i)
    {
      const double angle = 2 * pi * double(i) / double(sides), t = double(k) / double(number), r = t * radius(angle);
      soup.points.push_back(Point_3(r * std::cos(angle), r * std::sin(angle), height(t, angle)));
    }
  const auto point = [&](const std::size_t k, const std::size_t i) { return 1 + (k - 1) * sides + i % sides; };
  for (std::size_t i = 0; i < sides; ++i)
  {
    soup.triangles.push_back({0, point(1, i), point(1, i + 1)});
    for (std::size_t k = 1; k < number; ++k)
    {
      soup.triangles.push_back({point(k, i), point(k + 1, i), point(k + 1, i + 1)});
      soup.triangles.push_back({point(k, i), point(k + 1, i + 1), point(k, i + 1)});
    }
  }
  return shapes::to_mesh(soup);
}

inline Mesh disk(const std::size_t sides, const std::size_t number)
{
  return rings(
      sides, number, [](double) { return 1.; }, [](double, double) { return 0.; });
}

inline Mesh wavy_bowl(const std::size_t sides, const std::size_t number)
{
  return rings(
      sides, number, [](double) { return 1.; },
      [](const double t, const double angle) { return 0.6 * t * t + 0.1 * t * t * std::cos(6 * angle); });
}

// two closed cubes, n x n squares a side, which share the points of a side, but not its faces
inline Soup cubes_with_wall(const unsigned int n)
{
  Soup soup;
  const Mesh cube = shapes::cube(n);
  for (const double shift : {0., 1.})
  {
    Soup other;
    for (const auto v : cube.vertices())
      other.points.push_back(cube.point(v));
    for (const auto f : cube.faces())
    {
      std::array<std::size_t, 3> t;
      std::size_t k = 0;
      for (const auto v : cube.vertices_around_face(cube.halfedge(f)))
        t[k++] = std::size_t(v);
      other.triangles.push_back(t);
    }
    awkward_shapes::append(soup, other, shapes::Vector_3(shift, 0, 0));
  }
  return soup;
}

// A tetrahedron, two sides of which are one quadrangle, whose shorter diagonal is the edge that they do not have in common.
inline Polygon_soup quadrangle_with_edge_for_diagonal()
{
  return Polygon_soup{{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 1, -0.5), Point_3(0.5, -1, -0.5)},
                      {{0, 2, 1, 3}, {0, 3, 1}, {0, 1, 2}}};
}

// edges of a sphere have a vertex in the middle, which one of both faces does not know: between them is a face without area
inline Mesh sphere_with_flat_faces()
{
  const Mesh sphere = shapes::icosphere(3);
  Soup soup;
  std::vector<bool> is_changed(sphere.number_of_faces(), false);
  for (const auto v : sphere.vertices())
    soup.points.push_back(sphere.point(v));
  const auto index = [&](const Mesh::Vertex_index v) { return std::size_t(v); };
  for (const auto e : sphere.edges())
  {
    const auto h = sphere.halfedge(e), o = sphere.opposite(h);
    const std::size_t f = std::size_t(sphere.face(h)), g = std::size_t(sphere.face(o));
    if (std::size_t(e) % 7 != 0 || is_changed[f] || is_changed[g])
      continue;
    is_changed[f] = is_changed[g] = true;
    const std::size_t a = index(sphere.source(h)), b = index(sphere.target(h)), c = index(sphere.target(sphere.next(h))),
                      d = index(sphere.target(sphere.next(o))), m = soup.points.size();
    soup.points.push_back(CGAL::midpoint(soup.points[a], soup.points[b]));
    soup.triangles.push_back({a, m, c});
    soup.triangles.push_back({m, b, c});
    soup.triangles.push_back({a, b, m});
    soup.triangles.push_back({b, a, d});
  }
  for (const auto f : sphere.faces())
    if (!is_changed[std::size_t(f)])
    {
      const auto h = sphere.halfedge(f);
      soup.triangles.push_back({index(sphere.source(h)), index(sphere.target(h)), index(sphere.target(sphere.next(h)))});
    }
  return shapes::to_mesh(soup);
}

// one face of a sphere is divided at the middle of an edge, and the one beside it is not
inline Soup sphere_with_t_junction()
{
  Soup soup = shapes::icosphere_soup(2);
  const auto t = soup.triangles.back();
  const std::size_t m = soup.points.size();
  soup.points.push_back(CGAL::midpoint(soup.points[t[0]], soup.points[t[1]]));
  soup.triangles.back() = {t[0], m, t[2]};
  soup.triangles.push_back({m, t[1], t[2]});
  return soup;
}

// a landscape whose triangles are a thousand times smaller in the middle, at a small hump, than at its rim
inline Mesh hump(const std::size_t n)
{
  Soup soup;
  const auto place = [&](const std::size_t i)
  {
    const double t = 2 * double(i) / double(n) - 1;
    return 5 * (t < 0 ? -1. : 1.) * (std::exp(std::abs(t) * std::log(1000.)) - 1) / 999;
  };
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double x = place(i), y = place(j);
      soup.points.push_back(Point_3(x, y, 0.3 * std::exp(-2 * (x * x + y * y))));
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return shapes::to_mesh(soup);
}

// the cells of a grid of n^3 for which `is_inside` holds, as the squares of two triangles around them; points are merged
template <typename Is_inside>
Soup voxels(const int n, const Is_inside& is_inside)
{
  Soup soup;
  std::vector<std::size_t> indices(std::size_t((n + 1) * (n + 1) * (n + 1)), std::size_t(-1));
  const auto index = [&](const std::array<int, 3>& p)
  {
    std::size_t& i = indices[std::size_t((p[0] * (n + 1) + p[1]) * (n + 1) + p[2])];
    if (i == std::size_t(-1))
    {
      i = soup.points.size();
      soup.points.push_back(Point_3(p[0], p[1], p[2]));
    }
    return i;
  };
  const auto has = [&](const std::array<int, 3>& c)
  {
    for (const int x : c)
      if (x < 0 || x >= n)
        return false;
    return is_inside(c);
  };
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (std::size_t axis = 0; axis < 3 && has({x, y, z}); ++axis)
          for (const int side : {0, 1})
          {
            std::array<int, 3> a{x, y, z}, neighbor = a;
            neighbor[axis] += 2 * side - 1;
            if (has(neighbor))
              continue;
            a[axis] += side;
            std::array<int, 3> b = a, c = a, d = a;
            const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3, v = (axis + (side == 1 ? 2 : 1)) % 3;
            ++b[u], ++c[u], ++c[v], ++d[v];
            soup.triangles.push_back({index(a), index(b), index(c)});
            soup.triangles.push_back({index(a), index(c), index(d)});
          }
  return soup;
}

inline Mesh voxel_ball(const int n)
{
  const double middle = 0.5 * double(n - 1);
  return shapes::to_mesh(voxels(n,
                                [&](const std::array<int, 3>& c)
                                {
                                  double squared = 0;
                                  for (const int x : c)
                                    squared += (x - middle) * (x - middle);
                                  return squared <= 0.25 * n * n;
                                }));
}

// cells of a grid by chance: sheets that touch, handles, hundreds of pieces
inline Polygon_soup noise(const int n)
{
  std::mt19937 random(3);
  std::vector<bool> is_inside;
  for (int i = 0; i < n * n * n; ++i)
    is_inside.push_back(random() % 2 == 0);
  return polygon_soups::to_polygons(
      voxels(n, [&](const std::array<int, 3>& c) { return bool(is_inside[std::size_t((c[0] * n + c[1]) * n + c[2])]); }));
}

} // namespace flawed_shapes

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FLAWED_SHAPES_H
