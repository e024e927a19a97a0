// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Shapes as CAD programs write them: many sides, few rings, ends and holes divided into needles.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CAD_SHAPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CAD_SHAPES_H

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace cad_shapes {

typedef std::size_t Index;

using shapes::Point_3;
using shapes::Vector_3;

// Closed polygons one after the other, joined by straight sides: a surface of revolution, a tube along a curve, or a bar. A polygon
// may be one point. Outside is to the right of the way from one to the next, for who sees the polygon turn to the left.
class Rings
{
public:
  typedef std::vector<Point_3> Polygon;

  void add(const Polygon& polygon)
  {
    m_begins.push_back(m_soup.points.size());
    m_soup.points.insert(m_soup.points.end(), polygon.begin(), polygon.end());
    m_ends.push_back(m_soup.points.size());
  }

  // two triangles for each side between two polygons
  void join(const Index a, const Index b)
  {
    const Index sides = (std::max)(size(a), size(b));
    for (Index i = 0; i < sides; ++i)
    {
      const Index p = vertex(a, i), q = vertex(a, i + 1), r = vertex(b, i), s = vertex(b, i + 1);
      if (p != q)
        m_soup.triangles.push_back({p, q, s});
      if (r != s)
        m_soup.triangles.push_back({p, s, r});
    }
  }

  // polygons at equal distances from the last one to this one
  void go_on(const Polygon& polygon, const Index bands)
  {
    const Index before = last();
    for (Index k = 1; k <= bands; ++k)
    {
      Polygon between = polygon;
      if (k < bands)
        for (Index i = 0; i < between.size(); ++i)
        {
          const Point_3 from = m_soup.points[vertex(before, i)];
          between[i] = from + double(k) / double(bands) * (polygon[i] - from);
        }
      add(between);
      join(last() - 1, last());
    }
  }

  // a fan of needles from the first vertex of a polygon
  void close(const Index polygon, const bool is_above)
  {
    for (Index i = 1; i + 1 < size(polygon); ++i)
    {
      const Index p = vertex(polygon, 0), q = vertex(polygon, i), r = vertex(polygon, i + 1);
      if (is_above)
        m_soup.triangles.push_back({p, q, r});
      else
        m_soup.triangles.push_back({p, r, q});
    }
  }

  void close_both()
  {
    close(0, false);
    close(last(), true);
  }

  Index last() const { return m_begins.size() - 1; }

  shapes::Mesh mesh() const { return shapes::to_mesh(m_soup); }

private:
  Index size(const Index polygon) const { return m_ends[polygon] - m_begins[polygon]; }
  Index vertex(const Index polygon, const Index i) const { return m_begins[polygon] + i % size(polygon); }

  shapes::Soup m_soup;
  std::vector<Index> m_begins, m_ends; // of the polygons
};

// about the z-axis; one point if the radius is 0
inline Rings::Polygon circle(const Index sides, const double radius, const double z)
{
  Rings::Polygon result;
  for (Index i = 0; i < (radius > 0 ? sides : 1); ++i)
  {
    const double angle = 2 * shapes::pi * double(i) / double(sides);
    result.push_back(Point_3(radius * std::cos(angle), radius * std::sin(angle), z));
  }
  return result;
}

// the side of a cylinder of radius 1, or with both ends
inline shapes::Mesh cylinder(const Index sides, const Index bands, const bool is_closed)
{
  Rings result;
  result.add(circle(sides, 1, 0));
  result.go_on(circle(sides, 1, 4), bands);
  if (is_closed)
    result.close_both();
  return result.mesh();
}

// a cylinder of radius 1 with a bore of radius 0.7
inline shapes::Mesh tube(const Index sides, const Index bands)
{
  Rings result;
  result.add(circle(sides, 1, 0));
  result.go_on(circle(sides, 1, 4), bands);
  result.go_on(circle(sides, 0.7, 4), 1);
  result.go_on(circle(sides, 0.7, 0), bands);
  result.join(result.last(), 0);
  return result.mesh();
}

// the side of a cone, from radius 1 to 0.25
inline shapes::Mesh cone(const Index sides, const Index bands)
{
  Rings result;
  result.add(circle(sides, 1, 0));
  result.go_on(circle(sides, 0.25, 3), bands);
  return result.mesh();
}

// a closed cone of radius 1 with its tip at z = 3
inline shapes::Mesh cone_with_tip(const Index sides, const Index bands)
{
  Rings result;
  result.add(circle(sides, 1, 0));
  if (bands > 1)
    result.go_on(circle(sides, 1 / double(bands), 3 - 3 / double(bands)), bands - 1);
  result.go_on(circle(sides, 0, 3), 1);
  result.close(0, false);
  return result.mesh();
}

// a pipe of radius 1: straight for 4, a quarter of a circle of radius 2.5 in 8 bands, and straight again
inline shapes::Mesh elbow(const Index sides, const Index bands, const bool is_closed)
{
  const double bend = 2.5, length = 4;
  const Rings::Polygon section = circle(sides, 1, 0);
  // the section at an angle of the bend, so far beyond it
  const auto at = [&](const double angle, const double beyond)
  {
    Rings::Polygon result;
    const double c = std::cos(angle), s = std::sin(angle);
    for (const Point_3& p : section)
    {
      const double out = bend + p.x();
      result.push_back(Point_3(out * c - beyond * s, -p.y(), -out * s - beyond * c));
    }
    return result;
  };
  Rings result;
  result.add(at(0, -length));
  result.go_on(at(0, 0), bands);
  for (Index k = 1; k <= 8; ++k)
    result.go_on(at(double(k) * shapes::pi / 16, 0), 1);
  result.go_on(at(shapes::pi / 2, length), bands);
  if (is_closed)
    result.close_both();
  return result.mesh();
}

// a bar of 4 x 2 x 12, whose long edges are rounded by fillets of radius 0.5, of so many sides each
inline shapes::Mesh bar_with_fillets(const Index sides_of_fillet, const Index bands)
{
  const auto section = [&](const double z)
  {
    Rings::Polygon result;
    for (Index quarter = 0; quarter < 4; ++quarter)
      for (Index i = 0; i <= sides_of_fillet; ++i)
      {
        const double angle = shapes::pi / 2 * (double(quarter) + double(i) / double(sides_of_fillet));
        const double x = quarter == 0 || quarter == 3 ? 1.5 : -1.5, y = quarter < 2 ? 0.5 : -0.5;
        result.push_back(Point_3(x + 0.5 * std::cos(angle), y + 0.5 * std::sin(angle), z));
      }
    return result;
  };
  Rings result;
  result.add(section(0));
  result.go_on(section(12), bands);
  result.close_both();
  return result.mesh();
}

// A plate of 0.5, with a round hole of radius 1 in each square of 4 x 4 in a row. Each side of a square is joined to a quarter of the
// hole by needles.
inline shapes::Mesh plate(const Index quarter, const Index number_of_holes = 1)
{
  const Index sides = 4 * quarter;
  shapes::Soup soup;
  std::map<std::pair<long, long>, Index> corners[2]; // of both levels, by their coordinates
  const auto corner = [&](const Index level, const Index square, const Index k)
  {
    const long x = 4 * long(square) + (k % 4 == 0 || k % 4 == 3 ? 2 : -2), y = k % 4 < 2 ? 2 : -2;
    const auto inserted = corners[level].emplace(std::make_pair(x, y), soup.points.size());
    if (inserted.second)
      soup.points.push_back(Point_3(double(x), double(y), 0.5 * double(level)));
    return inserted.first->second;
  };
  const auto add = [&](const Index a, const Index b, const Index c) { soup.triangles.push_back({a, b, c}); };
  for (Index square = 0; square < number_of_holes; ++square)
  {
    Index begins[2];
    for (const Index level : {Index(0), Index(1)})
    {
      begins[level] = soup.points.size();
      for (const Point_3& p : circle(sides, 1, 0.5 * double(level)))
        soup.points.push_back(p + Vector_3(4 * double(square), 0, 0));
    }
    const auto hole = [&](const Index level, const Index i) { return begins[level] + i % sides; };
    for (Index k = 0; k < 4; ++k)
    {
      for (Index i = k * quarter; i < (k + 1) * quarter; ++i)
      {
        add(hole(1, i), corner(1, square, k), hole(1, i + 1));
        add(hole(0, i), hole(0, i + 1), corner(0, square, k));
        add(hole(0, i), hole(1, i), hole(1, i + 1));
        add(hole(0, i), hole(1, i + 1), hole(0, i + 1));
      }
      add(hole(1, (k + 1) * quarter), corner(1, square, k), corner(1, square, k + 1));
      add(hole(0, (k + 1) * quarter), corner(0, square, k + 1), corner(0, square, k));
      const bool is_inside = (k == 1 && square > 0) || (k == 3 && square + 1 < number_of_holes);
      if (is_inside)
        continue;
      add(corner(0, square, k), corner(0, square, k + 1), corner(1, square, k + 1));
      add(corner(0, square, k), corner(1, square, k + 1), corner(1, square, k));
    }
  }
  return shapes::to_mesh(soup);
}

// how far the circle is from the middle of a side
inline double chord_height(const Index sides) { return 1 - std::cos(shapes::pi / double(sides)); }

} // namespace cad_shapes

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CAD_SHAPES_H
