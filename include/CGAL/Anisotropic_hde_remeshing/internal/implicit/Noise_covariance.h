// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_NOISE_COVARIANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_NOISE_COVARIANCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The covariance of the errors of the data of a patch, over tau^2, the scale of the function. Noise moves a point and its
// off-surface points together: so their errors are the same one, and their differences still tell the slope of the function,
// however small the offset. A little is added to off-surface points, as normals are not certain either.
class Noise_covariance
{
  static constexpr double share_of_off_surface_points = 0.1; // of the variance of a point

public:
  Noise_covariance() = default;

  // `point_of` are the numbers of the data points that the data belong to. Points come first, and are their own; the
  // off-surface points of one point come together. `variances` are those of the points.
  Noise_covariance(std::vector<double> variances, std::vector<Eigen::Index> point_of)
    : m_variances(std::move(variances)), m_point_of(std::move(point_of))
  {
  }

  void add_to(Eigen::MatrixXd& matrix) const
  {
    visit(
        [&](const Eigen::Index i, const Eigen::Index j, const double value)
        {
          matrix(i, j) += value;
          if (i != j)
            matrix(j, i) += value;
        });
  }

  // to the lower triangle
  void add_to(Eigen::SparseMatrix<double>& matrix) const
  {
    visit([&](const Eigen::Index i, const Eigen::Index j, const double value) { matrix.coeffRef(i, j) += value; });
  }

  // by how much a solution with these weights misses the data
  Eigen::VectorXd times(const Eigen::VectorXd& weights) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(weights.size());
    visit(
        [&](const Eigen::Index i, const Eigen::Index j, const double value)
        {
          result[i] += value * weights[j];
          if (i != j)
            result[j] += value * weights[i];
        });
    return result;
  }

private:
  // calls visit(row, column, value) for the entries of the lower triangle that are not zero
  template <typename Visitor>
  void visit(const Visitor& visitor) const
  {
    for (Eigen::Index i = 0; i < Eigen::Index(m_point_of.size()); ++i)
    {
      const Eigen::Index point = m_point_of[std::size_t(i)];
      const double variance = m_variances[std::size_t(point)];
      if (variance == 0)
        continue;
      visitor(i, i, variance * (i == point ? 1 : 1 + share_of_off_surface_points));
      if (i == point)
        continue;
      visitor(i, point, variance);
      for (Eigen::Index j = i - 1; j > point && m_point_of[std::size_t(j)] == point; --j)
        visitor(i, j, variance);
    }
  }

  std::vector<double> m_variances;
  std::vector<Eigen::Index> m_point_of;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_NOISE_COVARIANCE_H
