// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_TANGENT_FRAME_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_TANGENT_FRAME_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <Eigen/Core>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// two axes orthogonal to a normal
typedef Eigen::Matrix<double, 3, 2> Tangent_frame;

inline Tangent_frame tangent_frame(const Vector& normal)
{
  Tangent_frame frame;
  frame.col(0) = normal.unitOrthogonal();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_TANGENT_FRAME_H
