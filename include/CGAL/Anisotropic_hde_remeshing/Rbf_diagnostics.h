// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_RBF_DIAGNOSTICS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_RBF_DIAGNOSTICS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// what `CGAL::Rbf_implicit_function` tells of its construction
struct Rbf_diagnostics
{
  std::size_t number_of_points = 0;             ///< of the surface, those below left out
  std::size_t number_of_isolated_vertices = 0;  ///< vertices without a face, ignored
  std::size_t number_of_duplicate_points = 0;   ///< points equal to another one, ignored
  std::size_t number_of_shortened_offsets = 0;  ///< off-surface points set nearer or left out: another sheet is close
  std::size_t number_of_patches = 0;
  double mean_centres = 0;                      ///< on- and off-surface points of a patch, in the mean
  std::size_t max_centres = 0;                  ///< the same, of the largest patch
  double worst_residual = 0;                    ///< of the accepted solutions, relative to the largest datum
  std::size_t patches_with_ridge = 0;           ///< solved with a small ridge on the diagonal
  std::size_t patches_with_lu = 0;              ///< solved by LU after Cholesky had failed
  std::size_t patches_on_fallback = 0;          ///< not solved: blended tangent planes serve there
  std::size_t memory_bytes = 0;                 ///< of the patches
  double constraint_seconds = 0;                ///< wall time of choosing the off-surface points
  double partition_seconds = 0;                 ///< wall time of building the tree of patches
  double solve_seconds = 0;                     ///< wall time of solving them
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_RBF_DIAGNOSTICS_H
