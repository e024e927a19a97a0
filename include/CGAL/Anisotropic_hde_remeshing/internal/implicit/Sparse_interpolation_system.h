// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SPARSE_INTERPOLATION_SYSTEM_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SPARSE_INTERPOLATION_SYSTEM_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Interpolation_system.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The same system for a positive definite function of compact support. Its matrix A is sparse. The solution is
// alpha = A^-1 (f - P beta) with (P^T A^-1 P) beta = P^T A^-1 f, and sparse Cholesky factorises A. The class is a template so
// that it is compiled only for those who use such a function.
template <typename Sparse_matrix>
class Sparse_interpolation_system
{
public:
  // `matrix` is the lower triangle of A + lambda I; both must outlive this object
  Sparse_interpolation_system(const Sparse_matrix& matrix, const Eigen::MatrixXd& polynomials)
    : m_matrix(matrix), m_polynomials(polynomials)
  {
  }

  Interpolation_coefficients solve(const Eigen::VectorXd& data) const
  {
    Interpolation_coefficients result;
    const Eigen::SimplicialLLT<Sparse_matrix> cholesky(m_matrix);
    if (cholesky.info() != Eigen::Success)
      return result;
    const Eigen::VectorXd pivots = Sparse_matrix(cholesky.matrixL()).diagonal();
    result.condition = std::pow(pivots.maxCoeff() / pivots.minCoeff(), 2);
    const auto refined_solve = [&](const Eigen::MatrixXd& right) -> Eigen::MatrixXd
    {
      Eigen::MatrixXd x = cholesky.solve(right);
      const Eigen::MatrixXd residual = right - m_matrix.template selfadjointView<Eigen::Lower>() * x;
      x += cholesky.solve(residual);
      return x;
    };
    const Eigen::MatrixXd solved_polynomials = refined_solve(m_polynomials), solved_data = refined_solve(data);
    const Eigen::MatrixXd schur = m_polynomials.transpose() * solved_polynomials;
    result.polynomial = schur.partialPivLu().solve(m_polynomials.transpose() * solved_data);
    result.weights = solved_data - solved_polynomials * result.polynomial;
    if (!result.is_finite())
      return result;
    const Eigen::VectorXd residual =
        data - m_polynomials * result.polynomial - m_matrix.template selfadjointView<Eigen::Lower>() * result.weights;
    result.relative_residual = Interpolation_coefficients::relative(residual.lpNorm<Eigen::Infinity>(), data);
    if (result.relative_residual <= Interpolation_coefficients::largest_residual)
      result.solver = Solver::SPARSE_CHOLESKY;
    return result;
  }

private:
  const Sparse_matrix& m_matrix;
  const Eigen::MatrixXd& m_polynomials;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SPARSE_INTERPOLATION_SYSTEM_H
