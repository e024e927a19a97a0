// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Where a function vanishes, for tests and benchmarks of surfaces that must be closed and in one part.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_ZERO_SET_ON_GRID_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_ZERO_SET_ON_GRID_H

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// The zero set on a grid that reaches beyond the bounding sphere: the number of parts where the function is negative, and of those
// where it is not, and points of the zero set.
struct Zero_set_on_grid
{
  int negative_parts = 0, other_parts = 0;
  std::vector<shapes::Point_3> points;
};

template <typename F>
Zero_set_on_grid zero_set_on_grid(const F& f, const int n)
{
  using shapes::Point_3;
  using shapes::Vector_3;
  const auto sphere = f.bounding_sphere();
  const double radius = 1.1 * std::sqrt(sphere.squared_radius());
  const auto index = [n](const int i, const int j, const int k) { return (i * n + j) * n + k; };
  const auto at = [&](const int i, const int j, const int k)
  { return sphere.center() - Vector_3(radius, radius, radius) + 2 * radius / (n - 1) * Vector_3(i, j, k); };
  std::vector<char> is_negative(std::size_t(n * n * n)), is_seen(is_negative.size(), 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        is_negative[std::size_t(index(i, j, k))] = f(at(i, j, k)) < 0;
  Zero_set_on_grid result;
  for (int start = 0; start < n * n * n; ++start)
  {
    if (is_seen[std::size_t(start)])
      continue;
    ++(is_negative[std::size_t(start)] ? result.negative_parts : result.other_parts);
    std::vector<int> stack(1, start);
    is_seen[std::size_t(start)] = 1;
    while (!stack.empty())
    {
      const int here = stack.back(), i = here / n / n, j = here / n % n, k = here % n;
      stack.pop_back();
      const auto visit = [&](const int x, const int y, const int z)
      {
        if ((std::min)({x, y, z}) < 0 || (std::max)({x, y, z}) >= n)
          return;
        const std::size_t there = std::size_t(index(x, y, z));
        if (is_negative[there] != is_negative[std::size_t(here)])
        {
          if (!is_negative[there])
            return;
          Point_3 inside = at(x, y, z), outside = at(i, j, k);
          for (int step = 0; step < 30; ++step)
          {
            const Point_3 middle = CGAL::midpoint(inside, outside);
            (f(middle) < 0 ? inside : outside) = middle;
          }
          result.points.push_back(outside);
        }
        else if (!is_seen[there])
        {
          is_seen[there] = 1;
          stack.push_back(index(x, y, z));
        }
      };
      for (const int step : {-1, 1})
      {
        visit(i + step, j, k);
        visit(i, j + step, k);
        visit(i, j, k + step);
      }
    }
  }
  return result;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_ZERO_SET_ON_GRID_H
