// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_DEVIATION_BOUND_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_DEVIATION_BOUND_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Surface_distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A bound on the distance between a triangle and the zero set. The distance is measured at the points of a regular grid of the
// triangle. Between the points a definite quadratic form differs from its linear interpolation by at most 1/6 of its largest
// second difference over the small edges of the grid. Three times as much is added, half of the largest second difference. So
// the bound holds as long as the second derivatives nowhere exceed three times the largest measured one. The grid is refined
// until the bound is small enough, a point is too far away, or the grid is the finest one. Where no way along the gradient
// leads to the zero set, the distance to `other` counts. This function object knows another approximation of the surface.
template <typename Function, typename Other_distance>
class Deviation_bound
{
  static constexpr int coarsest = 4, finest = 32; // small edges along an edge
  static constexpr double share_of_second_difference = 0.5;

public:
  Deviation_bound(const Function& function, const Other_distance& other) : m_distance(function), m_other(other) {}

  double operator()(const Vector& a, const Vector& b, const Vector& c, const double allowed) const
  {
    const double reach = longest_edge(a, b, c);
    // no point of the triangle is further from its nearest vertex than the circumradius of an equilateral triangle of the
    // longest edge
    double bound = (std::max)({distance(a, reach), distance(b, reach), distance(c, reach)}) + reach / std::sqrt(3.);
    if (bound <= allowed)
      return bound;
    for (int n = coarsest; n <= finest; n *= 2)
    {
      const Grid grid(n, a, b, c, [&](const Vector& p) { return signed_distance(p, reach); });
      bound = grid.largest() + share_of_second_difference * grid.largest_second_difference();
      if (bound <= allowed || grid.largest() > allowed)
        break;
    }
    return bound;
  }

  // the distance at the centroid and at the middles of the edges only; the vertices lie on the surface
  double estimate(const Vector& a, const Vector& b, const Vector& c) const
  {
    const double reach = longest_edge(a, b, c);
    double largest = 0;
    for (const Vector& p : {Vector((a + b + c) / 3), Vector((a + b) / 2), Vector((b + c) / 2), Vector((c + a) / 2)})
      largest = (std::max)(largest, distance(p, reach));
    return largest;
  }

  // the distance of a point; ways to the zero set that are longer than `reach` do not count
  double distance(const Vector& p, const double reach) const { return std::abs(signed_distance(p, reach)); }

private:
  double signed_distance(const Vector& p, const double reach) const
  {
    const double distance = m_distance(p, reach).distance;
    return std::isfinite(distance) ? distance : m_other(p);
  }

  static double longest_edge(const Vector& a, const Vector& b, const Vector& c)
  {
    return std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  }

  // signed distances at ((n - i - j) a + i b + j c) / n
  class Grid
  {
  public:
    template <typename Distance>
    Grid(const int n, const Vector& a, const Vector& b, const Vector& c, const Distance& distance)
      : m_n(n), m_values(std::size_t((n + 1) * (n + 2) / 2))
    {
      for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j)
        {
          value(i, j) = distance((double(n - i - j) * a + double(i) * b + double(j) * c) / n);
          m_largest = (std::max)(m_largest, std::abs(value(i, j)));
        }
    }

    double largest() const { return m_largest; }

    double largest_second_difference() const
    {
      double largest = 0;
      const auto look = [&](const int i, const int j, const int di, const int dj)
      {
        if (i - di < 0 || j - dj < 0 || i + di < 0 || j + dj < 0 || i + di + j + dj > m_n || i - di + j - dj > m_n)
          return;
        largest = (std::max)(largest, std::abs(value(i - di, j - dj) - 2 * value(i, j) + value(i + di, j + dj)));
      };
      for (int i = 0; i <= m_n; ++i)
        for (int j = 0; i + j <= m_n; ++j)
        {
          look(i, j, 1, 0);
          look(i, j, 0, 1);
          look(i, j, 1, -1);
        }
      return largest;
    }

  private:
    // row by row of the triangle
    std::size_t index(const int i, const int j) const { return std::size_t(i * (m_n + 1) - i * (i - 1) / 2 + j); }
    double& value(const int i, const int j) { return m_values[index(i, j)]; }
    double value(const int i, const int j) const { return m_values[index(i, j)]; }

    int m_n;
    std::vector<double> m_values;
    double m_largest = 0;
  };

  const Surface_distance<Function> m_distance;
  const Other_distance& m_other;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_DEVIATION_BOUND_H
