// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_MATRIX_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_MATRIX_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The matrix of the paper's (11), A_ij = sign phi(|y_i - y_j|), with the ridge `smoothing` added to the diagonal.
template <typename RadialFunction>
Eigen::MatrixXd interpolation_matrix(const Eigen::Matrix<double, 3, Eigen::Dynamic>& centres, const RadialFunction& function,
                                     const double smoothing)
{
  const Eigen::Index n = centres.cols();
  Eigen::MatrixXd matrix(n, n);
  const Eigen::ArrayXd x = centres.row(0), y = centres.row(1), z = centres.row(2);
  Eigen::ArrayXd squared_radius(n), value(n), unused(n);
  // column by column: mirroring a triangle would be slower than computing both
  for (Eigen::Index j = 0; j < n; ++j)
  {
    squared_radius = (x - x[j]).square() + (y - y[j]).square() + (z - z[j]).square();
    function(squared_radius, value, unused);
    matrix.col(j) = RadialFunction::sign * value;
  }
  matrix.diagonal().array() += smoothing;
  return matrix;
}

// the share of the entries that are not zero, for a function of compact support, from a sample of the rows
template <typename RadialFunction>
double density_of_interpolation_matrix(const Eigen::Matrix<double, 3, Eigen::Dynamic>& centres, const RadialFunction& function)
{
  static constexpr Eigen::Index rows = 50;
  const double support = function.support_radius();
  Eigen::Index entries = 0;
  for (Eigen::Index k = 0; k < rows; ++k)
  {
    const Eigen::Index i = k * centres.cols() / rows;
    entries += ((centres.colwise() - centres.col(i)).colwise().squaredNorm().array() < support * support).count();
  }
  return double(entries) / double(rows * centres.cols());
}

// The lower triangle of the same matrix for a function of compact support. The centres are swept along the longest axis of
// their box.
template <typename RadialFunction>
Eigen::SparseMatrix<double> sparse_interpolation_matrix(const Eigen::Matrix<double, 3, Eigen::Dynamic>& centres,
                                                        const RadialFunction& function, const double smoothing)
{
  Eigen::Index axis;
  (centres.rowwise().maxCoeff() - centres.rowwise().minCoeff()).maxCoeff(&axis);
  std::vector<Eigen::Index> order(std::size_t(centres.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::sort(order.begin(), order.end(),
            [&](const Eigen::Index i, const Eigen::Index j)
            { return std::make_pair(centres(axis, i), i) < std::make_pair(centres(axis, j), j); });
  const double support = function.support_radius();
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t l = k; l < order.size(); ++l)
    {
      const Eigen::Index i = order[k], j = order[l];
      if (centres(axis, j) - centres(axis, i) >= support)
        break;
      const double squared_radius = (centres.col(j) - centres.col(i)).squaredNorm();
      if (squared_radius >= support * support)
        continue;
      double value, unused;
      function(squared_radius, value, unused);
      entries.emplace_back((std::max)(i, j), (std::min)(i, j), value + (i == j ? smoothing : 0.));
    }
  Eigen::SparseMatrix<double> matrix(centres.cols(), centres.cols());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_MATRIX_H
