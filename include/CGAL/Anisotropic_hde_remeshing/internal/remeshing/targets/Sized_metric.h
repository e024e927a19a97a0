// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_SIZED_METRIC_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_SIZED_METRIC_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A metric with the shapes and directions of another one, and with sizes of its own: the faces have the area of an equilateral triangle
// whose sides are as long as the size. A model of `RemeshingMetric`.
template <typename Metric, typename Size>
class Sized_metric
{
public:
  Sized_metric(const Metric& metric, const Size& size) : m_metric(metric), m_size(size) {}

  Sized_metric in_unit(const double unit) const
  {
    Sized_metric result(m_metric.in_unit(unit), m_size);
    result.m_unit = m_unit * unit;
    return result;
  }

  // lengths are relative to the sizes
  double unit_of_lengths(double) const { return 1; }

  Metric_bounds bounds() const { return m_metric.bounds(); }

  Eigen::Matrix2d operator()(const Eigen::Vector3d& point, const Eigen::Matrix<double, 3, 2>& frame,
                             const Eigen::Matrix2d& shape_operator) const
  {
    const Eigen::Matrix2d metric = m_metric(point, frame, shape_operator);
    const double size = m_size(m_unit * point) / m_unit,
                 determinant = metric(0, 0) * metric(1, 1) - metric(0, 1) * metric(1, 0);
    return metric / (std::sqrt(determinant) * size * size);
  }

private:
  Metric m_metric;
  Size m_size;
  double m_unit = 1; // of the points here, in the unit of the points that the sizes are asked for
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_SIZED_METRIC_H
