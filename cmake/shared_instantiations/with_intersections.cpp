// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the headers declare as compiled elsewhere, where CGAL_AHR_WITH_SHARED_INSTANTIATIONS is defined: the remesher
// that tests for intersections.

#include <CGAL/anisotropic_hde_remeshing.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

CGAL_AHR_REMESH(Parallel_if_available_tag, Normal_embedding, Intersections_with_normals);
CGAL_AHR_REMESH_BY_ERROR(Parallel_if_available_tag, Intersections_with_normals);

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL
