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

// as the numbers of the text are written
inline double rounding_of_text(const std::vector<Point_3>& points, const Text_reader& reader)
{
  return (std::max)(rounding_of_doubles(points), reader.unit_in_last_place(largest_coordinate(points)));
}

} // namespace hde_remesh

#endif // HDE_REMESH_ROUNDING_H
