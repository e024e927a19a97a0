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

The concept `PiecewiseImplicitFunction` describes a surface with sharp edges by several smooth functions, its pieces. Each face
of the mesh belongs to one piece. The `face_patch_map` of the mesh tells the number of this piece. The part of the surface about
the face is the zero set of this piece. The sharp edges are where the zero sets of two neighbouring pieces meet. The corners are
where three or more of them meet.

<b>Beyond the faces.</b> A piece is smooth at its own faces and for some edge lengths beyond them. The edges between two regions
are only near the curve in which the two pieces meet. The remeshing looks for that curve from these edges, so it evaluates each
piece on the far side, too.

<b>Orientation.</b> All pieces are negative inside, so the gradient of a piece points to the side that its faces look to. (The
remeshing alone also takes the opposite sign, of each piece by itself.)

<b>Thread safety.</b> All members, and those of the pieces, may be called from several threads at once on one object, unless the
algorithm runs with `CGAL::Sequential_tag`. They return the same result for the same argument at every call.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Piecewise_rbf_implicit_function}
\cgalHasModelsEnd

\sa `CGAL::Anisotropic_hde_remeshing::detect_surface_regions()`
*/
class PiecewiseImplicitFunction
{
public:
  /// \name Types
  /// @{

  /// the function of a piece, a model of `ImplicitFunctionWithGradient`. All pieces have this one type. If they differ in kind,
  /// the type tells the kinds apart inside.
  typedef unspecified_type Piece;

  /// @}

  /// \name Operations
  /// @{

  /// the number of pieces. The values of the `face_patch_map` are less than this number.
  std::size_t number_of_pieces() const;

  /// piece `i`, where `i` is less than `number_of_pieces()`. The reference is valid as long as the object.
  const Piece& piece(std::size_t i) const;

  /// @}
};
