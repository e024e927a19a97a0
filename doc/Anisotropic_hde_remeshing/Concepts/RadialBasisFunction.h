// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/*!
\ingroup PkgAnisotropicHdeRemeshingConcepts
\cgalConcept

The concept `RadialBasisFunction` describes a kernel \f$ \phi(r), r \ge 0 \f$, of the interpolants
\f[ s(x) = h \, \bigl( \sum_j \alpha_j \, \phi(|y - y_j|) + p(y) \bigr), \quad y = (x - c) / h, \f]
of the patches of `CGAL::Rbf_implicit_function`. Here \f$ c \f$ is a centre and \f$ h \f$ the local spacing of the points of the
patch, the median of their mean distances to their neighbours. The polynomial \f$ p \f$ is linear. Where the normals of the
patch have a common direction, it also has the squares and the product of two coordinates along the surface. This is more than
kernels of order 2 need. It is the same for all kernels.

<b>Units.</b> \f$ r \f$ is in units of the local spacing. A shape parameter may be in these units, too. It then fits meshes of
all sizes and densities.

<b>Thread safety.</b> `operator()` may be called from several threads at once on one object.

A model is copyable and default constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Polyharmonic_rbf}
\cgalHasModels{CGAL::Thin_plate_rbf}
\cgalHasModels{CGAL::Gaussian_rbf}
\cgalHasModels{CGAL::Multiquadric_rbf}
\cgalHasModels{CGAL::Inverse_multiquadric_rbf}
\cgalHasModels{CGAL::Wendland_C2_rbf}
\cgalHasModels{CGAL::Wendland_C4_rbf}
\cgalHasModels{CGAL::Wendland_C6_rbf}
\cgalHasModelsEnd

\sa `CGAL::Rbf_implicit_function`
*/
class RadialBasisFunction
{
public:
  /// \name Constants
  /// @{

  /// the order \f$ m \f$ of conditional positive definiteness, 0, 1 or 2; 0 if the kernel is positive definite.
  static constexpr unsigned int order = unspecified;

  /// 1 or -1: the matrix with the entries `sign` \f$ \phi(|y_i - y_j|) \f$ is positive definite on the vectors
  /// \f$ \alpha \neq 0 \f$ with \f$ \sum_j \alpha_j q(y_j) = 0 \f$ for all polynomials \f$ q \f$ of degree below `order`. This
  /// holds for different centres \f$ y_j \f$ in \f$ R^3 \f$, if no such polynomial but zero vanishes on all of them.
  static constexpr double sign = unspecified;

  /// @}

  /// \name Operations
  /// @{

  /// the name, with the formula, for reports
  static const char* name();

  /*!
  computes from `squared_radius` \f$ = r^2 \f$
  - `value` \f$ = \phi(r) \f$, without `sign`, and
  - `derivative_over_radius` \f$ = \phi'(r) / r \f$, the derivative by \f$ r \f$ (not by \f$ r^2 \f$) divided by \f$ r \f$.
    The gradient of \f$ \phi(|y|) \f$ by \f$ y \f$ is this number times \f$ y \f$.

  Both must be finite at \f$ r = 0 \f$. There `value` is \f$ \phi(0) \f$. `derivative_over_radius` is multiplied by the zero
  vector there: if its limit is infinite, any finite number serves.

  `T` is `double`, `Eigen::ArrayXd` or an array of fixed size, `Eigen::Array<double, n, 1>`. The elements of an array are
  computed one by one. The body uses arithmetic operators and functions such as `sqrt` found by argument-dependent lookup (after
  `using std::sqrt;`). It does not branch on the values. `value` and `derivative_over_radius` are no aliases of `squared_radius`
  and have its size.
  */
  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const;

  /// @}

  /// \name Optional Operations
  /// @{

  /*!
  computes in addition to the above `second` \f$ = (\phi'(r) / r)' / r \f$, where the prime is the derivative by \f$ r \f$. The
  Hessian of \f$ \phi(|y|) \f$ is `first` times the identity plus `second` times \f$ y y^T \f$. `second` must be finite at
  \f$ r = 0 \f$, where it is multiplied by zero. `CGAL::Rbf_implicit_function::hessian()` and what is computed from it need this
  operation.
  */
  template <class T>
  void operator()(const T& squared_radius, T& value, T& first, T& second) const;

  /// tells the kernel the local spacing of the patch in the unit of the coordinates. The patch calls it before it uses the
  /// kernel. It serves kernels with a shape parameter in that unit.
  void set_unit(double spacing);

  /// the radius, in units of the local spacing, beyond which the kernel is zero. It makes the systems of large patches sparse,
  /// and evaluations skip centres that are farther away. The kernel must be of order 0.
  double support_radius() const;

  /// @}
};
