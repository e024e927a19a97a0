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

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>

#include <cmath>
#include <limits>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels
the unit of the shape parameter of a kernel
*/
enum class Rbf_length_unit
{
  LOCAL_SPACING, ///< the distance between neighbouring points of the patch: the same shape for meshes of any scale and density
  COORDINATES    ///< the unit of the coordinates
};

namespace Anisotropic_hde_remeshing {
namespace internal {

// the width or the support radius of a kernel, and the inverse of its square in the unit of a patch
class Rbf_shape_parameter
{
public:
  double length() const { return m_length; }

  // computes the parameter in the unit of a patch; `spacing` is the local spacing of the patch in the unit of the coordinates
  void set_unit(const double spacing)
  {
    m_inverse_square = 1. / (m_length * m_length);
    if (m_unit == Rbf_length_unit::COORDINATES)
      m_inverse_square *= spacing * spacing;
  }

protected:
  Rbf_shape_parameter(const char* name, const double length, const Rbf_length_unit unit)
    : m_length(checked_positive(name, length)), m_unit(unit), m_inverse_square(1. / (length * length))
  {
  }

  double inverse_square() const { return m_inverse_square; }

private:
  double m_length;
  Rbf_length_unit m_unit;
  double m_inverse_square;
};

// the same for a kernel that is zero beyond this length
class Rbf_support : public Rbf_shape_parameter
{
public:
  // in the unit of the patch
  double support_radius() const { return 1. / std::sqrt(inverse_square()); }

protected:
  Rbf_support(const double radius, const Rbf_length_unit unit)
    : Rbf_shape_parameter("support_radius of the radial function", radius, unit)
  {
  }
};

// (x)_+ without a branch, for numbers and for arrays
template <class T>
T positive_part(const T& x)
{
  using std::abs;
  return 0.5 * (x + abs(x));
}

// Keeps a square root or a logarithm of r^2 finite at a centre. The factors that it is multiplied by vanish there.
constexpr double smallest_squared_radius = (std::numeric_limits<double>::min)();

} // namespace internal
} // namespace Anisotropic_hde_remeshing

/// \defgroup PkgAnisotropicHdeRemeshingKernels Radial Basis Functions
/// Models of the concept `RadialBasisFunction`: the functions of the paper's Table 1, in Wendland's forms, and the thin plate
/// spline. Kernels with a shape parameter take it in units of the local spacing of the points by default. The larger it is,
/// the smoother is the interpolant and the worse the condition of its system.
/// @{

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The polyharmonic spline \f$ \phi(r) = r^3 \f$, conditionally positive definite of order 2.

It has no shape parameter. The interpolant is twice continuously differentiable. Of the kernels of this package, take this one
for scans: its error on a smooth surface decays with the third to fourth power of the spacing.
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

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    using std::sqrt;
    (*this)(squared_radius, value, first);
    second = 3. / sqrt(T(squared_radius + Anisotropic_hde_remeshing::internal::smallest_squared_radius));
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The thin plate spline \f$ \phi(r) = r^2 \log r \f$, conditionally positive definite of order 2. It is the kernel of the paper's
examples.

It has no shape parameter. The interpolant is continuously differentiable. Its second derivatives have logarithmic poles at the
centres.
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
    const T squared_logarithm = log(T(squared_radius + Anisotropic_hde_remeshing::internal::smallest_squared_radius));
    value = 0.5 * squared_radius * squared_logarithm;
    derivative_over_radius = squared_logarithm + 1.;
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    (*this)(squared_radius, value, first);
    second = 2. / (squared_radius + Anisotropic_hde_remeshing::internal::smallest_squared_radius);
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The Gaussian \f$ \phi(r) = e^{-(r/w)^2} \f$ with the width \f$ w \f$, positive definite.

Use it for well-spaced points only: on scans it oscillates between them.
*/
class Gaussian_rbf : public Anisotropic_hde_remeshing::internal::Rbf_shape_parameter
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \param width the shape parameter \f$ w \f$
  /// \param unit that of the width
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Gaussian_rbf(const double width = 1.4, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : Rbf_shape_parameter("width of the radial function", width, unit)
  {
  }

  static const char* name() { return "Gaussian exp(-(r/w)^2)"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::exp;
    value = exp(T(-inverse_square() * squared_radius));
    derivative_over_radius = (-2. * inverse_square()) * value;
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    (*this)(squared_radius, value, first);
    second = (-2. * inverse_square()) * first;
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The multiquadric \f$ \phi(r) = \sqrt{1 + (r/w)^2} \f$ with the width \f$ w \f$; \f$ -\phi \f$ is conditionally positive
definite of order 1.
*/
class Multiquadric_rbf : public Anisotropic_hde_remeshing::internal::Rbf_shape_parameter
{
public:
  static constexpr unsigned int order = 1;
  static constexpr double sign = -1;

  /// \param width the shape parameter \f$ w \f$
  /// \param unit that of the width
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Multiquadric_rbf(const double width = 1.5, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : Rbf_shape_parameter("width of the radial function", width, unit)
  {
  }

  static const char* name() { return "multiquadric sqrt(1 + (r/w)^2)"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::sqrt;
    value = sqrt(T(1. + inverse_square() * squared_radius));
    derivative_over_radius = inverse_square() / value;
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    (*this)(squared_radius, value, first);
    second = -first * first / value;
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

The inverse multiquadric \f$ \phi(r) = 1 / \sqrt{1 + (r/w)^2} \f$ with the width \f$ w \f$, positive definite.
*/
class Inverse_multiquadric_rbf : public Anisotropic_hde_remeshing::internal::Rbf_shape_parameter
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \param width the shape parameter \f$ w \f$
  /// \param unit that of the width
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Inverse_multiquadric_rbf(const double width = 2, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : Rbf_shape_parameter("width of the radial function", width, unit)
  {
  }

  static const char* name() { return "inverse multiquadric 1 / sqrt(1 + (r/w)^2)"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::sqrt;
    value = 1. / sqrt(T(1. + inverse_square() * squared_radius));
    derivative_over_radius = -inverse_square() * value * value * value;
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    (*this)(squared_radius, value, first);
    second = (-3. * inverse_square()) * first * value * value;
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

Wendland's function \f$ \phi(r) = (1 - t)_+^4 (4t + 1), t = r/R \f$, positive definite, twice continuously differentiable and
zero beyond the support radius \f$ R \f$.

A small support makes the system of a patch sparse. Sparse Cholesky factorisation then solves it, and large patches are
affordable, up to a single one (`number_of_patches(1)`).
*/
class Wendland_C2_rbf : public Anisotropic_hde_remeshing::internal::Rbf_support
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \param support_radius the shape parameter \f$ R \f$
  /// \param unit that of the radius
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Wendland_C2_rbf(const double support_radius = 10, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : Rbf_support(support_radius, unit)
  {
  }

  static const char* name() { return "Wendland C2 (1-r)^4 (4r+1)"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::sqrt;
    const T t = sqrt(T(inverse_square() * squared_radius));
    const T s = Anisotropic_hde_remeshing::internal::positive_part(T(1. - t));
    value = s * s * s * s * (4. * t + 1.);
    derivative_over_radius = (-20. * inverse_square()) * s * s * s;
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    using std::sqrt;
    (*this)(squared_radius, value, first);
    const T t = sqrt(T(inverse_square() * squared_radius + Anisotropic_hde_remeshing::internal::smallest_squared_radius));
    const T s = Anisotropic_hde_remeshing::internal::positive_part(T(1. - t));
    second = (60. * inverse_square() * inverse_square()) * s * s / t;
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

Wendland's function \f$ \phi(r) = (1 - t)_+^6 (35t^2 + 18t + 3), t = r/R \f$, positive definite, four times continuously
differentiable and zero beyond the support radius \f$ R \f$; see `Wendland_C2_rbf`.
*/
class Wendland_C4_rbf : public Anisotropic_hde_remeshing::internal::Rbf_support
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \param support_radius the shape parameter \f$ R \f$
  /// \param unit that of the radius
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Wendland_C4_rbf(const double support_radius = 10, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : Rbf_support(support_radius, unit)
  {
  }

  static const char* name() { return "Wendland C4 (1-r)^6 (35r^2+18r+3)"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::sqrt;
    const T t = sqrt(T(inverse_square() * squared_radius));
    const T s = Anisotropic_hde_remeshing::internal::positive_part(T(1. - t));
    const T s2 = s * s;
    const T s5 = s2 * s2 * s;
    value = s5 * s * (35. * t * t + 18. * t + 3.);
    derivative_over_radius = (-56. * inverse_square()) * s5 * (5. * t + 1.);
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    using std::sqrt;
    (*this)(squared_radius, value, first);
    const T t = sqrt(T(inverse_square() * squared_radius));
    const T s = Anisotropic_hde_remeshing::internal::positive_part(T(1. - t));
    second = (1680. * inverse_square() * inverse_square()) * s * s * s * s;
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

Wendland's function \f$ \phi(r) = (1 - t)_+^8 (32t^3 + 25t^2 + 8t + 1), t = r/R \f$, positive definite, six times continuously
differentiable and zero beyond the support radius \f$ R \f$; see `Wendland_C2_rbf`.
*/
class Wendland_C6_rbf : public Anisotropic_hde_remeshing::internal::Rbf_support
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \param support_radius the shape parameter \f$ R \f$
  /// \param unit that of the radius
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Wendland_C6_rbf(const double support_radius = 10, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : Rbf_support(support_radius, unit)
  {
  }

  static const char* name() { return "Wendland C6 (1-r)^8 (32r^3+25r^2+8r+1)"; }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const
  {
    using std::sqrt;
    const T t = sqrt(T(inverse_square() * squared_radius));
    const T s = Anisotropic_hde_remeshing::internal::positive_part(T(1. - t));
    const T s2 = s * s;
    const T s7 = s2 * s2 * s2 * s;
    value = s7 * s * (32. * t * t * t + 25. * t * t + 8. * t + 1.);
    derivative_over_radius = (-22. * inverse_square()) * s7 * (16. * t * t + 7. * t + 1.);
  }

  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const
  {
    using std::sqrt;
    (*this)(squared_radius, value, first);
    const T t = sqrt(T(inverse_square() * squared_radius));
    const T s = Anisotropic_hde_remeshing::internal::positive_part(T(1. - t));
    const T s2 = s * s;
    second = (528. * inverse_square() * inverse_square()) * s2 * s2 * s2 * (6. * t + 1.);
  }
};

/// @}

} // namespace CGAL

#endif // CGAL_RADIAL_BASIS_FUNCTIONS_H
