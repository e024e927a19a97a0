// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_QUADRATIC_POLYNOMIAL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_QUADRATIC_POLYNOMIAL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>

#include <Eigen/Core>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// constant + linear . y + y . quadratic y
struct Quadratic_polynomial
{
  double constant = 0;
  Vector linear = Vector::Zero();
  Matrix quadratic = Matrix::Zero(); // symmetric

  template <int order>
  void add_to(Jet<order>& jet, const Vector& y) const
  {
    const Vector image = quadratic * y;
    jet.value += constant + (linear + image).dot(y);
    if constexpr (order >= 1)
      jet.gradient += linear + 2 * image;
    if constexpr (order >= 2)
      jet.hessian += 2 * quadratic;
  }
};

// The polynomials of the interpolant of a patch. Constant and linear ones are there for every kernel, so that planes are
// reproduced. Conditionally positive definite kernels of order 2 need them. Then there are the squares and the product of
// two coordinates along the surface. They let the interpolant bend as the surface does where the data of the patch end. Without
// them it would go flat there, and that would limit the accuracy of patches. Only the tiny offsets would determine squares
// across the surface, so there are none.
class Polynomial_basis
{
public:
  // `normal` has unit length. It is zero if the points of the patch have no common direction: then there are no squares.
  explicit Polynomial_basis(const Vector& normal) : m_has_squares(!normal.isZero(0))
  {
    if (!m_has_squares)
      return;
    m_u = normal.unitOrthogonal();
    m_v = normal.cross(m_u);
  }

  Eigen::Index size() const { return m_has_squares ? 7 : 4; }

  // the values of the polynomials (columns) at the points (rows)
  Eigen::MatrixXd values(const Eigen::Matrix<double, 3, Eigen::Dynamic>& points) const
  {
    Eigen::MatrixXd result(points.cols(), size());
    result.col(0).setOnes();
    result.middleCols(1, 3) = points.transpose();
    if (m_has_squares)
    {
      const Eigen::VectorXd u = points.transpose() * m_u, v = points.transpose() * m_v;
      result.col(4) = u.cwiseProduct(u);
      result.col(5) = u.cwiseProduct(v);
      result.col(6) = v.cwiseProduct(v);
    }
    return result;
  }

  Quadratic_polynomial combination(const Eigen::VectorXd& coefficients) const
  {
    Quadratic_polynomial result;
    result.constant = coefficients[0];
    result.linear = coefficients.segment<3>(1);
    if (m_has_squares)
    {
      const Matrix mixed = m_u * m_v.transpose();
      result.quadratic = coefficients[4] * m_u * m_u.transpose() + 0.5 * coefficients[5] * (mixed + mixed.transpose()) +
                         coefficients[6] * m_v * m_v.transpose();
    }
    return result;
  }

private:
  bool m_has_squares;
  Vector m_u = Vector::Zero(), m_v = Vector::Zero();
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_QUADRATIC_POLYNOMIAL_H
