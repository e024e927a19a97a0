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
\f[ s(x) = \sum_j \alpha_j \, \phi(|y - y_j|) + p(y), \quad y = (x - c) / \rho, \f]
of the patches of `CGAL::Rbf_implicit_function`, with the centre \f$ c \f$ and the radius \f$ \rho \f$ of the patch and a
polynomial \f$ p \f$ of degree `order` - 1.

<b>Units.</b> \f$ r \f$ has none: it is relative to the radius of the patch, whose centres lie in the unit ball, hence from
0 to 2 between two of them. A shape parameter of a model is relative to that radius, too.

<b>Thread safety.</b> `operator()` may be called from several threads at once on one object.

A model is copyable. With the default of the named parameter `radial_function` it is also default constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Polyharmonic_rbf}
\cgalHasModels{CGAL::Thin_plate_rbf}
\cgalHasModelsEnd

\sa `CGAL::Rbf_implicit_function`
*/
class RadialBasisFunction
{
public:
  /// \name Constants
  /// @{

  /// the order \f$ m \f$ of conditional positive definiteness, 0, 1 or 2: the interpolant has no polynomial, a constant or a
  /// linear polynomial. 0 if the kernel is positive definite.
  static constexpr unsigned int order = unspecified;

  /// 1 or -1: the matrix with the entries `sign` \f$ \phi(|y_i - y_j|) \f$ is positive definite on the vectors
  /// \f$ \alpha \neq 0 \f$ with \f$ \sum_j \alpha_j q(y_j) = 0 \f$ for all polynomials \f$ q \f$ of degree below `order`, for
  /// different centres \f$ y_j \f$ in \f$ R^3 \f$ that no such polynomial but zero vanishes on.
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

  Both must be finite at \f$ r = 0 \f$. There `value` is \f$ \phi(0) \f$; `derivative_over_radius` is multiplied by the zero
  vector, so that any finite number serves where the limit is infinite.

  `T` is `double`, `Eigen::ArrayXd` or an array of fixed size, `Eigen::Array<double, n, 1>`, whose elements are computed one
  by one: the body uses arithmetic operators and functions such as `sqrt` found by argument-dependent lookup (after
  `using std::sqrt;`), and does not branch on the values. `value` and `derivative_over_radius` are no aliases of
  `squared_radius` and have its size.
  */
  template <class T>
  void operator()(const T& squared_radius, T& value, T& derivative_over_radius) const;

  /// @}
};
