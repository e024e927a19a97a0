// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>
#include <CGAL/Radial_basis_functions.h>

#include <CGAL/tags.h>

#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Builds the functions of all regions. It has none of the caller's types but the radial function. It is in
// build_region_functions_impl.h, which is not needed where it is compiled already.
template <typename ConcurrencyTag, typename RadialFunction>
std::vector<Region_function<Rbf_field<RadialFunction, ConcurrencyTag>>>
build_region_functions(const std::vector<Region_mesh>& regions, const Region_parameters<RadialFunction>& parameters,
                       Interruption& interruption);

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // cmake/Shared_compilation.cmake: compiled once for the package's own programs
#  define CGAL_AHR_BUILD_REGION_FUNCTIONS(ConcurrencyTag, RadialFunction)                                                      \
    template std::vector<Region_function<Rbf_field<RadialFunction, ConcurrencyTag>>>                                           \
    build_region_functions<ConcurrencyTag, RadialFunction>(const std::vector<Region_mesh>&,                                    \
                                                           const Region_parameters<RadialFunction>&, Interruption&)
extern CGAL_AHR_BUILD_REGION_FUNCTIONS(Sequential_tag, Polyharmonic_rbf);
#  ifdef CGAL_LINKED_WITH_TBB
extern CGAL_AHR_BUILD_REGION_FUNCTIONS(Parallel_tag, Polyharmonic_rbf);
#  endif
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#if !defined(CGAL_AHR_WITH_SHARED_INSTANTIATIONS) || defined(CGAL_AHR_WITH_OTHER_TYPES)
#  include <CGAL/Anisotropic_hde_remeshing/internal/regions/build_region_functions_impl.h>
#endif

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_BUILD_REGION_FUNCTIONS_H
