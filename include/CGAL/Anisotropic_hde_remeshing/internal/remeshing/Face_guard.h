// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_FACE_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_FACE_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What every operation asks of the faces that it makes: not folded over the surface, and not degenerate in space, whatever
// their shape in the embedding.
namespace Face_guard {

// cosine between the normals of a face and of the surface at its vertices, from which on the face is taken
constexpr double smallest_cosine = 0.2;
// cosine of 175 degrees: no angle in space is larger
constexpr double smallest_angle_cosine = -0.9961946980917455;
// of the height to the longest edge
constexpr double smallest_squared_flatness = 1e-8;

// The quality that the guards look at: the cosine between the normal of the face and the sum of the normals of its
// vertices, positive if the face is not folded, and -1 for a cap or a needle without height.
inline double quality(const Vertex_state& a, const Vertex_state& b, const Vertex_state& c)
{
  const Vector ab = b.point - a.point, bc = c.point - b.point, ca = a.point - c.point;
  const Vector area = ca.cross(ab);
  const double squared_area = area.squaredNorm();
  const double aa = bc.squaredNorm(), bb = ca.squaredNorm(), cc = ab.squaredNorm();
  const double longest = (std::max)({aa, bb, cc});
  if (!(squared_area > smallest_squared_flatness * longest * longest))
    return -1;
  // the largest angle is opposite to the longest edge
  const double product = aa == longest ? bb * cc : bb == longest ? aa * cc : aa * bb;
  const double cosine_times_lengths = 0.5 * (aa + bb + cc - 2 * longest);
  if (cosine_times_lengths < 0 &&
      cosine_times_lengths * cosine_times_lengths > smallest_angle_cosine * smallest_angle_cosine * product)
    return -1;
  const Vector normals = a.normal + b.normal + c.normal;
  return area.dot(normals) / std::sqrt(squared_area * (std::max)(normals.squaredNorm(), 1e-300));
}

// guard 1: good, or no worse than the worst face that it replaces
inline bool accepts(const double quality_after, const double quality_before)
{
  return quality_after >= smallest_cosine || (quality_after > -1 && quality_after >= quality_before);
}

} // namespace Face_guard

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_FACE_GUARD_H
