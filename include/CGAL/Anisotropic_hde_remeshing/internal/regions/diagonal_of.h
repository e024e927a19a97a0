// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_DIAGONAL_OF_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_DIAGONAL_OF_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Jet.h>

#include <CGAL/Bbox_3.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

inline double diagonal_of(const Bbox_3& box)
{
  return Vector(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()).stableNorm();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_DIAGONAL_OF_H
