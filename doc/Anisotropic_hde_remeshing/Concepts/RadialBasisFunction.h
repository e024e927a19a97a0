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
\sa `CGAL::Rbf_jet`
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
  returns, for `squared_radius` \f$ = r^2 \f$, an object of type `CGAL::Rbf_jet<T, 1>` or `CGAL::Rbf_jet<T, 2>`, or of any type with
  the same members of type `T`:
  - `value` \f$ = \phi(r) \f$, without `sign`,
  - `first` \f$ = \phi'(r) / r \f$, the derivative by \f$ r \f$ (not by \f$ r^2 \f$) divided by \f$ r \f$. The gradient of
    \f$ \phi(|y|) \f$ by \f$ y \f$ is this number times \f$ y \f$.
  - `second` \f$ = (\phi'(r) / r)' / r \f$, which is optional. The Hessian of \f$ \phi(|y|) \f$ is `first` times the identity plus
    `second` times \f$ y y^T \f$. `CGAL::Rbf_implicit_function::hessian()` and what is computed from it need this member.

  All must be finite at \f$ r = 0 \f$. There `value` is \f$ \phi(0) \f$. The others are multiplied by zero there: if a limit is
  infinite, any finite number serves.

  `T` is `double`, or an array of a few `double`s, whose elements are computed one by one. Arrays have the arithmetic operators, among
  themselves and with `double`. Functions such as `sqrt`, `exp`, `log` and `abs` are found by argument-dependent lookup (after
  `using std::sqrt;`). The results of these are no arrays, but convert to `T`: intermediate results are declared as `const T`. (The
  package uses `Eigen::Array<double, n, 1>`.) The body does not branch on the values. Members that are not used are not
  computed: the compiler inlines the operation and drops them.
  */
  template <class T>
  CGAL::Rbf_jet<T, 2> operator()(const T& squared_radius) const;

  /// @}

  /// \name Optional Operations
  /// @{

  /// tells the kernel the local spacing of the patch in the unit of the coordinates. The patch calls it before it uses the
  /// kernel. It serves kernels with a shape parameter in that unit.
  void set_unit(double spacing);

  /// the radius, in units of the local spacing, beyond which the kernel is zero. It makes the systems of large patches sparse,
  /// and evaluations skip centres that are farther away. The kernel must be of order 0.
  double support_radius() const;

  /// @}
};
