// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Polylines as sets of segments.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_POLYLINES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_POLYLINES_H

#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shapes {

typedef std::vector<Kernel::Segment_3> Polyline;

inline double length(const Polyline& polyline)
{
  double sum = 0;
  for (const Kernel::Segment_3& s : polyline)
    sum += std::sqrt(s.squared_length());
  return sum;
}

// of the ends of the first from the second
inline double largest_distance(const Polyline& from, const Polyline& to)
{
  double result = 0;
  for (const Kernel::Segment_3& s : from)
    for (const Point_3& end : {s.source(), s.target()})
    {
      double least = 1e300;
      for (const Kernel::Segment_3& t : to)
        least = (std::min)(least, CGAL::squared_distance(end, t));
      result = (std::max)(result, least);
    }
  return std::sqrt(result);
}

} // namespace shapes

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_POLYLINES_H
