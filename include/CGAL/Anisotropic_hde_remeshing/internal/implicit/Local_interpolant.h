// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LOCAL_INTERPOLANT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LOCAL_INTERPOLANT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Value_and_gradient.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The interpolant of a patch, s(x) = sum_j alpha_j phi(|y - y_j|) + beta_0 + beta . y with y = (x - centre) / radius, so
// that the system and the sums are those of the unit ball wherever and however large the patch is (the paper's (9), (10)).
template <typename RadialFunction>
class Local_interpolant
{
  // the number of centres that one step of the loop takes: two registers of AVX, four of SSE2
  static constexpr Eigen::Index lanes = 8;
  typedef Eigen::Array<double, lanes, 1> Lanes;

  // blocks of x, y, z, weight, `lanes` numbers each
  typedef Eigen::Array<double, lanes, Eigen::Dynamic> Blocks;

public:
  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;

  Local_interpolant() = default;

  // `centres` are in the coordinates of the unit ball
  Local_interpolant(const Vector& centre, const double radius, const Points& centres, const Eigen::VectorXd& weights,
                    const Eigen::Vector4d& polynomial, const RadialFunction& function)
    : m_centre(centre), m_radius(radius), m_polynomial(polynomial), m_function(function)
  {
    const Eigen::Index number_of_blocks = (centres.cols() + lanes - 1) / lanes;
    m_blocks = Blocks::Zero(lanes, 4 * number_of_blocks); // padding: centres at the origin with weight 0
    for (Eigen::Index i = 0; i < centres.cols(); ++i)
    {
      const Eigen::Index column = 4 * (i / lanes), lane = i % lanes;
      for (Eigen::Index k = 0; k < 3; ++k)
        m_blocks(lane, column + k) = centres(k, i);
      m_blocks(lane, column + 3) = weights[i];
    }
  }

  Value_and_gradient operator()(const Vector& p) const
  {
    const Vector y = (p - m_centre) / m_radius;
    Lanes value = Lanes::Zero(), gradient_x = Lanes::Zero(), gradient_y = Lanes::Zero(), gradient_z = Lanes::Zero();
    for (Eigen::Index column = 0; column < m_blocks.cols(); column += 4)
    {
      const Lanes x_difference = y[0] - m_blocks.col(column);
      const Lanes y_difference = y[1] - m_blocks.col(column + 1);
      const Lanes z_difference = y[2] - m_blocks.col(column + 2);
      const Lanes squared_radius =
          x_difference * x_difference + y_difference * y_difference + z_difference * z_difference;
      Lanes phi, derivative_over_radius;
      m_function(squared_radius, phi, derivative_over_radius);
      value += m_blocks.col(column + 3) * phi;
      derivative_over_radius *= m_blocks.col(column + 3);
      gradient_x += derivative_over_radius * x_difference;
      gradient_y += derivative_over_radius * y_difference;
      gradient_z += derivative_over_radius * z_difference;
    }
    Value_and_gradient result;
    result.value = m_radius * (value.sum() + m_polynomial[0] + m_polynomial.tail<3>().dot(y));
    result.gradient = Vector(gradient_x.sum(), gradient_y.sum(), gradient_z.sum()) + m_polynomial.tail<3>();
    return result;
  }

  std::size_t memory_bytes() const { return sizeof(*this) + sizeof(double) * std::size_t(m_blocks.size()); }

private:
  Vector m_centre = Vector::Zero();
  double m_radius = 1;
  Eigen::Vector4d m_polynomial = Eigen::Vector4d::Zero();
  Blocks m_blocks;
  RadialFunction m_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LOCAL_INTERPOLANT_H
