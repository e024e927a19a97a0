// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_SCHEME_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_SCHEME_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingRef
///
/// the order of the operations in `CGAL::anisotropic_hde_remeshing()`
enum class Remeshing_scheme
{
  /// An iteration splits edges from 4/3 and contracts edges below 4/5 of the target length. Then it splits the longest or
  /// contracts the shortest edges until the number of faces is right. This number is alternately a little less and a little
  /// more than asked. It is two fifths more once, if the mesh begins with about the right number. Next, the iteration flips
  /// edges towards valence six, or, in the last iterations, towards larger angles. In the end it smooths all vertices. This
  /// scheme measures best and is the default.
  DEFAULT,
  /// Algorithm 2 of the paper. An iteration first repeats three operations until nothing is contracted: it contracts edges
  /// below half of the target length, smooths the 30% of the vertices with the smallest 6D angles, and flips edges. Then it
  /// splits edges above 3/2 of the target length, flips, smooths and flips. If a number of faces is asked for, the length
  /// follows from it. Contracting the shortest edges or splitting the longest ones makes up for the rest.
  PAPER
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_SCHEME_H
