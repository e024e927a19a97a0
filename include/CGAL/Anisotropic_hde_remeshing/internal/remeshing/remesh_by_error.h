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
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Error_remesher.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remeshing_report.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/feature_curves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Operation_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Remeshes the copy of the mesh by measured error. The facets of the input are the surface.
template <typename ConcurrencyTag, typename Intersections>
Remeshing_report remesh_by_error(Working_mesh<Normal_embedding::Vertex_data>& mesh, const bool is_piecewise,
                                 const Input_surface& input, Intersections& intersections,
                                 const Remeshing_parameters& parameters, const Visitor_reference visitor)
{
  typedef Working_mesh<Normal_embedding::Vertex_data> Mesh;
  typedef Operation_guard<Mesh, Surface_function, Intersections> Guard;
  Real_timer timer;
  timer.start();
  visitor.stage_started(Stage::PROJECTION);
  Remeshing_report report;
  const Curve_network curves = curve_network(mesh, is_piecewise, input.diagonal());
  report.curves_before = feature_curves(mesh);
  const Surface_function no_function;
  const Guard guard(mesh, no_function, intersections);
  report.projection_seconds = timer.time();
  if (visitor.interruption().is_requested())
    return report;

  timer.reset();
  visitor.stage_started(Stage::REMESHING);
  Error_remesher<ConcurrencyTag, Mesh, Guard> remesher(mesh, curves, guard, input, parameters, visitor);
  remesher();
  report.number_of_iterations = remesher.number_of_rounds();
  report.operations = remesher.statistics();
  report.curves_after = feature_curves(mesh);
  if (!visitor.interruption().is_requested())
    report.binding_target = what_binds(mesh, parameters.target.number_of_faces());
  report.remeshing_seconds = timer.time();
  return report;
}

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // as those of remesh.h
#  define CGAL_AHR_REMESH_BY_ERROR(ConcurrencyTag, Intersections)                                                              \
    template Remeshing_report remesh_by_error<ConcurrencyTag>(Working_mesh<Normal_embedding::Vertex_data>&, bool,              \
                                                              const Input_surface&, Intersections&,                            \
                                                              const Remeshing_parameters&, Visitor_reference)
extern CGAL_AHR_REMESH_BY_ERROR(Sequential_tag, No_intersections);
#  ifdef CGAL_LINKED_WITH_TBB
extern CGAL_AHR_REMESH_BY_ERROR(Parallel_tag, No_intersections);
#  endif
extern CGAL_AHR_REMESH_BY_ERROR(Parallel_if_available_tag, Intersections_with_normals);
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_H
