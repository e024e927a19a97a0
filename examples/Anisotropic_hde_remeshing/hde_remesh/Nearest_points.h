// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_NEAREST_POINTS_H
#define HDE_REMESH_NEAREST_POINTS_H

#include "Soup.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>

#include <cstddef>
#include <vector>

namespace hde_remesh {

// the points of a cloud that are the nearest to a place
class Nearest_points
{
public:
  explicit Nearest_points(const std::vector<Point_3>& points);

  std::size_t nearest(const Point_3& p) const;
  double distance(const Point_3& p) const;

private:
  CGAL::Anisotropic_hde_remeshing::internal::Point_search m_search;
};

// the median of the mean distances of a point to its six nearest neighbours, of some ten thousand points; 0 if all are equal
double median_spacing(const std::vector<Point_3>& points);

} // namespace hde_remesh

#endif // HDE_REMESH_NEAREST_POINTS_H
