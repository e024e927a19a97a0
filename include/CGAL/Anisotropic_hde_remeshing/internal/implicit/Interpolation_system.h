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

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
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
  static constexpr Eigen::Index degree_count = RadialFunction::order == 0 ? 0 : RadialFunction::order == 1 ? 1 : 4;
  static_assert(RadialFunction::order <= 2, "polynomials of degree 2 and more are not implemented");

  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;
  typedef Eigen::Matrix<double, Eigen::Dynamic, degree_count> Polynomial_matrix;

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

  Polynomial_matrix polynomial_matrix() const
  {
    Polynomial_matrix matrix(m_centres.cols(), degree_count);
    if constexpr (degree_count > 0)
      matrix.col(0).setOnes();
    if constexpr (degree_count == 4)
      matrix.template rightCols<3>() = m_centres.transpose();
    return matrix;
  }

  Interpolation_coefficients solve_on_null_space(const Eigen::VectorXd& data, const double ridge) const
  {
    const Eigen::Index n = m_centres.cols(), m = n - degree_count;
    const Polynomial_matrix polynomials = polynomial_matrix();
    const Eigen::HouseholderQR<Polynomial_matrix> qr(polynomials);
    Eigen::MatrixXd matrix = RadialFunction::sign * interpolation_matrix();
    Eigen::VectorXd right = RadialFunction::sign * data;
    if constexpr (degree_count > 0)
    {
      transform_by_similarity(qr, matrix);
      right.applyOnTheLeft(qr.householderQ().adjoint());
    }

    Interpolation_coefficients result;
    result.relative_residual = std::numeric_limits<double>::infinity();
    auto reduced = matrix.bottomRightCorner(m, m);
    if (ridge > 0)
      reduced.diagonal().array() += ridge * reduced.diagonal().mean();
    const Eigen::VectorXd diagonal = reduced.diagonal();
    Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(reduced); // in place: overwrites the lower triangle
    if (cholesky.info() != Eigen::Success)
      return result;
    Eigen::VectorXd u = cholesky.solve(right.tail(m));
    // Q is orthogonal, hence the residual in its coordinates is as large as that of (11); the upper triangle still is A's
    const auto residual = [&]() -> Eigen::VectorXd
    {
      Eigen::VectorXd r = right.tail(m) - diagonal.cwiseProduct(u);
      r.noalias() -= reduced.template triangularView<Eigen::StrictlyUpper>() * u;
      r.noalias() -= reduced.template triangularView<Eigen::StrictlyUpper>().transpose() * u;
      return r;
    };
    u += cholesky.solve(residual()); // a step of iterative refinement
    const double size = data.template lpNorm<Eigen::Infinity>();
    result.relative_residual = size > 0 ? residual().template lpNorm<Eigen::Infinity>() / size : 0.;
    result.weights = Eigen::VectorXd::Zero(n);
    result.weights.tail(m) = u;
    if constexpr (degree_count > 0)
    {
      result.weights.applyOnTheLeft(qr.householderQ());
      const Eigen::VectorXd polynomial_right = right.head(degree_count) - matrix.topRightCorner(degree_count, m) * u;
      const auto triangle = qr.matrixQR().template topRows<degree_count>().template triangularView<Eigen::Upper>();
      result.polynomial.template head<degree_count>() = RadialFunction::sign * triangle.solve(polynomial_right);
    }
    if (!result.weights.allFinite() || !result.polynomial.allFinite())
      result.relative_residual = std::numeric_limits<double>::infinity();
    return result;
  }

  // Replaces the symmetric A by Q^T A Q. With the compact form Q = I - V T V^T of the reflections, X = A V T and
  // Y = X - V (T^T V^T X) / 2 it is A - V Y^T - Y V^T: one product instead of a sweep over A a reflection and side.
  static void transform_by_similarity(const Eigen::HouseholderQR<Polynomial_matrix>& qr, Eigen::MatrixXd& matrix)
  {
    const Eigen::Index n = matrix.rows();
    Polynomial_matrix v = qr.matrixQR().template triangularView<Eigen::UnitLower>();
    Eigen::Matrix<double, degree_count, degree_count> t = Eigen::Matrix<double, degree_count, degree_count>::Zero();
    for (Eigen::Index i = 0; i < degree_count; ++i)
    {
      t(i, i) = qr.hCoeffs()[i];
      if (i > 0)
        t.col(i).head(i) = -t(i, i) * (t.topLeftCorner(i, i) * (v.leftCols(i).transpose() * v.col(i)));
    }
    const Polynomial_matrix x = matrix * (v * t);
    Eigen::Matrix<double, Eigen::Dynamic, 2 * degree_count> left(n, 2 * degree_count), right(n, 2 * degree_count);
    left.template leftCols<degree_count>() = v;
    left.template rightCols<degree_count>() = x - 0.5 * v * (t.transpose() * (v.transpose() * x));
    right << left.template rightCols<degree_count>(), v;
    matrix.noalias() -= left * right.transpose();
  }

  // the whole indefinite system, for the data that the null space method cannot take: all of them in a plane, say
  Interpolation_coefficients solve_whole(const Eigen::VectorXd& data) const
  {
    const Eigen::Index n = m_centres.cols(), size = n + degree_count;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    matrix.topLeftCorner(n, n) = interpolation_matrix();
    matrix.topRightCorner(n, degree_count) = polynomial_matrix();
    matrix.bottomLeftCorner(degree_count, n) = polynomial_matrix().transpose();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    right.head(n) = data;
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    Interpolation_coefficients result;
    result.weights = solution.head(n);
    result.polynomial.head(degree_count) = solution.tail(degree_count);
    const double residual = (matrix * solution - right).template lpNorm<Eigen::Infinity>();
    const double largest = data.template lpNorm<Eigen::Infinity>();
    result.relative_residual = solution.allFinite() ? (largest > 0 ? residual / largest : 0.)
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
