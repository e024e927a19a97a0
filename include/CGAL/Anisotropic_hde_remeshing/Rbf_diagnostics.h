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

/// \ingroup PkgAnisotropicHdeRemeshingImplicit
///
/// what `CGAL::Rbf_implicit_function` tells of its construction
struct Rbf_diagnostics
{
  /// \name Input
  /// @{
  std::size_t number_of_points = 0;                ///< points of the surface, without the isolated and duplicate ones below
  std::size_t number_of_points_on_facets = 0;      ///< those among them that are no vertices, but lie on facets
  std::size_t number_of_replaced_vertices = 0;     ///< those that points on their facets replace
  std::size_t number_of_points_on_edges = 0;       ///< on sharp edges that were detected: no off-surface points
  std::size_t number_of_isolated_vertices = 0;     ///< vertices without a face, ignored
  std::size_t number_of_duplicate_points = 0;      ///< points equal to another one, ignored
  std::size_t number_of_outliers = 0;              ///< points that all their neighbours contradict, ignored
  std::size_t number_of_wrong_normals = 0;         ///< normals that all neighbours contradict, turned or dropped
  std::size_t number_of_points_without_normal = 0; ///< given ones with a zero or cancelled normal: no off-surface points
  std::size_t number_of_shortened_offsets = 0;     ///< off-surface points set nearer or left out, as another sheet is close
  std::size_t number_of_holes = 0;                 ///< holes wider than six spacings, closed; 0 with `close_holes(false)`
  /// the median of the mean distances from a point to its six nearest neighbours, or to those at its edges, in the unit of the
  /// coordinates
  double median_spacing = 0;
  /// about the area that the points are on: the sum of the squares of these distances, each of at most ten times the median
  double area = 0;
  double noise =
      0; ///< the standard deviation of the noise of the points, `smoothing` or its estimate, in the unit of the coordinates
  /// @}

  /// \name Patches
  /// @{
  std::size_t number_of_patches = 0;            ///< of the function
  double mean_centres = 0;                      ///< mean number of on- and off-surface points of a patch
  std::size_t max_centres = 0;                  ///< this number of the largest patch
  std::size_t patches_with_sparse_cholesky = 0; ///< the sparse systems of a kernel of compact support
  std::size_t patches_with_ridge = 0;           ///< solved with a small ridge on the diagonal
  std::size_t patches_with_lu = 0;              ///< solved by LU after Cholesky had failed
  std::size_t patches_repaired = 0;             ///< patches that failed a check and were solved once more
  std::size_t patches_on_fallback =
      0;                              ///< patches that were not solved or not repaired: the distance to the input replaces them
  std::size_t patches_off_facets = 0; ///< those among them that stayed too far from a facet
  std::size_t number_of_refined_places = 0; ///< points on facets that were added as the surface was too far there
  std::size_t number_of_failed_checks = 0;  ///< wrong signs and gradients that remain in patches not on fallback
  double worst_residual = 0;                ///< of the systems' solutions, relative to the largest datum
  double worst_value_residual = 0;          ///< largest difference to a datum, in the unit of the coordinates
  double worst_condition = 1;               ///< of the systems, estimated from below by the pivots
  /// @}

  /// \name Cost
  /// @{
  std::size_t memory_bytes = 0;  ///< of the function
  double input_seconds = 0;      ///< wall time of reading points and normals
  double partition_seconds = 0;  ///< wall time of building the tree of patches
  double constraint_seconds = 0; ///< wall time of choosing the off-surface points
  double solve_seconds = 0;      ///< wall time of solving and checking the patches
  /// @}
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_RBF_DIAGNOSTICS_H
