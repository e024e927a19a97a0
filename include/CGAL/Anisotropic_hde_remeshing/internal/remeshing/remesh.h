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
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remesher.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/feature_curves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/orient_normals.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The second of the paper's two steps, on the copy of the mesh. `diagonal` is in the unit of the caller, `unit` is that of the
// copy. Of the caller's types the template has the embedding only. So calls with other meshes and functions share what is
// compiled.
template <typename ConcurrencyTag, typename Embedding, typename Intersections>
void remesh(Working_mesh<typename Embedding::Vertex_data>& mesh, const Embedding& embedding, const Surface_function& function,
            const Input_surface& input, Intersections& intersections, const double diagonal, const double unit,
            const Visitor_reference visitor, Interruption& interruption, const Remeshing_parameters& parameters,
            Target_length target, Remeshing_result& result)
{
  typedef Surface_projection<Surface_function> Projection;
  typedef Remesher<ConcurrencyTag, Embedding, Projection, Intersections> Remesher;
  static constexpr double exact_distance = 1e-9;           // of the diagonal; one more step of Newton's method squares it
  static constexpr double largest_crease_deviation = 5e-5; // of the diagonal: of an edge on a curve from its input polyline

  Real_timer timer;
  timer.start();
  visitor.stage_started(Stage::PROJECTION);
  if (parameters.number_of_iterations > 0)
    reorder_in_space<ConcurrencyTag>(mesh, interruption);
  Curve_network curves(mesh);
  mesh.mark_creases();
  if (has_creases(mesh, function))
    curves.set_largest_deviation(largest_crease_deviation * diagonal / unit);
  result.number_of_regions = number_of_pieces(function);
  result.curves_before = feature_curves(mesh, unit);
  Projection projection(function, input, exact_distance * diagonal / unit, unit);
  Remesher remesher(mesh, embedding, projection, curves, intersections, parameters, diagonal / unit, visitor, interruption,
                    result);
  remesher.project_input();
  const std::vector<double> signs = orientations(mesh, number_of_pieces(function));
  for (std::size_t i = 0; i < signs.size(); ++i)
    projection.set_orientation(Region(i), signs[i]);
  orient_normals(mesh, signs);
  result.projection_seconds = timer.time();
  if (interruption.is_requested())
    return;

  timer.reset();
  visitor.stage_started(Stage::REMESHING);
  const double unit_of_lengths = embedding.unit_of_lengths(unit);
  if (target.is_length_given())
    result.binding_target = Target::EDGE_LENGTH;
  if (parameters.error > 0)
    remesher.start_from_error(target);
  remesher.update(target);
  if (is_metric<Embedding>)
    remesher.update(target);
  check_number_of_faces(target, unit_of_lengths);
  remesher.run(target);
  result.target_edge_length *= unit_of_lengths;
  result.approximation_error *= unit;
  result.projections = projection.counters();
  result.curves_after = feature_curves(mesh, unit);
  result.remeshing_seconds = timer.time();
}

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // cmake/Shared_compilation.cmake: compiled once for the package's own programs
#  define CGAL_AHR_REMESH(ConcurrencyTag, Embedding, Intersections)                                                            \
    template void remesh<ConcurrencyTag>(Working_mesh<Embedding::Vertex_data>&, const Embedding&, const Surface_function&,     \
                                         const Input_surface&, Intersections&, double, double, Visitor_reference,              \
                                         Interruption&, const Remeshing_parameters&, Target_length, Remeshing_result&)
typedef Mesh_intersections<Working_mesh<Normal_embedding::Vertex_data>> Intersections_with_normals;
extern CGAL_AHR_REMESH(Sequential_tag, Normal_embedding, No_intersections);
extern CGAL_AHR_REMESH(Sequential_tag, Curvature_metric, No_intersections);
#  ifdef CGAL_LINKED_WITH_TBB
extern CGAL_AHR_REMESH(Parallel_tag, Normal_embedding, No_intersections);
extern CGAL_AHR_REMESH(Parallel_tag, Curvature_metric, No_intersections);
#  endif
extern CGAL_AHR_REMESH(Parallel_if_available_tag, Normal_embedding, Intersections_with_normals);
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_H
