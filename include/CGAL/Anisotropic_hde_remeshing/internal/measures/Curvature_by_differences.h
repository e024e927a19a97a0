// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_CURVATURE_BY_DIFFERENCES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_CURVATURE_BY_DIFFERENCES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The principal curvatures of the level set through p, by central differences of the unit normal. So any function with a
// gradient will do.
struct Curvature_by_differences
{
  double flatter = 0, steeper = 0;           // of the smaller and of the larger absolute value
  Vector flatter_direction = Vector::Zero(); // stays zero where the gradient vanishes or is not finite

  template <typename Function>
  Curvature_by_differences(const Function& function, const Vector& p, const double step)
  {
    const auto normal_at = [&](const Vector& q) { return gradient_of(function, q).stableNormalized(); };
    const Vector normal = normal_at(p);
    if (!(normal.squaredNorm() > 0.5))
      return;
    Eigen::Matrix<double, 3, 2> frame;
    frame.col(0) = normal.unitOrthogonal();
    frame.col(1) = normal.cross(frame.col(0));
    Eigen::Matrix2d shape_operator;
    for (int k = 0; k < 2; ++k)
      shape_operator.col(k) =
          frame.transpose() * (normal_at(p + step * frame.col(k)) - normal_at(p - step * frame.col(k))) / (2 * step);
    if (!shape_operator.allFinite())
      return;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(0.5 * (shape_operator + shape_operator.transpose()));
    const Eigen::Vector2d& curvatures = solver.eigenvalues();
    const int k = std::abs(curvatures[0]) <= std::abs(curvatures[1]) ? 0 : 1;
    flatter = curvatures[k];
    steeper = curvatures[1 - k];
    flatter_direction = frame * solver.eigenvectors().col(k);
  }
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_CURVATURE_BY_DIFFERENCES_H
