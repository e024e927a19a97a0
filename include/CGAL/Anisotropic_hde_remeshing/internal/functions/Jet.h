// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_JET_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_JET_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The value of a function at a point with its derivatives up to the order. Algorithms for jets serve three purposes: order 0 is
// the value alone, order 1 has the gradient for the projection, and order 2 the Hessian for the curvatures.
template <int order_>
struct Jet;

template <>
struct Jet<0>
{
  static constexpr int order = 0;
  double value = 0;
};

template <>
struct Jet<1> : Jet<0>
{
  static constexpr int order = 1;
  Vector gradient = Vector::Zero();
};

template <>
struct Jet<2> : Jet<1>
{
  static constexpr int order = 2;
  Matrix hessian = Matrix::Zero();
};

typedef Jet<1> Value_and_gradient;

// left + weight (right - left), by Leibniz' rule
template <int order>
Jet<order> interpolated(const Jet<order>& left, const Jet<order>& right, const Jet<order>& weight)
{
  Jet<order> result;
  const double difference = right.value - left.value;
  result.value = left.value + weight.value * difference;
  if constexpr (order >= 1)
    result.gradient = left.gradient + weight.value * (right.gradient - left.gradient) + difference * weight.gradient;
  if constexpr (order >= 2)
  {
    const Matrix mixed = weight.gradient * (right.gradient - left.gradient).transpose();
    result.hessian =
        left.hessian + weight.value * (right.hessian - left.hessian) + mixed + mixed.transpose() + difference * weight.hessian;
  }
  return result;
}

// f(jet), by the chain rule, from the value of f and its first two derivatives there
template <int order>
Jet<order> composed(const double f, const double first, const double second, const Jet<order>& jet)
{
  Jet<order> result;
  result.value = f;
  if constexpr (order >= 1)
    result.gradient = first * jet.gradient;
  if constexpr (order >= 2)
    result.hessian = first * jet.hessian + second * jet.gradient * jet.gradient.transpose();
  (void)first;
  (void)second;
  return result;
}

// the quintic that rises from 0 to 1 over [0, 1] with two vanishing derivatives at both ends
template <int order>
Jet<order> smoothstep(const Jet<order>& jet)
{
  const double t = jet.value;
  return composed(t * t * t * (10 + t * (6 * t - 15)), 30 * t * t * (1 - t) * (1 - t), 60 * t * (1 - t) * (1 - 2 * t), jet);
}

// the distance to the plane normal . p = position, in units of `unit`
template <int order>
Jet<order> plane_distance(const Vector& p, const Vector& normal, const double position, const double unit)
{
  Jet<order> result;
  result.value = (normal.dot(p) - position) / unit;
  if constexpr (order >= 1)
    result.gradient = normal / unit;
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_JET_H
