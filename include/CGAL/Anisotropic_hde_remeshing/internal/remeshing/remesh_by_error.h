// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remeshing_report.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Remeshes the copy of the mesh by measured error. The facets of the input are the surface. It is in remesh_by_error_impl.h, which is
// not needed where it is compiled already.
template <typename ConcurrencyTag>
Remeshing_report remesh_by_error(Working_mesh<Normal_embedding::Vertex_data>& mesh, bool is_piecewise,
                                 const Input_surface& input,
                                 Mesh_intersections<Working_mesh<Normal_embedding::Vertex_data>>& intersections,
                                 const Remeshing_parameters& parameters, Visitor_reference visitor);

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // as those of remesh.h
#  define CGAL_AHR_REMESH_BY_ERROR(ConcurrencyTag)                                                                             \
    template Remeshing_report remesh_by_error<ConcurrencyTag>(                                                                 \
        Working_mesh<Normal_embedding::Vertex_data>&, bool, const Input_surface&,                                              \
        Mesh_intersections<Working_mesh<Normal_embedding::Vertex_data>>&, const Remeshing_parameters&, Visitor_reference)
extern CGAL_AHR_REMESH_BY_ERROR(Sequential_tag);
#  ifdef CGAL_LINKED_WITH_TBB
extern CGAL_AHR_REMESH_BY_ERROR(Parallel_tag);
#  endif
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#ifndef CGAL_AHR_WITH_SHARED_INSTANTIATIONS
#  include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_by_error_impl.h>
#endif

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_H
