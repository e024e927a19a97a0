// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_FOLDED_EDGE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_FOLDED_EDGE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The normal of a triangle by two of its edges, of the length of twice the area. It is zero if the height of the triangle is so
// small that its direction would be due to rounding. Such a triangle folds over no edge.
inline Vector triangle_normal(const Vector& ab, const Vector& ac)
{
  static constexpr double smallest_flatness = 1e-10; // of the height to the longest edge
  const Vector normal = ab.cross(ac);
  const double squared_length = (std::max)({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  const double smallest = smallest_flatness * squared_length;
  return normal.squaredNorm() > smallest * smallest ? normal : Vector(Vector::Zero());
}

// Two faces count as folded over their edge if the cosine of the angle between their normals is below this: 143 degrees.
constexpr double fold_cosine = -0.8;

// by their normals of any length
inline bool is_folded_edge(const Vector& normal, const Vector& neighbor)
{
  const double product = normal.dot(neighbor);
  return product < 0 && // hardly ever
         product < fold_cosine * (normal.norm() * neighbor.norm());
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_FOLDED_EDGE_H
