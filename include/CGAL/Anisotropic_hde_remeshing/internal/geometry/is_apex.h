// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_IS_APEX_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_IS_APEX_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Whether a vertex is the tip of a cone or a spike, by angle defects: what the angles of the faces around a vertex leave out of a
// full turn. A tip is where the surface turns by a large angle at one vertex, and much less all around it. So it is not at the
// vertices of coarse or noisy meshes.
inline bool is_apex(const double defect, const double defect_around)
{
  static constexpr double least_defect = 2; // a cone of 43 degrees, from the axis; at a corner of a cube it is 1.6
  static constexpr double largest_share_around = 1. / 3;
  return defect >= least_defect && std::abs(defect_around) <= largest_share_around * defect;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_IS_APEX_H
