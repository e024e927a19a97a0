// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_ASPECT_RATIO_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_ASPECT_RATIO_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// R / (2 r) of a triangle of three points that are not collinear: 1 for the equilateral one. PMP's face_aspect_ratio() is another
// measure, the longest edge over the least height.
inline double aspect_ratio(const Vector& p, const Vector& q, const Vector& r)
{
  // Edges are relative to the longest one. So no product overflows or vanishes, whatever the unit of the mesh. The cross
  // product of the two shorter edges has the least cancellation.
  std::array<Vector, 3> sides = {q - p, r - q, p - r};
  const double scale = (std::max)({sides[0].norm(), sides[1].norm(), sides[2].norm()});
  if (!(scale > 0))
    return std::numeric_limits<double>::infinity();
  std::array<double, 3> lengths;
  for (int i = 0; i < 3; ++i)
  {
    sides[i] /= scale;
    lengths[i] = sides[i].norm();
  }
  const int longest = lengths[0] >= lengths[1] ? (lengths[0] >= lengths[2] ? 0 : 2) : (lengths[1] >= lengths[2] ? 1 : 2);
  const double squared_area_4 = sides[(longest + 1) % 3].cross(sides[(longest + 2) % 3]).squaredNorm(); // 4 A^2
  if (!(squared_area_4 > 0))
    return std::numeric_limits<double>::infinity();
  return lengths[0] * lengths[1] * lengths[2] * (lengths[0] + lengths[1] + lengths[2]) / (4 * squared_area_4);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_ASPECT_RATIO_H
