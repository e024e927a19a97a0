// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Shapes as CAD programs write them: many sides, few rings, ends and holes divided into needles.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_CAD_SHAPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_CAD_SHAPES_H

#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cad_shapes {

typedef std::size_t Index;

// A surface of revolution about the z-axis. The profile has points (radius, z), from which `sides` straight sides go around.
// A point of radius 0 is one vertex.
class Revolved
{
public:
  explicit Revolved(const Index sides) : m_sides(sides) {}

  // a circle of vertices, or one vertex on the axis
  void add_circle(const double radius, const double z)
  {
    m_begins.push_back(m_soup.points.size());
    for (Index i = 0; i < (radius > 0 ? m_sides : 1); ++i)
    {
      const double angle = 2 * shapes::pi * double(i) / double(m_sides);
      m_soup.points.push_back(shapes::Point_3(radius * std::cos(angle), radius * std::sin(angle), z));
    }
    m_ends.push_back(m_soup.points.size());
  }

  // two triangles for each side between two circles; outside is to the right of the way from `a` to `b`
  void join(const Index a, const Index b)
  {
    for (Index i = 0; i < m_sides; ++i)
    {
      const Index p = vertex(a, i), q = vertex(a, i + 1), r = vertex(b, i), s = vertex(b, i + 1);
      if (p != q)
        m_soup.triangles.push_back({p, q, s});
      if (r != s)
        m_soup.triangles.push_back({p, s, r});
    }
  }

  // circles at equal distances between two points of the profile, without the first
  void go_on(const double radius, const double z, const double radius_before, const double z_before, const Index bands)
  {
    for (Index k = 1; k <= bands; ++k)
    {
      const double t = double(k) / double(bands);
      add_circle(radius_before + t * (radius - radius_before), z_before + t * (z - z_before));
      join(m_begins.size() - 2, m_begins.size() - 1);
    }
  }

  // a fan of needles from the first vertex of a circle
  void close(const Index circle, const bool is_above)
  {
    for (Index i = 1; i + 1 < m_sides; ++i)
    {
      const Index p = vertex(circle, 0), q = vertex(circle, i), r = vertex(circle, i + 1);
      if (is_above)
        m_soup.triangles.push_back({p, q, r});
      else
        m_soup.triangles.push_back({p, r, q});
    }
  }

  Index last_circle() const { return m_begins.size() - 1; }

  shapes::Mesh mesh() const { return shapes::to_mesh(m_soup); }

private:
  Index vertex(const Index circle, const Index i) const { return m_begins[circle] + i % (m_ends[circle] - m_begins[circle]); }

  Index m_sides;
  shapes::Soup m_soup;
  std::vector<Index> m_begins, m_ends; // of the circles
};

// the side of a cylinder of radius 1, or with both ends
inline shapes::Mesh cylinder(const Index sides, const Index bands, const bool is_closed)
{
  Revolved result(sides);
  result.add_circle(1, 0);
  result.go_on(1, 4, 1, 0, bands);
  if (is_closed)
  {
    result.close(0, false);
    result.close(result.last_circle(), true);
  }
  return result.mesh();
}

// a cylinder of radius 1 with a bore of radius 0.7
inline shapes::Mesh tube(const Index sides, const Index bands)
{
  Revolved result(sides);
  result.add_circle(1, 0);
  result.go_on(1, 4, 1, 0, bands);
  result.go_on(0.7, 4, 1, 4, 1);
  result.go_on(0.7, 0, 0.7, 4, bands);
  result.join(result.last_circle(), 0);
  return result.mesh();
}

// the side of a cone, from radius 1 to 0.25
inline shapes::Mesh cone(const Index sides, const Index bands)
{
  Revolved result(sides);
  result.add_circle(1, 0);
  result.go_on(0.25, 3, 1, 0, bands);
  return result.mesh();
}

// A plate of 4 x 4 x 0.5 with a round hole of radius 1. Each side of the square is joined to a quarter of the hole by needles.
inline shapes::Mesh plate(const Index quarter)
{
  const Index sides = 4 * quarter;
  shapes::Soup soup;
  const double pi = shapes::pi;
  for (const double z : {0., 0.5})
  {
    for (Index i = 0; i < sides; ++i)
      soup.points.push_back(
          shapes::Point_3(std::cos(2 * pi * double(i) / double(sides)), std::sin(2 * pi * double(i) / double(sides)), z));
    for (const double angle : {1., 3., 5., 7.})
      soup.points.push_back(
          shapes::Point_3(2 * std::sqrt(2.) * std::cos(angle * pi / 4), 2 * std::sqrt(2.) * std::sin(angle * pi / 4), z));
  }
  const auto hole = [&](const Index level, const Index i) { return level * (sides + 4) + i % sides; };
  const auto corner = [&](const Index level, const Index i) { return level * (sides + 4) + sides + i % 4; };
  const auto add = [&](const Index a, const Index b, const Index c, const bool is_turned) {
    soup.triangles.push_back(is_turned ? std::array<std::size_t, 3>{a, c, b} : std::array<std::size_t, 3>{a, b, c});
  };
  for (const Index level : {Index(0), Index(1)})
    for (Index k = 0; k < 4; ++k)
    {
      for (Index i = k * quarter; i < (k + 1) * quarter; ++i)
        add(hole(level, i), corner(level, k), hole(level, i + 1), level == 0);
      add(hole(level, (k + 1) * quarter), corner(level, k), corner(level, k + 1), level == 0);
    }
  for (Index i = 0; i < sides; ++i)
  {
    add(hole(0, i), hole(1, i), hole(1, i + 1), false);
    add(hole(0, i), hole(1, i + 1), hole(0, i + 1), false);
  }
  for (Index k = 0; k < 4; ++k)
  {
    add(corner(0, k), corner(0, k + 1), corner(1, k + 1), false);
    add(corner(0, k), corner(1, k + 1), corner(1, k), false);
  }
  return shapes::to_mesh(soup);
}

// how far the circle is from the middle of a side
inline double chord_height(const Index sides) { return 1 - std::cos(shapes::pi / double(sides)); }

} // namespace cad_shapes

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_CAD_SHAPES_H
