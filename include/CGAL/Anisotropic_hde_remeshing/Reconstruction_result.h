// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_RECONSTRUCTION_RESULT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_RECONSTRUCTION_RESULT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingSchemes
///
/// what `CGAL::rbf_surface_reconstruction()` found and did, and with which sizes. Lengths are in the unit of the points.
struct Reconstruction_result
{
  /// \name Points
  /// @{
  std::size_t number_of_points = 0;        ///< without duplicates and outliers
  std::size_t number_of_outliers = 0;      ///< points that were left out; 0 without `detect_outliers`
  std::size_t number_of_wrong_normals = 0; ///< normals that were turned or dropped; 0 without `detect_outliers`
  std::size_t number_of_closed_holes = 0;  ///< where points are missing over more than six spacings
  double noise = 0;                        ///< `smoothing`, or the noise that was estimated
  double spacing = 0; ///< the median of the distances between neighbours, `Rbf_diagnostics::median_spacing`
  /// @}

  /// \name Surface
  /// @{
  std::size_t number_of_vertices = 0;   ///< of the mesh
  std::size_t number_of_faces = 0;      ///< of the mesh
  std::size_t number_of_components = 0; ///< of the mesh
  /// places near points where the zero set is, but the mesh has no triangle: parts that are too small for `facet_size`
  std::size_t number_of_missed_places = 0;
  double facet_size = 0;      ///< the one given, or the default
  double facet_distance = 0;  ///< the one given, or the default
  bool is_remeshed = false;   ///< whether a size of the result was asked for
  Remeshing_result remeshing; ///< the result of the remeshing
  /// @}

  /// \name Cost
  /// @{
  std::size_t number_of_evaluations = 0; ///< of the function by the surface mesher
  double function_seconds = 0;           ///< wall time of building the function
  double meshing_seconds = 0;            ///< wall time of the surface mesher
  double remeshing_seconds = 0;          ///< wall time of `CGAL::anisotropic_hde_remeshing()`
  /// @}
};

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_RECONSTRUCTION_RESULT_H
