// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_ROUNDED_BOX_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_ROUNDED_BOX_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the box between two corners in single precision, which takes half of the memory; it holds the box in double precision
inline Eigen::AlignedBox3f rounded_box(const Vector& low, const Vector& high)
{
  static constexpr double epsilon = std::numeric_limits<float>::epsilon(), least = (std::numeric_limits<float>::min)();
  const auto margin = [](const double x) { return (std::max)(epsilon * std::abs(x), least); };
  Eigen::AlignedBox3f result;
  for (int k = 0; k < 3; ++k)
  {
    result.min()[k] = float(low[k] - margin(low[k]));
    result.max()[k] = float(high[k] + margin(high[k]));
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_ROUNDED_BOX_H
