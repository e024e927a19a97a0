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

The concept `ImplicitFunctionWithGradient` describes a function \f$ f : R^3 \rightarrow R \f$ with its gradient. The surface
is the zero set of \f$ f \f$.

<b>Sign and orientation.</b> \f$ f \f$ is negative inside and positive outside, so its gradient points outward on the surface.
For a surface with boundary, outside is the side that the faces of the mesh look to. (The remeshing alone also takes the
opposite sign. It compares the gradient with the orientation of the mesh and turns over the normals of all vertices or of none.)

<b>Units.</b> The gradient is the derivative of the value by the coordinates, in the same unit:
\f$ f(x + h) = f(x) + \nabla f(x) \cdot h + o(|h|) \f$. The value need not be a distance, and the gradient need not have length
one. The remeshing uses \f$ f / |\nabla f| \f$ as distance to the surface and \f$ \nabla f / |\nabla f| \f$ as normal. These do
not change if \f$ f \f$ is multiplied by a positive number.

<b>Smoothness.</b> In the neighbourhood of the surface that contains the mesh, \f$ f \f$ is continuously differentiable and its
gradient does not vanish. The remeshing takes the closest point of the input mesh with its interpolated normal where a value is
not finite, where the gradient vanishes, or where no zero is found near a point. It counts these points in
`CGAL::Anisotropic_hde_remeshing::Projection_counters`.

<b>Thread safety.</b> All members below may be called from several threads at once on one object, unless the algorithm runs
with `CGAL::Sequential_tag`. They return the same result for the same point at every call.

<b>Copies.</b> `CGAL::anisotropic_hde_remeshing()` keeps a reference to the function during the call and makes no copy. Other
packages store it by value: copying should be cheap, for example by sharing constant data.

\cgalRefines{ImplicitFunction}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Rbf_implicit_function}
\cgalHasModels{CGAL::Piecewise_rbf_implicit_function::Piece}
\cgalHasModelsEnd

\sa `CGAL::anisotropic_hde_remeshing()`
*/
class ImplicitFunctionWithGradient
{
public:
  /// \name Types
  /// @{

  /// number type, convertible to `double` by `CGAL::to_double()`
  typedef unspecified_type FT;

  /// point type, constructible from three numbers of type `double`
  typedef unspecified_type Point_3;

  /// the same type, as the concept `ImplicitFunction` calls it. `CGAL::anisotropic_hde_remeshing()` does not use it.
  typedef Point_3 Point;

  /// vector type with members `x()`, `y()` and `z()`, convertible to `double` by `CGAL::to_double()`
  typedef unspecified_type Vector_3;

  /// sphere type; needed only with `bounding_sphere()`
  typedef unspecified_type Sphere_3;

  /// @}

  /// \name Operations
  /// @{

  /// the value \f$ f(p) \f$: negative inside, zero on the surface, positive outside
  FT operator()(Point_3 p) const;

  /// the gradient \f$ \nabla f(p) \f$, outward on the surface, of any positive length
  Vector_3 gradient(Point_3 p) const;

  /// @}

  /// \name Optional Operations
  /// @{

  /// `operator()(p)` and `gradient(p)` in one call. If a model has this member, the remeshing calls no other one.
  std::pair<FT, Vector_3> value_and_gradient(Point_3 p) const;

  /// a sphere that contains the surface, or the part of it that is of interest. `CGAL::anisotropic_hde_remeshing()` does not
  /// use it; mesh generators of CGAL do.
  Sphere_3 bounding_sphere() const;

  /// @}
};
