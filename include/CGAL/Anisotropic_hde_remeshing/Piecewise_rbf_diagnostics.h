// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_PIECEWISE_RBF_DIAGNOSTICS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_PIECEWISE_RBF_DIAGNOSTICS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingSharp
///
/// what a piece of `CGAL::Piecewise_rbf_implicit_function` is
enum class Piece_kind
{
  FIELD,         ///< an interpolant by radial basis functions
  PLANE,         ///< the signed distance to a plane
  CLOSEST_POINT, ///< the signed distance to the facets of the region, continued along their tangent planes
  NONE           ///< nothing: the value 1 with the gradient 0 everywhere, as all faces of the region are degenerate
};

/// \ingroup PkgAnisotropicHdeRemeshingSharp
///
/// what `CGAL::Piecewise_rbf_implicit_function` tells of its construction. The numbers of patches and points are sums over the
/// pieces of the kind `Piece_kind::FIELD`. The worst values are the worst of these pieces. See `Rbf_diagnostics`.
struct Piecewise_rbf_diagnostics
{
  /// \name Pieces
  /// @{
  std::size_t number_of_regions = 0;               ///< the sum of the four below
  std::size_t number_of_fields = 0;                ///< of the kind `Piece_kind::FIELD`
  std::size_t number_of_planes = 0;                ///< of the kind `Piece_kind::PLANE`
  std::size_t number_of_closest_point_regions = 0; ///< of the kind `Piece_kind::CLOSEST_POINT`
  std::size_t number_of_regions_without_area = 0;  ///< of the kind `Piece_kind::NONE`
  /// @}

  /// \name Fields
  /// @{
  std::size_t number_of_points = 0;            ///< of all fields; a vertex on a crease is a point of each region there
  std::size_t number_of_points_on_facets = 0;  ///< those among them that are no vertices, but lie on facets
  std::size_t number_of_replaced_vertices = 0; ///< those that points on their facets replace
  std::size_t number_of_points_on_edges = 0;   ///< on sharp edges inside of the regions: no off-surface points
  double noise =
      0; ///< the standard deviation of the noise of the points, `smoothing` or its estimate, in the unit of the coordinates
  std::size_t number_of_patches = 0; ///< of the interpolants
  std::size_t patches_repaired = 0;  ///< patches that failed a check and were solved once more
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
  std::size_t memory_bytes = 0; ///< of the function
  double seconds = 0;           ///< wall time of the construction
  /// @}
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_PIECEWISE_RBF_DIAGNOSTICS_H
