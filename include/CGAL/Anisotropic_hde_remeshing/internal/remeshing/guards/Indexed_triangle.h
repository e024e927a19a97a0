// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INDEXED_TRIANGLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INDEXED_TRIANGLE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// a triangle of an oriented mesh; the numbers of its vertices tell which ones it shares with others
struct Indexed_triangle
{
  std::array<std::size_t, 3> vertices{};
  std::array<Vector, 3> points{};

  const Vector& point(const std::size_t i) const { return points[i % 3]; }
  Vector normal() const { return (points[1] - points[0]).cross(points[2] - points[0]); }

  double squared_length() const // of the longest edge
  {
    return (std::max)(
        {(points[1] - points[0]).squaredNorm(), (points[2] - points[1]).squaredNorm(), (points[0] - points[2]).squaredNorm()});
  }
};

inline bool have_common_vertex(const Indexed_triangle& s, const Indexed_triangle& t)
{
  for (const std::size_t i : s.vertices)
    for (const std::size_t k : t.vertices)
      if (i == k)
        return true;
  return false;
}

// Tells whether two triangles have more in common than the vertices and the edge that they share. Most pairs are told apart in
// doubles, where these leave no doubt. The others are told apart exactly. Triangles without area do not intersect
// others: only the input has them.
class Triangle_pair
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  // a product in doubles is exact to some 1e-15 of the product of the lengths
  static constexpr double rounding = 1e-12;

public:
  Triangle_pair(const Indexed_triangle& s, const Indexed_triangle& t) : m_s(s), m_t(t)
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (s.vertices[i] == t.vertices[k])
        {
          m_in_s[m_number_of_shared] = i;
          m_in_t[m_number_of_shared] = k;
          ++m_number_of_shared;
        }
  }

  bool do_intersect() const { return !are_clearly_apart() && do_intersect_exactly(); }

private:
  bool are_clearly_apart() const
  {
    switch (m_number_of_shared)
    {
    case 0:
      return is_clearly_beside(m_s, m_t) || is_clearly_beside(m_t, m_s);
    case 1:
      return is_plane_between();
    case 2: // where one lies on the other, their normals are opposite
      return m_s.normal().dot(m_t.normal()) > rounding * m_s.squared_length() * m_t.squared_length();
    default:
      return false;
    }
  }

  // whether t is on one side of the plane of s
  static bool is_clearly_beside(const Indexed_triangle& s, const Indexed_triangle& t)
  {
    const Vector normal = s.normal();
    const double error = rounding * s.squared_length();
    int side = 0;
    for (const Vector& p : t.points)
    {
      const Vector way = p - s.points[0];
      const double height = normal.dot(way), allowed = error * way.norm();
      if (!(std::abs(height) > allowed))
        return false;
      side += height > 0 ? 1 : -1;
    }
    return side == 3 || side == -3;
  }

  // Whether a plane through the shared vertex separates the triangles. The plane is perpendicular to the way from the middle of
  // one triangle to the middle of the other.
  bool is_plane_between() const
  {
    const Vector& v = m_s.points[m_in_s[0]];
    const Vector a = m_s.point(m_in_s[0] + 1) - v, b = m_s.point(m_in_s[0] + 2) - v, c = m_t.point(m_in_t[0] + 1) - v,
                 d = m_t.point(m_in_t[0] + 2) - v;
    const Vector s = a + b, t = c + d, across = t.norm() * s - s.norm() * t;
    const auto is_ahead = [&](const Vector& way, const double sign) { return sign * way.dot(across) > rounding * way.norm(); };
    return is_ahead(a, 1) && is_ahead(b, 1) && is_ahead(c, -1) && is_ahead(d, -1);
  }

  bool do_intersect_exactly() const
  {
    const Kernel::Triangle_3 s(point(m_s, 0), point(m_s, 1), point(m_s, 2)), t(point(m_t, 0), point(m_t, 1), point(m_t, 2));
    if (s.is_degenerate() || t.is_degenerate())
      return false;
    switch (m_number_of_shared)
    {
    case 0:
      return CGAL::do_intersect(s, t);
    case 1: // the sides opposite to the vertex
      return CGAL::do_intersect(s, Kernel::Segment_3(point(m_t, m_in_t[0] + 1), point(m_t, m_in_t[0] + 2))) ||
             CGAL::do_intersect(t, Kernel::Segment_3(point(m_s, m_in_s[0] + 1), point(m_s, m_in_s[0] + 2)));
    case 2: // they intersect in one plane and on one side of the edge
    {
      const Kernel::Point_3 a = point(m_s, m_in_s[0]), b = point(m_s, m_in_s[1]), c = point(m_s, 3 - m_in_s[0] - m_in_s[1]),
                            d = point(m_t, 3 - m_in_t[0] - m_in_t[1]);
      return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
    }
    default:
      return true;
    }
  }

  static Kernel::Point_3 point(const Indexed_triangle& triangle, const std::size_t i)
  {
    const Vector& p = triangle.point(i);
    return Kernel::Point_3(p[0], p[1], p[2]);
  }

  const Indexed_triangle &m_s, &m_t;
  std::array<std::size_t, 3> m_in_s{}, m_in_t{}; // the positions of the vertices that they share
  std::size_t m_number_of_shared = 0;
};

inline bool do_triangles_intersect(const Indexed_triangle& s, const Indexed_triangle& t)
{
  return Triangle_pair(s, t).do_intersect();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INDEXED_TRIANGLE_H
