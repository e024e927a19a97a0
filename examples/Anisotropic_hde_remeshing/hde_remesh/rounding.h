// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How exact the coordinates of a file are.

#ifndef HDE_REMESH_ROUNDING_H
#define HDE_REMESH_ROUNDING_H

#include "Soup.h"
#include "Text_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hde_remesh {

inline double largest_coordinate(const std::vector<Point_3>& points)
{
  double largest = 0;
  for (const Point_3& p : points)
    for (int i = 0; i < 3; ++i)
      largest = (std::max)(largest, std::abs(p[i]));
  return largest;
}

// the unit in the last place of the largest coordinate, as numbers of this type
template <typename Float>
double unit_in_last_place(const std::vector<Point_3>& points)
{
  const double largest = largest_coordinate(points);
  return largest > 0 ? std::ldexp(double(std::numeric_limits<Float>::epsilon()), std::ilogb(largest)) : 0;
}

inline double rounding_of_floats(const std::vector<Point_3>& points) { return unit_in_last_place<float>(points); }
inline double rounding_of_doubles(const std::vector<Point_3>& points) { return unit_in_last_place<double>(points); }

// Whether all coordinates are floats, up to half of the unit in their last place. So it is if a program has computed in float, however
// many digits its file has. Of other numbers hardly any is one by chance.
template <typename Unit>
bool are_floats(const std::vector<Point_3>& points, const Unit& unit_in_last_place)
{
  for (const Point_3& p : points)
    for (int i = 0; i < 3; ++i)
    {
      const double x = p[i];
      if (!(std::abs(x - static_cast<double>(static_cast<float>(x))) <= 0.5 * unit_in_last_place(std::abs(x))))
        return false;
    }
  return true;
}

// of binary numbers in double, which may come from floats
inline double rounding_of_binary_doubles(const std::vector<Point_3>& points)
{
  return are_floats(points, [](double) { return 0.; }) ? rounding_of_floats(points) : rounding_of_doubles(points);
}

// as the numbers of the text are written, or as the floats that they come from
inline double rounding_of_text(const std::vector<Point_3>& points, const Text_reader& reader)
{
  const auto unit = [&](const double size) { return reader.unit_in_last_place(size); };
  const double rounding = (std::max)(rounding_of_doubles(points), unit(largest_coordinate(points)));
  return are_floats(points, unit) ? (std::max)(rounding, rounding_of_floats(points)) : rounding;
}

} // namespace hde_remesh

#endif // HDE_REMESH_ROUNDING_H
