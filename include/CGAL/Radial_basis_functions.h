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

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_shape_parameter.h>

#include <cmath>

namespace CGAL {

/// \addtogroup PkgAnisotropicHdeRemeshingKernels
///
/// The kernels are the functions of the paper's Table 1, in Wendland's forms, and the thin plate spline. Kernels with a shape
/// parameter take it in units of the local spacing of the points by default. The larger it is, the smoother is the interpolant
/// and the worse the condition of its system.
/// @{

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

What a kernel \f$ \phi \f$ returns for a distance \f$ r \f$: its value and its derivatives, in the form that the concept
`RadialBasisFunction` asks for.

\tparam T `double`, or an array of `double`s
\tparam order the number of derivatives, 1 or 2
*/
template <typename T, int order = 2>
struct Rbf_jet
{
  static_assert(order == 2, "the order is 1 or 2");
  T value;  ///< \f$ \phi(r) \f$
  T first;  ///< \f$ \phi'(r) / r \f$
  T second; ///< \f$ (\phi'(r) / r)' / r \f$; only if `order` is 2
};

template <typename T>
struct Rbf_jet<T, 1>
{
  T value;
  T first;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels
the unit of the shape parameter of a kernel
*/
enum class Rbf_length_unit
{
  LOCAL_SPACING, ///< the distance between neighbouring points of the patch: the same shape for meshes of any scale and density
  COORDINATES    ///< the unit of the coordinates
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

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
  Rbf_jet<T> operator()(const T& squared_radius) const
  {
    using std::sqrt;
    const T r = sqrt(squared_radius);
    return {squared_radius * r, 3. * r, 3. / (r + Anisotropic_hde_remeshing::internal::smallest_radius)};
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

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
  Rbf_jet<T> operator()(const T& squared_radius) const
  {
    using std::log;
    const T r2 = squared_radius + Anisotropic_hde_remeshing::internal::smallest_squared_radius;
    const T log_r2 = log(r2);
    return {0.5 * squared_radius * log_r2, log_r2 + 1., 2. / r2};
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

The Gaussian \f$ \phi(r) = e^{-(r/w)^2} \f$ with the width \f$ w \f$, positive definite.

Use it for well-spaced points only: on scans it oscillates between them.
*/
class Gaussian_rbf
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \brief the kernel with a width
  /// \param width the shape parameter \f$ w \f$
  /// \param unit that of the width
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Gaussian_rbf(const double width = 1.4, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : m_width("width of the radial function", width, unit == Rbf_length_unit::COORDINATES)
  {
  }

  static const char* name() { return "Gaussian exp(-(r/w)^2)"; }

  double length() const { return m_width.length(); }                 ///< the width, as it was given
  void set_unit(const double spacing) { m_width.set_unit(spacing); } ///< as in the concept

  template <class T>
  Rbf_jet<T> operator()(const T& squared_radius) const
  {
    using std::exp;
    const double c = m_width.inverse_square();
    Rbf_jet<T> phi;
    phi.value = exp(T(-c * squared_radius));
    phi.first = (-2. * c) * phi.value;
    phi.second = (-2. * c) * phi.first;
    return phi;
  }

private:
  Anisotropic_hde_remeshing::internal::Rbf_shape_parameter m_width;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

The multiquadric \f$ \phi(r) = \sqrt{1 + (r/w)^2} \f$ with the width \f$ w \f$; \f$ -\phi \f$ is conditionally positive
definite of order 1.
*/
class Multiquadric_rbf
{
public:
  static constexpr unsigned int order = 1;
  static constexpr double sign = -1;

  /// \brief the kernel with a width
  /// \param width the shape parameter \f$ w \f$
  /// \param unit that of the width
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Multiquadric_rbf(const double width = 1.5, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : m_width("width of the radial function", width, unit == Rbf_length_unit::COORDINATES)
  {
  }

  static const char* name() { return "multiquadric sqrt(1 + (r/w)^2)"; }

  double length() const { return m_width.length(); }                 ///< the width, as it was given
  void set_unit(const double spacing) { m_width.set_unit(spacing); } ///< as in the concept

  template <class T>
  Rbf_jet<T> operator()(const T& squared_radius) const
  {
    using std::sqrt;
    const double c = m_width.inverse_square();
    Rbf_jet<T> phi;
    phi.value = sqrt(T(1. + c * squared_radius));
    phi.first = c / phi.value;
    phi.second = -phi.first * phi.first / phi.value;
    return phi;
  }

private:
  Anisotropic_hde_remeshing::internal::Rbf_shape_parameter m_width;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

The inverse multiquadric \f$ \phi(r) = 1 / \sqrt{1 + (r/w)^2} \f$ with the width \f$ w \f$, positive definite.
*/
class Inverse_multiquadric_rbf
{
public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \brief the kernel with a width
  /// \param width the shape parameter \f$ w \f$
  /// \param unit that of the width
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Inverse_multiquadric_rbf(const double width = 2, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : m_width("width of the radial function", width, unit == Rbf_length_unit::COORDINATES)
  {
  }

  static const char* name() { return "inverse multiquadric 1 / sqrt(1 + (r/w)^2)"; }

  double length() const { return m_width.length(); }                 ///< the width, as it was given
  void set_unit(const double spacing) { m_width.set_unit(spacing); } ///< as in the concept

  template <class T>
  Rbf_jet<T> operator()(const T& squared_radius) const
  {
    using std::sqrt;
    const double c = m_width.inverse_square();
    Rbf_jet<T> phi;
    phi.value = 1. / sqrt(T(1. + c * squared_radius));
    phi.first = -c * phi.value * phi.value * phi.value;
    phi.second = (-3. * c) * phi.first * phi.value * phi.value;
    return phi;
  }

private:
  Anisotropic_hde_remeshing::internal::Rbf_shape_parameter m_width;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingKernels

Wendland's functions, positive definite, `smoothness` times continuously differentiable and zero beyond the support radius
\f$ R \f$. With \f$ t = r/R \f$ they are

| smoothness | \f$ \phi(r) \f$                                |
|------------|------------------------------------------------|
| 2          | \f$ (1 - t)_+^4 (4t + 1) \f$                   |
| 4          | \f$ (1 - t)_+^6 (35t^2 + 18t + 3) \f$          |
| 6          | \f$ (1 - t)_+^8 (32t^3 + 25t^2 + 8t + 1) \f$   |

A small support makes the system of a patch sparse. Sparse Cholesky factorisation then solves it, and large patches are
affordable, up to a single one (`number_of_patches(1)`).
*/
template <int smoothness>
class Wendland_rbf
{
  static_assert(smoothness == 2 || smoothness == 4 || smoothness == 6, "there are Wendland_rbf<2>, <4> and <6>");

public:
  static constexpr unsigned int order = 0;
  static constexpr double sign = 1;

  /// \brief the kernel with a radius of its support
  /// \param support_radius the shape parameter \f$ R \f$
  /// \param unit that of the radius
  /// \throw std::invalid_argument unless it is finite and positive
  explicit Wendland_rbf(const double support_radius = 10, const Rbf_length_unit unit = Rbf_length_unit::LOCAL_SPACING)
    : m_radius("support_radius of the radial function", support_radius, unit == Rbf_length_unit::COORDINATES)
  {
  }

  static const char* name()
  {
    return smoothness == 2   ? "Wendland C2 (1-r)^4 (4r+1)"
           : smoothness == 4 ? "Wendland C4 (1-r)^6 (35r^2+18r+3)"
                             : "Wendland C6 (1-r)^8 (32r^3+25r^2+8r+1)";
  }

  double length() const { return m_radius.length(); }                 ///< the radius, as it was given
  void set_unit(const double spacing) { m_radius.set_unit(spacing); } ///< as in the concept

  /// in units of the local spacing
  double support_radius() const { return 1. / std::sqrt(m_radius.inverse_square()); }

  template <class T>
  Rbf_jet<T> operator()(const T& squared_radius) const
  {
    using std::sqrt;
    namespace internal = Anisotropic_hde_remeshing::internal;
    const double c = m_radius.inverse_square();
    const T t = sqrt(T(c * squared_radius));
    const T s = internal::positive_part(T(1. - t)), s2 = s * s;
    if constexpr (smoothness == 2)
      return {s2 * s * s * (4. * t + 1.), (-20. * c) * s * s * s, (60. * c * c) * s * s / (t + internal::smallest_radius)};
    else if constexpr (smoothness == 4)
    {
      const T s5 = s2 * s2 * s;
      return {s5 * s * (35. * t * t + 18. * t + 3.), (-56. * c) * s5 * (5. * t + 1.), (1680. * c * c) * s * s * s * s};
    }
    else
    {
      const T s7 = s2 * s2 * s2 * s;
      return {s7 * s * (32. * t * t * t + 25. * t * t + 8. * t + 1.), (-22. * c) * s7 * (16. * t * t + 7. * t + 1.),
              (528. * c * c) * s2 * s2 * s2 * (6. * t + 1.)};
    }
  }

private:
  Anisotropic_hde_remeshing::internal::Rbf_shape_parameter m_radius;
};

/// \ingroup PkgAnisotropicHdeRemeshingKernels
/// \f$ (1 - t)_+^4 (4t + 1) \f$
typedef Wendland_rbf<2> Wendland_C2_rbf;
/// \ingroup PkgAnisotropicHdeRemeshingKernels
/// \f$ (1 - t)_+^6 (35t^2 + 18t + 3) \f$
typedef Wendland_rbf<4> Wendland_C4_rbf;
/// \ingroup PkgAnisotropicHdeRemeshingKernels
/// \f$ (1 - t)_+^8 (32t^3 + 25t^2 + 8t + 1) \f$
typedef Wendland_rbf<6> Wendland_C6_rbf;

/// @}

} // namespace CGAL

#endif // CGAL_RADIAL_BASIS_FUNCTIONS_H
