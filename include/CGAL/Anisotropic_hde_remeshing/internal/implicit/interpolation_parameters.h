// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Smoothing.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The parameters of the interpolant, checked. Lengths are in units of the local spacing, except for the
// absolute offset and the noise.
struct Interpolation_parameters
{
  std::size_t number_of_patches = 0; // 0: patches_of() the number of points
  double patch_overlap = 2.4;
  double patch_blending = 0.6;
  double relative_offset = 0.05;
  double absolute_offset = 0; // 0: the relative one
  bool offsets_on_both_sides = false;
  double noise = 0;              // standard deviation of that of the points
  bool estimates_noise = false;  // whether it is to be found out
  bool detects_outliers = false; // whether points that their neighbours contradict are left out
  bool closes_holes = true;      // whether the function is bounded where data are missing
  bool finds_edges = false;      // whether vertices on sharp edges have no normal
  bool uses_facets = false;      // whether it interpolates points on facets, too, and is checked there
  bool keeps_vertices = false;   // whether it interpolates vertices of adapted meshes, too

  // Noisy facets are where no surface is, and turn where it has no edge.
  void mistrust_facets() { finds_edges = uses_facets = false; }

  // 25 points a patch measured best, in the time to build and to evaluate
  static std::size_t patches_of(const std::size_t number_of_points) { return (number_of_points + 24) / 25; }
};

// the named parameters of the interpolant, checked
template <typename NamedParameters>
Interpolation_parameters interpolation_parameters(const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  Interpolation_parameters result;
  if constexpr (!is_default_parameter<NamedParameters, internal_np::number_of_patches_t>::value)
    result.number_of_patches = checked_count("number_of_patches", get_parameter(np, internal_np::number_of_patches));
  if constexpr (!is_default_parameter<NamedParameters, internal_np::patch_overlap_t>::value)
    result.patch_overlap =
        checked_not_negative("patch_overlap", CGAL::to_double(get_parameter(np, internal_np::patch_overlap)));
  if constexpr (!is_default_parameter<NamedParameters, internal_np::offset_distance_t>::value)
    result.absolute_offset =
        checked_positive("offset_distance", CGAL::to_double(get_parameter(np, internal_np::offset_distance)));
  if constexpr (!is_default_parameter<NamedParameters, internal_np::relative_offset_distance_t>::value)
    result.relative_offset =
        checked_positive("relative_offset_distance", CGAL::to_double(get_parameter(np, internal_np::relative_offset_distance)));
  if constexpr (!is_default_parameter<NamedParameters, internal_np::two_sided_offsets_t>::value)
    result.offsets_on_both_sides = get_parameter(np, internal_np::two_sided_offsets);
  if constexpr (!is_default_parameter<NamedParameters, internal_np::smoothing_t>::value)
  {
    const Smoothing smoothing(get_parameter(np, internal_np::smoothing));
    result.estimates_noise = smoothing.is_automatic();
    if (!smoothing.is_automatic())
      result.noise = checked_not_negative("smoothing", smoothing.length());
  }
  result.uses_facets = true;
  result.finds_edges = is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value;
  result.keeps_vertices = !result.finds_edges; // as the caller knows the surface there
  if constexpr (!is_default_parameter<NamedParameters, internal_np::detect_edges_t>::value)
    result.finds_edges = result.finds_edges && get_parameter(np, internal_np::detect_edges);
  if constexpr (!is_default_parameter<NamedParameters, internal_np::detect_outliers_t>::value)
    result.detects_outliers = get_parameter(np, internal_np::detect_outliers);
  if constexpr (!is_default_parameter<NamedParameters, internal_np::close_holes_t>::value)
    result.closes_holes = get_parameter(np, internal_np::close_holes);
  if constexpr (!is_default_parameter<NamedParameters, internal_np::points_on_facets_t>::value)
    result.uses_facets = result.uses_facets && get_parameter(np, internal_np::points_on_facets);
  if (result.noise > 0)
    result.mistrust_facets();
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_PARAMETERS_H
