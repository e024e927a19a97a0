// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_SYSTEM_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_SYSTEM_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Polynomial_null_space.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// how the system of a patch was solved in the end
enum class Solver
{
  CHOLESKY,
  CHOLESKY_WITH_RIDGE,
  SPARSE_CHOLESKY,
  LU,
  FAILED
};

struct Interpolation_coefficients
{
  Eigen::VectorXd weights;      // alpha of the paper's (10)
  Eigen::VectorXd polynomial;   // beta, in the basis of the matrix P
  double relative_residual = 0; // largest one of the system, over the largest datum
  double condition = 1;         // an estimate from below, by the pivots
  Solver solver = Solver::FAILED;

  // A solution with a larger residual is not accepted. The data are a small part of the spacing of the points, so this is about
  // 1e-8 of the spacing.
  static constexpr double largest_residual = 1e-7;

  bool is_finite() const { return weights.allFinite() && polynomial.allFinite(); }

  static double relative(const double residual, const Eigen::VectorXd& data)
  {
    const double largest = data.lpNorm<Eigen::Infinity>();
    return largest > 0 ? residual / largest : residual;
  }
};

// Solves the paper's system (11), (A + lambda I, P; P^T, 0) (alpha, beta) = (f, 0), for one patch. lambda is the smoothing, 0
// for interpolation. The interpolation matrix A of a conditionally positive definite function is definite on the null space of
// P^T. With P = Q (R; 0) and Z the columns of Q beyond those of R, alpha = Z u and (Z^T A Z + lambda I) u = Z^T f. Cholesky
// solves this in half of the time of LU. The class is a template of the matrix, not of the kernel. So it is compiled once for
// all kernels, and not at all where no function is built.
template <typename Dense_matrix>
class Interpolation_system
{
  typedef Eigen::Matrix<typename Dense_matrix::Scalar, Eigen::Dynamic, 1> Column;
  typedef Eigen::Ref<Dense_matrix> Matrix_reference;
  typedef Polynomial_null_space<Dense_matrix> Null_space;

public:
  // `matrix` makes A + lambda I, which is symmetric. The factor overwrites that matrix. So `matrix` is called once, as a rule,
  // and once more after a failure.
  Interpolation_system(std::function<Dense_matrix()> matrix, const Dense_matrix& polynomials, const Null_space& null_space)
    : m_matrix(std::move(matrix)), m_polynomials(polynomials), m_null_space(null_space)
  {
  }

  Interpolation_coefficients solve(const Column& data) const
  {
    for (const double ridge : {0., 1e-14, 1e-12, 1e-10})
    {
      Interpolation_coefficients result = solve_on_null_space(data, ridge);
      if (result.relative_residual <= (std::max)(Interpolation_coefficients::largest_residual, 1e3 * ridge))
      {
        result.solver = ridge == 0 ? Solver::CHOLESKY : Solver::CHOLESKY_WITH_RIDGE;
        return result;
      }
    }
    Interpolation_coefficients result = solve_whole(data);
    result.solver = result.relative_residual <= Interpolation_coefficients::largest_residual ? Solver::LU : Solver::FAILED;
    return result;
  }

private:
  // residual over the right-hand side; a larger one is worth another step
  static constexpr double good_residual = 1e-11;

  Interpolation_coefficients solve_on_null_space(const Column& data, const double ridge) const
  {
    const Eigen::Index n = m_polynomials.rows(), q = m_polynomials.cols(), m = n - q;
    Dense_matrix matrix = m_matrix();
    m_null_space.transform(matrix);
    const Column right = m_null_space.transformed(data);
    const Dense_matrix mixed = matrix.topRightCorner(q, m);

    Interpolation_coefficients result;
    result.relative_residual = std::numeric_limits<double>::infinity();
    Column u = right.tail(m);
    const double residual = solve_definite(matrix.bottomRightCorner(m, m), ridge, u, result.condition);
    if (!std::isfinite(residual))
      return result;
    result.weights = Column::Zero(n);
    result.weights.tail(m) = u;
    result.weights = m_null_space.transformed_back(result.weights);
    const Column polynomial_right = right.head(q) - mixed * u;
    result.polynomial = m_null_space.solve_triangle(polynomial_right);
    // Q is orthogonal, so the residual in its coordinates is as large as that of (11).
    if (result.is_finite())
      result.relative_residual = Interpolation_coefficients::relative(residual, data);
    return result;
  }

  // Solves the system with the right-hand side `u` and overwrites `u` by the solution. Overwrites the lower triangle of the
  // matrix by its factor. Returns the largest residual; it is infinite if the matrix is not positive definite.
  static double solve_definite(Matrix_reference matrix, const double ridge, Column& u, double& condition)
  {
    if (ridge > 0)
      matrix.diagonal().array() += ridge * matrix.diagonal().mean();
    const Column diagonal = matrix.diagonal(), right = u;
    if (!factorize(matrix))
      return std::numeric_limits<double>::infinity();
    const auto solve_in_place = [&](Column& x)
    {
      matrix.template triangularView<Eigen::Lower>().solveInPlace(x);
      matrix.template triangularView<Eigen::Lower>().transpose().solveInPlace(x);
    };
    const Eigen::ArrayXd pivots = matrix.diagonal();
    condition = pivots.size() > 0 ? std::pow(pivots.maxCoeff() / pivots.minCoeff(), 2) : 1.;
    // the upper triangle is still that of the matrix
    const auto residual = [&]() -> Column
    {
      Column r = right - diagonal.cwiseProduct(u);
      r.noalias() -= matrix.template triangularView<Eigen::StrictlyUpper>() * u;
      r.noalias() -= matrix.template triangularView<Eigen::StrictlyUpper>().transpose() * u;
      return r;
    };
    solve_in_place(u);
    Column rest = residual();
    if (rest.template lpNorm<Eigen::Infinity>() > good_residual * right.template lpNorm<Eigen::Infinity>())
    {
      solve_in_place(rest); // a step of iterative refinement
      u += rest;
      rest = residual();
    }
    return rest.template lpNorm<Eigen::Infinity>();
  }

  // Writes Cholesky's factor over the lower triangle. Returns false if the matrix is not positive definite. Works by halves
  // down to a size that stays in the cache. For some hundred unknowns this is a fifth faster than Eigen's LLT with its narrow
  // panels. It is also faster to compile.
  static bool factorize(Matrix_reference matrix)
  {
    static constexpr Eigen::Index smallest = 32;
    const Eigen::Index n = matrix.rows(), half = n / 2 / 4 * 4; // columns that begin on a SIMD boundary as the first does
    if (n <= smallest)
      return factorize_directly(matrix);
    Matrix_reference first = matrix.topLeftCorner(half, half), below = matrix.bottomLeftCorner(n - half, half),
                     second = matrix.bottomRightCorner(n - half, n - half);
    if (!factorize(first))
      return false;
    first.template triangularView<Eigen::Lower>().transpose().template solveInPlace<Eigen::OnTheRight>(below);
    second.template selfadjointView<Eigen::Lower>().rankUpdate(below, -1);
    return factorize(second);
  }

  static bool factorize_directly(Matrix_reference matrix)
  {
    const Eigen::Index n = matrix.rows();
    for (Eigen::Index j = 0; j < n; ++j)
    {
      if (!(matrix(j, j) > 0))
        return false;
      matrix(j, j) = std::sqrt(matrix(j, j));
      auto below = matrix.col(j).tail(n - j - 1);
      below /= matrix(j, j);
      for (Eigen::Index k = j + 1; k < n; ++k)
        matrix.col(k).tail(n - k) -= matrix(k, j) * matrix.col(j).tail(n - k);
    }
    return true;
  }

  // Solves the whole indefinite system. It is for data that the null space method cannot take, for instance if all points are
  // in a plane.
  Interpolation_coefficients solve_whole(const Column& data) const
  {
    const Eigen::Index n = m_polynomials.rows(), q = m_polynomials.cols();
    Dense_matrix matrix = Dense_matrix::Zero(n + q, n + q);
    matrix.topLeftCorner(n, n) = m_matrix();
    matrix.topRightCorner(n, q) = m_polynomials;
    matrix.bottomLeftCorner(q, n) = m_polynomials.transpose();
    Column right = Column::Zero(n + q);
    right.head(n) = data;
    const Eigen::PartialPivLU<Dense_matrix> lu(matrix);
    const Column solution = lu.solve(right);
    Interpolation_coefficients result;
    result.weights = solution.head(n);
    result.polynomial = solution.tail(q);
    const Eigen::ArrayXd pivots = lu.matrixLU().diagonal().array().abs();
    result.condition = pivots.maxCoeff() / pivots.minCoeff();
    const Column residual = matrix * solution - right;
    result.relative_residual = solution.allFinite()
                                   ? Interpolation_coefficients::relative(residual.template lpNorm<Eigen::Infinity>(), data)
                                   : std::numeric_limits<double>::infinity();
    return result;
  }

  std::function<Dense_matrix()> m_matrix;
  const Dense_matrix& m_polynomials;
  const Null_space& m_null_space;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_SYSTEM_H
