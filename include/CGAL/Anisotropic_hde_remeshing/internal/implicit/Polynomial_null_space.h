// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POLYNOMIAL_NULL_SPACE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POLYNOMIAL_NULL_SPACE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <Eigen/Core>

#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The coordinates in which the side condition P^T alpha = 0 of the paper's (11) is trivial. P = Q (R; 0) has q columns.
// Q = I - V T V^T is the product of q Householder reflections in compact form. The first q coordinates of Q^T alpha vanish, the
// others are free. All matrices have dynamic sizes: fixed ones would be compiled once more for each shape. The class is a
// template so that it is compiled only where a function is built.
template <typename Dense_matrix>
class Polynomial_null_space
{
  typedef Eigen::Matrix<typename Dense_matrix::Scalar, Eigen::Dynamic, 1> Column;

public:
  // Householder's reflections of a few columns. Eigen's class for them works by blocks. It took a tenth of the time to compile
  // a program that uses the package.
  explicit Polynomial_null_space(Dense_matrix polynomials)
    : m_v(Dense_matrix::Zero(polynomials.rows(), polynomials.cols())),
      m_t(Dense_matrix::Zero(polynomials.cols(), polynomials.cols())),
      m_r(Dense_matrix::Zero(polynomials.cols(), polynomials.cols()))
  {
    for (Eigen::Index i = 0; i < m_t.cols(); ++i)
    {
      Column v = polynomials.col(i);
      for (Eigen::Index j = 0; j < i; ++j)
        std::swap(m_r(j, i), v[j]);
      m_r(i, i) = v[i] > 0 ? -v.norm() : v.norm();
      v[i] -= m_r(i, i);
      const double length = v.norm();
      if (length > 0)
        v /= length;
      // the reflection is I - 2 v v^T
      for (Eigen::Index j = i + 1; j < m_t.cols(); ++j)
        polynomials.col(j) -= 2 * v.dot(polynomials.col(j)) * v;
      m_t(i, i) = 2;
      for (Eigen::Index j = 0; j < i; ++j)
        for (Eigen::Index k = j; k < i; ++k)
          m_t(j, i) -= 2 * m_t(j, k) * m_v.col(k).dot(v);
      m_v.col(i) = v;
    }
  }

  Eigen::Index number_of_polynomials() const { return m_v.cols(); }

  // how well the points determine the polynomials, from 0, not at all, to 1
  double independence() const
  {
    const Eigen::ArrayXd diagonal = m_r.diagonal().array().abs();
    const double largest = diagonal.size() > 0 ? diagonal.maxCoeff() : 1.;
    return largest > 0 ? diagonal.minCoeff() / largest : 0.;
  }

  // Q^T b
  Column transformed(const Column& b) const
  {
    const Column along = m_v.transpose() * b;
    const Column weights = m_t.transpose() * along;
    return b - m_v * weights;
  }

  // Q b
  Column transformed_back(const Column& b) const
  {
    const Column along = m_v.transpose() * b;
    const Column weights = m_t * along;
    return b - m_v * weights;
  }

  // Replaces the symmetric A by Q^T A Q. With X = A V T and Y = X - V (T^T V^T X) / 2 this is A - V Y^T - Y V^T. It takes one
  // product, instead of a sweep over A for each reflection and side.
  void transform(Dense_matrix& matrix) const
  {
    const Eigen::Index q = number_of_polynomials();
    const Dense_matrix vt = m_v * m_t;
    Dense_matrix y = matrix * vt;
    const Dense_matrix inner = 0.5 * vt.transpose() * y;
    y -= m_v * inner;
    Dense_matrix left(matrix.rows(), 2 * q), right(matrix.rows(), 2 * q);
    left << m_v, y;
    right << y, m_v;
    matrix.noalias() -= left * right.transpose();
  }

  // the x with R x = b
  Column solve_triangle(Column b) const
  {
    for (Eigen::Index i = b.size() - 1; i >= 0; --i)
    {
      for (Eigen::Index j = i + 1; j < b.size(); ++j)
        b[i] -= m_r(i, j) * b[j];
      b[i] /= m_r(i, i);
    }
    return b;
  }

private:
  Dense_matrix m_v, m_t, m_r;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POLYNOMIAL_NULL_SPACE_H
