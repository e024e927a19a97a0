// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_RADIAL_BASIS_FUNCTIONS_H
#define CGAL_RADIAL_BASIS_FUNCTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cmath>
#include <limits>

namespace CGAL {

/// \defgroup PkgAnisotropicHdeRemeshingKernels Radial Basis Functions
/// Models of the concept `RadialBasisFunction`.
///
/// A model has
/// - `static constexpr unsigned int order`: the order of conditional positive definiteness; the interpolant carries
///   a polynomial of degree `order - 1`, none if it is 0;
/// - `static constexpr double sign`: 1 if the quadratic form is positive on the null space of the polynomials' transposed
///   matrix, -1 if it is negative there;
/// - `static const char* name()`;
/// - `template <class T> void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const`, which
///   computes \f$ \phi(r) \f$ and \f$ \phi'(r)/r \f$ from \f$ r^2 \f$. `T` is `double` or an array of the library Eigen,
///   so that one text serves the plain and the vectorised loop. It must return finite values for `r = 0`.
///
/// Radii are relative to the radius of the patch, whose centres lie in the unit ball.
/// @{

/*!
The polyharmonic spline \f$ \phi(r) = r^3 \f$, conditionally positive definite of order 2.

It has no shape parameter. The interpolant is twice continuously differentiable, and of the kernels of this package it is
the one to take for scans: its error on a smooth surface decays with the third to fourth power of the spacing.
*/
struct Polyharmonic_rbf
{
  static constexpr unsigned int order = 2;
  static constexpr double sign = 1;

  static const char* name() { return "polyharmonic spline r^3"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::sqrt;
    const T radius = sqrt(squared_radius);
    value = squared_radius * radius;
    derivative_over_radius = 3. * radius;
  }
};

/*!
The thin plate spline \f$ \phi(r) = r^2 \log r \f$, conditionally positive definite of order 2; the kernel of the paper's
examples.

It has no shape parameter. The interpolant is continuously differentiable, and its second derivatives have logarithmic poles
at the centres.
*/
struct Thin_plate_rbf
{
  static constexpr unsigned int order = 2;
  static constexpr double sign = 1;

  static const char* name() { return "thin plate spline r^2 log r"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::log;
    // the smallest normal number keeps the logarithm finite at a centre, where its factors vanish
    const T squared_logarithm = log(T(squared_radius + (std::numeric_limits<double>::min)()));
    value = 0.5 * squared_radius * squared_logarithm;
    derivative_over_radius = squared_logarithm + 1.;
  }
};

/// @}

} // namespace CGAL

#endif // CGAL_RADIAL_BASIS_FUNCTIONS_H
