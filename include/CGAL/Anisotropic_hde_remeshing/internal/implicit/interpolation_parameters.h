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

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patchwise_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

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
    result.smoothing = checked_not_negative("smoothing", CGAL::to_double(get_parameter(np, internal_np::smoothing)));
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INTERPOLATION_PARAMETERS_H
