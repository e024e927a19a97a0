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

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Kernel_sum.h>

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

// Computes the entries of column j from row i on, `lanes` at a time, and advances i as far as there are so many.
template <Eigen::Index lanes, typename RadialFunction>
CGAL_AHR_FLATTEN void fill_column(const Eigen::Array<double, Eigen::Dynamic, 3>& centres, const RadialFunction& function,
                                  const Eigen::Index j, Eigen::Index& i, Eigen::MatrixXd& matrix)
{
  typedef Eigen::Array<double, lanes, 1> Lanes;
  for (; i + lanes <= centres.rows(); i += lanes)
  {
    const auto squared_difference = [&](const Eigen::Index k) -> Lanes
    { return (centres.col(k).template segment<lanes>(i) - centres(j, k)).square(); };
    const Lanes squared_radius = squared_difference(0) + squared_difference(1) + squared_difference(2);
    matrix.col(j).template segment<lanes>(i) = RadialFunction::sign * function(squared_radius).value;
  }
}

// The matrix of the paper's (11), A_ij = sign phi(|y_i - y_j|), with the ridge `smoothing` added to the diagonal.
template <typename RadialFunction>
Eigen::MatrixXd interpolation_matrix(const Eigen::Matrix<double, 3, Eigen::Dynamic>& centres, const RadialFunction& function,
                                     const double smoothing)
{
  const Eigen::Index n = centres.cols();
  Eigen::MatrixXd matrix(n, n);
  const Eigen::Array<double, Eigen::Dynamic, 3> transposed = centres.transpose();
  // column by column: mirroring a triangle would be slower than computing both
  for (Eigen::Index j = 0, i = 0; j < n; ++j, i = 0)
  {
    fill_column<8>(transposed, function, j, i, matrix);
    fill_column<2>(transposed, function, j, i, matrix);
    fill_column<1>(transposed, function, j, i, matrix);
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
      const double value = function(squared_radius).value;
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
