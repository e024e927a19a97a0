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

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// how the system of a patch was solved in the end
enum class Solver
{
  CHOLESKY,
  CHOLESKY_WITH_RIDGE,
  LU,
  FAILED
};

struct Interpolation_coefficients
{
  Eigen::VectorXd weights;                              // alpha of the paper's (10)
  Eigen::Vector4d polynomial = Eigen::Vector4d::Zero(); // beta
  double relative_residual = 0;                         // the largest, over the largest datum
  Solver solver = Solver::FAILED;
};

// Solves the paper's system (11), (A P; P^T 0) (alpha, beta) = (f, 0), for one patch. The interpolation matrix A of a
// conditionally positive definite function is definite on the null space of P^T: with P = Q (R; 0) and Z the columns of Q
// beyond those of R, alpha = Z u and (Z^T A Z) u = Z^T f, which Cholesky solves in half of the time of LU.
template <typename RadialFunction>
class Interpolation_system
{
  static constexpr Eigen::Index number_of_polynomials = RadialFunction::order == 0 ? 0 : RadialFunction::order == 1 ? 1 : 4;
  static_assert(RadialFunction::order <= 2, "polynomials of degree 2 and more are not implemented");

  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;

public:
  // Relative to the largest datum; beyond it a solution is not accepted. The data are a small part of the spacing of the
  // points, so that this is about 1e-8 of the spacing.
  static constexpr double largest_residual = 1e-7;

  Interpolation_system(const Points& centres, const RadialFunction& function) : m_centres(centres), m_function(function)
  {
  }

  Interpolation_coefficients solve(const Eigen::VectorXd& data) const
  {
    for (const double ridge : {0., 1e-12, 1e-10})
    {
      Interpolation_coefficients result = solve_on_null_space(data, ridge);
      if (result.relative_residual <= (std::max)(largest_residual, 1e3 * ridge))
      {
        result.solver = ridge == 0 ? Solver::CHOLESKY : Solver::CHOLESKY_WITH_RIDGE;
        return result;
      }
    }
    Interpolation_coefficients result = solve_whole(data);
    result.solver = result.relative_residual <= largest_residual ? Solver::LU : Solver::FAILED;
    return result;
  }

private:
  Eigen::MatrixXd interpolation_matrix() const
  {
    const Eigen::Index n = m_centres.cols();
    Eigen::MatrixXd matrix(n, n);
    const Eigen::ArrayXd x = m_centres.row(0), y = m_centres.row(1), z = m_centres.row(2);
    Eigen::ArrayXd squared_radius(n), value(n), unused(n);
    for (Eigen::Index j = 0; j < n; ++j)
    {
      squared_radius = (x - x[j]).square() + (y - y[j]).square() + (z - z[j]).square();
      m_function(squared_radius, value, unused);
      matrix.col(j) = value;
    }
    return matrix;
  }

  Eigen::MatrixXd polynomial_matrix() const
  {
    Eigen::MatrixXd matrix(m_centres.cols(), number_of_polynomials);
    if (number_of_polynomials > 0)
      matrix.col(0).setOnes();
    if (number_of_polynomials == 4)
      matrix.rightCols(3) = m_centres.transpose();
    return matrix;
  }

  Interpolation_coefficients solve_on_null_space(const Eigen::VectorXd& data, const double ridge) const
  {
    const Eigen::Index n = m_centres.cols(), q = number_of_polynomials, m = n - q;
    const Polynomial_null_space null_space(polynomial_matrix());
    Eigen::MatrixXd matrix = interpolation_matrix();
    matrix *= RadialFunction::sign;
    null_space.transform(matrix);
    const Eigen::VectorXd right = RadialFunction::sign * null_space.transformed(data);
    const Eigen::MatrixXd mixed = matrix.topRightCorner(q, m);

    Interpolation_coefficients result;
    result.relative_residual = std::numeric_limits<double>::infinity();
    Eigen::VectorXd u = right.tail(m);
    const double residual = solve_definite(matrix.bottomRightCorner(m, m), ridge, u);
    if (!std::isfinite(residual))
      return result;
    result.weights = Eigen::VectorXd::Zero(n);
    result.weights.tail(m) = u;
    result.weights = null_space.transformed_back(result.weights);
    const Eigen::VectorXd polynomial_right = right.head(q) - mixed * u;
    result.polynomial.head(q) = RadialFunction::sign * null_space.solve_triangle(polynomial_right);
    // Q is orthogonal, hence the residual in its coordinates is as large as that of (11)
    if (result.weights.allFinite() && result.polynomial.allFinite())
      result.relative_residual = relative(residual, data);
    return result;
  }

  // Overwrites `u` by the solution of the system with it as the right-hand side, and the lower triangle of the matrix by its
  // factor; returns the largest residual, infinite if the matrix is not positive definite.
  static double solve_definite(Eigen::Ref<Eigen::MatrixXd> matrix, const double ridge, Eigen::VectorXd& u)
  {
    if (ridge > 0)
      matrix.diagonal().array() += ridge * matrix.diagonal().mean();
    const Eigen::VectorXd diagonal = matrix.diagonal(), right = u;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(matrix);
    if (cholesky.info() != Eigen::Success)
      return std::numeric_limits<double>::infinity();
    // the upper triangle still is the matrix's
    const auto residual = [&]() -> Eigen::VectorXd
    {
      Eigen::VectorXd r = right - diagonal.cwiseProduct(u);
      r.noalias() -= matrix.template triangularView<Eigen::StrictlyUpper>() * u;
      r.noalias() -= matrix.template triangularView<Eigen::StrictlyUpper>().transpose() * u;
      return r;
    };
    cholesky.solveInPlace(u);
    Eigen::VectorXd correction = residual(); // a step of iterative refinement
    cholesky.solveInPlace(correction);
    u += correction;
    return residual().template lpNorm<Eigen::Infinity>();
  }

  static double relative(const double residual, const Eigen::VectorXd& data)
  {
    const double largest = data.template lpNorm<Eigen::Infinity>();
    return largest > 0 ? residual / largest : 0.;
  }

  // the whole indefinite system, for the data that the null space method cannot take: all of them in a plane, say
  Interpolation_coefficients solve_whole(const Eigen::VectorXd& data) const
  {
    const Eigen::Index n = m_centres.cols(), size = n + number_of_polynomials;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    matrix.topLeftCorner(n, n) = interpolation_matrix();
    matrix.topRightCorner(n, number_of_polynomials) = polynomial_matrix();
    matrix.bottomLeftCorner(number_of_polynomials, n) = polynomial_matrix().transpose();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    right.head(n) = data;
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    Interpolation_coefficients result;
    result.weights = solution.head(n);
    result.polynomial.head(number_of_polynomials) = solution.tail(number_of_polynomials);
    const Eigen::VectorXd residual = matrix * solution - right;
    result.relative_residual = solution.allFinite() ? relative(residual.template lpNorm<Eigen::Infinity>(), data)
                                                    : std::numeric_limits<double>::infinity();
    return result;
  }

  const Points& m_centres;
  const RadialFunction& m_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_SYSTEM_H
