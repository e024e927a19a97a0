// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remeshing_report.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_embedding.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The second of the paper's two steps, on the copy of the mesh and in its unit. Of the caller's types the template has the
// embedding only. So calls with other meshes and functions share what is compiled. Throws Too_many_faces. It is in remesh_impl.h,
// which is not needed where it is compiled already.
template <typename ConcurrencyTag, typename Embedding>
Remeshing_report remesh(Working_mesh<typename Embedding::Vertex_data>& mesh, const Embedding& embedding,
                        const Surface_function& function, const Input_surface& input,
                        Mesh_intersections<Working_mesh<typename Embedding::Vertex_data>>& intersections,
                        const Remeshing_parameters& parameters, Visitor_reference visitor);

// whether the function above is there for an embedding
template <typename Embedding>
constexpr bool has_remesh =
#if defined(CGAL_AHR_WITH_SHARED_INSTANTIATIONS) && !defined(CGAL_AHR_WITH_OTHER_TYPES)
    std::is_same<Embedding, Normal_embedding>::value || std::is_same<Embedding, Metric_embedding<Curvature_metric>>::value;
#else
    true;
#endif

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // cmake/Shared_compilation.cmake: compiled once for the package's own programs
#  define CGAL_AHR_REMESH(ConcurrencyTag, Embedding)                                                                           \
    template Remeshing_report remesh<ConcurrencyTag>(                                                                          \
        Working_mesh<Embedding::Vertex_data>&, const Embedding&, const Surface_function&, const Input_surface&,                \
        Mesh_intersections<Working_mesh<Embedding::Vertex_data>>&, const Remeshing_parameters&, Visitor_reference)
typedef Metric_embedding<Curvature_metric> Curvature_embedding;
extern CGAL_AHR_REMESH(Sequential_tag, Normal_embedding);
extern CGAL_AHR_REMESH(Sequential_tag, Curvature_embedding);
#  ifdef CGAL_LINKED_WITH_TBB
extern CGAL_AHR_REMESH(Parallel_tag, Normal_embedding);
extern CGAL_AHR_REMESH(Parallel_tag, Curvature_embedding);
#  endif
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#if !defined(CGAL_AHR_WITH_SHARED_INSTANTIATIONS) || defined(CGAL_AHR_WITH_OTHER_TYPES)
#  include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_impl.h>
#endif

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_H
