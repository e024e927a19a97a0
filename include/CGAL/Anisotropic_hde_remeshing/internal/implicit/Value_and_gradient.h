// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_VALUE_AND_GRADIENT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_VALUE_AND_GRADIENT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the numbers in which both halves of the package compute, whatever the kernel of the caller
typedef Eigen::Vector3d Vector;

struct Value_and_gradient
{
  double value = 0;
  Vector gradient = Vector::Zero();
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_VALUE_AND_GRADIENT_H
