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

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// the order of the operations in `CGAL::anisotropic_hde_remeshing()`. By measured error the facets of the input are the surface;
/// by embedding it is the zero set of a function.
enum class Remeshing_scheme
{
  /// `MEASURED_ERROR` in the following cases, and otherwise `EMBEDDING`. In the first three, neither an embedding, nor a length,
  /// a function, or a parameter of one of these is given.
  /// - An error is asked for.
  /// - A number of faces is asked for that is at most three quarters of that of the input.
  /// - Any number is asked for, and the facets are long and exact, as in a file of a CAD program: more than a quarter of the area
  ///   is in faces whose longest edge is more than eight times the altitude over it, or in facets of several faces in one plane
  ///   that are long and turn by much, as those of a cylinder of few sides.
  /// - An embedding is asked for that keeps such facets, and it does not meet the number of faces.
  DEFAULT,
  /// Algorithm 2 of the paper. An iteration first repeats three operations until nothing is contracted: it contracts edges
  /// below half of the target length, smooths the 30% of the vertices with the smallest 6D angles, and flips edges. Then it
  /// splits edges above 3/2 of the target length, flips, smooths and flips. If a number of faces is asked for, the length
  /// follows from it. Contracting the shortest edges or splitting the longest ones makes up for the rest.
  PAPER,
  /// The mesh becomes uniform and isotropic in the embedding, with its vertices on the surface.
  ///
  /// An iteration splits edges from 4/3 and contracts edges below 4/5 of the target length. Then it splits the longest or
  /// contracts the shortest edges until the number of faces is right. This number is alternately a little less and a little
  /// more than asked. It is two fifths more once, if the mesh begins with about the right number. Next, the iteration flips
  /// edges towards valence six, or, in the last iterations, towards larger angles. In the end it smooths all vertices.
  EMBEDDING,
  /// The input is the surface itself. If it has fewer faces than asked for, these are split first, at their longest edges.
  ///
  /// Samples of the input belong to the nearest face of the mesh, so the distance of each face to its part of the input is known.
  /// First, edges are contracted, those that lose least first. Quadrics add up the loss. Then iterations follow. Each iteration
  /// exchanges vertices: it does a contraction that costs little together with a split that gains much. It flips edges where that
  /// makes the distance less. It moves the vertices to where the distance is least, on the surface or off it. Where faces were
  /// split there are no iterations unless they are asked for.
  ///
  /// Distances count by their third power, so that the largest one becomes small, too. Long triangles have a price. Vertices of
  /// curves stay on them. With an error, edges are contracted as long as it is kept, and faces that exceed it in the end are split.
  /// If neither an error nor a number of faces is asked for, or if an embedding is, this is `EMBEDDING`.
  MEASURED_ERROR
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_REMESHING_SCHEME_H
