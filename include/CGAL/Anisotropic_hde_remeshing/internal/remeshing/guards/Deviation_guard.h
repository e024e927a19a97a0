// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_DEVIATION_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_DEVIATION_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Surface_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// With an error as the target, no contraction and no flip may make a face whose centroid is too far from the surface. Such a
// face may have cut off a thin part, and no refinement restores that part. Without an error as the target, all faces are
// accepted.
template <typename Function>
class Deviation_guard
{
public:
  explicit Deviation_guard(const Function& function)
  {
    for (std::size_t i = 0; i < number_of_pieces(function); ++i)
      m_distances.emplace_back(piece(function, Region(i)));
  }

  // before this call the guard accepts all faces
  void set_largest_distance(const double distance) { m_largest = distance; }

  double largest_distance() const { return m_largest; }

  bool is_active() const { return std::isfinite(m_largest); }

  bool accepts(const Vertex_state& a, const Vertex_state& b, const Vertex_state& c, const Region region) const
  {
    if (!is_active() || a.is_on_curve || b.is_on_curve || c.is_on_curve)
      return true; // curves need not lie on the surface
    const double reach = std::sqrt(
        (std::max)({(b.point - a.point).squaredNorm(), (c.point - b.point).squaredNorm(), (a.point - c.point).squaredNorm()}));
    const Surface_distance<Piece_of<Function>>& distance = m_distances[region];
    return std::abs(distance((a.point + b.point + c.point) / 3, reach).distance) <= m_largest; // false if there is no distance
  }

private:
  std::vector<Surface_distance<Piece_of<Function>>> m_distances; // by region
  double m_largest = (std::numeric_limits<double>::infinity)();
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_DEVIATION_GUARD_H
