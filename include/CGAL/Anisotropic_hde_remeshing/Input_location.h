// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INPUT_LOCATION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INPUT_LOCATION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingTransfer

where a vertex of the result of `CGAL::anisotropic_hde_remeshing()` comes from: the closest point of the mesh that was given. A
vertex that was not touched comes from itself, a corner of one of its faces. Some vertices come from no face: isolated ones that
were not touched, and the last corners of polygons that were not touched, as a location has three corners only. A location that
nobody has written has no face, either.
*/
struct Input_location
{
  /// what `face` is if there is none
  static constexpr std::size_t no_face = (std::numeric_limits<std::size_t>::max)();

  /// the position of the face in the range `faces(tmesh)` before the call, or `no_face`
  std::size_t face = no_face;
  /// the weights of the vertices of the face, not negative and of sum 1. The first is that of the vertex that comes first in
  /// `vertices(tmesh)`; the others follow along the face.
  std::array<double, 3> barycentric_coordinates{{1, 0, 0}};

  /// whether the location is one: it has a face
  bool has_face() const { return face != no_face; }
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INPUT_LOCATION_H
