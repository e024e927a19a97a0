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

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Kernel_sum.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patch_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Quadratic_polynomial.h>
#include <CGAL/Radial_basis_functions.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the interpolant of a patch, s(x) = unit (sum_j alpha_j phi(|y - y_j|) + a polynomial in y), the paper's (9) and (10)
template <typename RadialFunction>
class Local_interpolant
{
  // r^-16: the sum over the centres is a smooth measure of the distance to the nearest of them
  struct Inverse_power
  {
    double inverse_scale;

    template <class T>
    Rbf_jet<T> operator()(const T& squared_radius) const
    {
      const T r2 = inverse_scale * squared_radius;
      const T r4 = r2 * r2, r8 = r4 * r4;
      Rbf_jet<T> result;
      result.value = 1. / (r8 * r8);
      result.first = (-16. * inverse_scale) * result.value / r2;
      result.second = (-18. * inverse_scale) * result.first / r2;
      return result;
    }
  };

public:
  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;

  Local_interpolant() = default;

  // `centres` are in the coordinates of the frame
  Local_interpolant(const Patch_frame& frame, const Points& centres, const Eigen::VectorXd& weights,
                    const Quadratic_polynomial& polynomial, const RadialFunction& function)
    : m_frame(frame), m_polynomial(polynomial), m_sum(centres, weights, function)
  {
  }

  // `squared_distance` to the nearest centre is in units of the frame
  template <int order>
  Jet<order> evaluate(const Vector& p, double& squared_distance) const
  {
    const Vector y = m_frame(p);
    Jet<order> result = m_sum.template evaluate<order>(y, squared_distance);
    m_polynomial.add_to(result, y);
    result.value *= m_frame.unit;
    if constexpr (order >= 2)
      result.hessian /= m_frame.unit;
    return result;
  }

  // A smooth function that is at most the distance to the nearest centre and close to it, in units of the frame.
  // `squared_distance` is the square of that distance. It is the scale of the sums.
  template <int order>
  Jet<order> smooth_distance(const Vector& p, const double squared_distance) const
  {
    Jet<order> sum = m_sum.template evaluate_unweighted<order>(m_frame(p), Inverse_power{1. / squared_distance});
    if constexpr (order >= 1)
      sum.gradient /= m_frame.unit;
    if constexpr (order >= 2)
      sum.hessian /= m_frame.unit * m_frame.unit;
    const double root = std::sqrt(squared_distance) * std::pow(sum.value, -1. / 16);
    return composed(root, -root / (16 * sum.value), 17 * root / (256 * sum.value * sum.value), sum);
  }

  double unit() const { return m_frame.unit; }
  const RadialFunction& function() const { return m_sum.function(); }

  std::size_t memory_bytes() const { return sizeof(*this) + m_sum.memory_bytes(); }

private:
  Patch_frame m_frame;
  Quadratic_polynomial m_polynomial;
  Kernel_sum<RadialFunction> m_sum;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LOCAL_INTERPOLANT_H
