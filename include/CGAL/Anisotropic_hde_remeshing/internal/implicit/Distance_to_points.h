// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_DISTANCE_TO_POINTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_DISTANCE_TO_POINTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The distance to the nearest of the first `n` points. The search tree is built at the first query, as most functions are never
// asked. Thread-safe.
class Distance_to_points
{
public:
  // keeps a reference to the points
  Distance_to_points(const std::vector<Vector>& points, const std::size_t n) : m_points(points), m_n(n) {}

  double operator()(const Vector& p) const
  {
    std::call_once(m_is_built,
                   [this] {
                     m_search = std::make_unique<Point_search>(
                         std::vector<Vector>(m_points.begin(), m_points.begin() + std::ptrdiff_t(m_n)));
                   });
    return std::sqrt(m_search->nearest(p, 1).front().first);
  }

private:
  const std::vector<Vector>& m_points;
  std::size_t m_n;
  mutable std::once_flag m_is_built;
  mutable std::unique_ptr<Point_search> m_search;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_DISTANCE_TO_POINTS_H
