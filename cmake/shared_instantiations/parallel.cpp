// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the headers declare as compiled elsewhere, where CGAL_AHR_WITH_SHARED_INSTANTIATIONS is defined: the parallel
// remesher.

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field_impl.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/build_region_functions_impl.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_by_error_impl.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_impl.h>
#include <CGAL/anisotropic_hde_remeshing.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
CGAL_AHR_COMPLETE_SAMPLE(Parallel_tag);
CGAL_AHR_FIELD(, Polyharmonic_rbf, Parallel_tag);
CGAL_AHR_BUILD_REGION_FUNCTIONS(Parallel_tag, Polyharmonic_rbf);
CGAL_AHR_REMESH(Parallel_tag, Normal_embedding);
CGAL_AHR_REMESH(Parallel_tag, Curvature_embedding);
CGAL_AHR_REMESH_BY_ERROR(Parallel_tag);
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL
