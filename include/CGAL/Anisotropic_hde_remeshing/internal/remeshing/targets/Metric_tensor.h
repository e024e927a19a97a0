// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_TENSOR_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_TENSOR_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the symmetric 3x3 matrix of a Riemannian metric at a vertex
struct Metric_tensor
{
  double xx = 1, yy = 1, zz = 1, xy = 0, xz = 0, yz = 0;

  Metric_tensor() = default;

  explicit Metric_tensor(const Matrix& m) : xx(m(0, 0)), yy(m(1, 1)), zz(m(2, 2)), xy(m(0, 1)), xz(m(0, 2)), yz(m(1, 2)) {}

  Matrix matrix() const
  {
    Matrix m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }

  static Metric_tensor mean(const Metric_tensor& a, const Metric_tensor& b)
  {
    Metric_tensor m;
    m.xx = 0.5 * (a.xx + b.xx), m.yy = 0.5 * (a.yy + b.yy), m.zz = 0.5 * (a.zz + b.zz);
    m.xy = 0.5 * (a.xy + b.xy), m.xz = 0.5 * (a.xz + b.xz), m.yz = 0.5 * (a.yz + b.yz);
    return m;
  }

  double squared_length(const Vector& e) const
  {
    return xx * e[0] * e[0] + yy * e[1] * e[1] + zz * e[2] * e[2] +
           2 * (xy * e[0] * e[1] + xz * e[0] * e[2] + yz * e[1] * e[2]);
  }
};

// The intersection of two metrics of the plane. Both are positive definite. In the direction of each of their common conjugate
// axes, the result is the larger one of both. Its unit ball approximates the intersection of their unit balls.
inline Eigen::Matrix2d metric_intersection(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b)
{
  // Cholesky's decomposition of a, and its inverse; Eigen's takes a second to compile
  const double scale = std::sqrt(a(0, 0)), shear = a(1, 0) / scale, squared_height = a(1, 1) - shear * shear;
  if (!(scale > 0) || !(squared_height > 0))
    return b;
  const double height = std::sqrt(squared_height);
  Eigen::Matrix2d lower, inverse;
  lower << scale, 0, shear, height;
  inverse << 1 / scale, 0, -shear / (scale * height), 1 / height;
  const Eigen::Matrix2d half = inverse * b, relative = half * inverse.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(0.5 * (relative + relative.transpose()));
  if (solver.eigenvalues()[1] <= 1)
    return a;
  const Eigen::Matrix2d axes = lower * solver.eigenvectors();
  const Eigen::Matrix2d result = axes * solver.eigenvalues().cwiseMax(1.).asDiagonal() * axes.transpose();
  return 0.5 * (result + result.transpose());
}

// the metric with its eigenvalues put between bounds
inline Eigen::Matrix2d bounded_metric(const Eigen::Matrix2d& metric, const double least, const double largest)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(metric);
  const Eigen::Vector2d bounded = solver.eigenvalues().cwiseMax(least).cwiseMin(largest);
  const Eigen::Matrix2d result = solver.eigenvectors() * bounded.asDiagonal() * solver.eigenvectors().transpose();
  return 0.5 * (result + result.transpose());
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_TENSOR_H
