// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/Named_parameters.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Marks named parameters: without smoothing, facets that are long and exact are the function of their region. The remeshing of a mesh
// on its own surface asks for it, and tells whether the whole mesh has such facets: then those of each region are, even if they are
// short. By itself, the function of a cylinder of two rows of vertices is that of the cylinder.
enum Keeps_long_facets
{
};

template <typename T, typename Tag, typename Base>
auto keep_long_facets(const Named_function_parameters<T, Tag, Base>& np, const bool has_whole_mesh)
{
  return named_parameters(
      Named_function_parameters<bool, Keeps_long_facets, Named_function_parameters<T, Tag, Base>>(has_whole_mesh, np));
}

template <typename NamedParameters>
constexpr bool keeps_long_facets = !parameters::is_default_parameter<NamedParameters, Keeps_long_facets>::value;

// how the functions of regions are built
template <typename RadialFunction>
struct Region_parameters
{
  Interpolation_parameters interpolation;
  RadialFunction function;
  bool keeps_long_facets = false;
  bool has_mesh_long_facets = false; // then those of each region are, too
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_PARAMETERS_H
