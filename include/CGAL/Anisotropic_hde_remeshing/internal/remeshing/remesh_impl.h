// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_IMPL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_IMPL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remesher.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remeshing_report.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/feature_curves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/fix_apexes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/orient_normals.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Allowed_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the curves of the mesh, and what the caller allows at them; on creases they bound how far an edge may be from the input polyline
template <typename Mesh>
Curve_network curve_network(Mesh& mesh, const bool is_piecewise, const double diagonal, const Allowed_operations& allowed)
{
  static constexpr double largest_crease_deviation = 5e-5; // of the diagonal
  Curve_network curves(mesh);
  curves.set_allowed(allowed.collapse_on_curves, allowed.smooth_on_curves);
  mesh.mark_creases();
  if (has_creases(mesh, is_piecewise))
    curves.set_largest_deviation(largest_crease_deviation * diagonal);
  return curves;
}

// makes the normals look the way of the faces, region by region
template <typename Projection, typename Mesh>
void orient(Projection& projection, Mesh& mesh)
{
  const std::vector<double> signs = orientations(mesh, number_of_pieces(projection.function()));
  for (std::size_t i = 0; i < signs.size(); ++i)
    projection.set_orientation(Region(i), signs[i]);
  orient_normals(mesh, signs);
}

// The length in space of the edges of the mesh while it is remeshed, in the mean and as far as it is known: as it is, or longer. A
// number of faces is one of equilateral triangles. A length in the embedding is no shorter than in space.
template <typename ConcurrencyTag, typename Mesh>
double expected_length(const Mesh& mesh, const Remeshing_parameters& parameters, const double diagonal)
{
  static constexpr double largest_share = 0.1; // of the diagonal, as a metric has lengths of its own
  const auto area_of_face = [&](const std::size_t i)
  {
    const Face_index f(static_cast<Face_index::size_type>(i));
    return mesh.is_removed(f) ? 0. : face_normal(mesh.halfedge(f), mesh).norm() / 2;
  };
  const double equilateral_area = 0.25 * std::sqrt(3.), area = parallel_sum<ConcurrencyTag>(face_capacity(mesh), area_of_face);
  const auto length = [&](const double number_of_faces) { return std::sqrt(area / (equilateral_area * number_of_faces)); };
  const double number_now = double(mesh.number_of_faces());
  if (parameters.error > 0)
    return length(number_now);
  return parameters.target.is_length_given()
             ? (std::max)(length(number_now), (std::min)(parameters.target.length(), largest_share * diagonal))
             : length((std::min)(number_now, parameters.target.number_of_faces()));
}

// The second of the paper's two steps, on the copy of the mesh and in its unit. Of the caller's types the template has the
// embedding only. So calls with other meshes and functions share what is compiled. Throws Too_many_faces.
template <typename ConcurrencyTag, typename Embedding>
Remeshing_report remesh(Working_mesh<typename Embedding::Vertex_data>& mesh, const Embedding& embedding,
                        const Surface_function& function, const Input_surface& input,
                        Mesh_intersections<Working_mesh<typename Embedding::Vertex_data>>& intersections,
                        const Remeshing_parameters& parameters, const Visitor_reference visitor)
{
  typedef Surface_projection<Surface_function> Projection;
  typedef Remesher<ConcurrencyTag, Embedding, Projection> Remesher;
  static constexpr double largest_shift_of_tips = 1e-6; // over the diagonal, by the projection: one that is on the surface

  Real_timer timer;
  timer.start();
  visitor.stage_started(Stage::PROJECTION);
  Interruption& interruption = visitor.interruption();
  if (parameters.number_of_iterations > 0)
    reorder_in_space<ConcurrencyTag>(mesh, interruption);
  const double length = expected_length<ConcurrencyTag>(mesh, parameters, input.diagonal());
  intersections.template find_near_sheets<ConcurrencyTag>(length, parameters.error, interruption);
  Curve_network curves = curve_network(mesh, function.is_piecewise(), input.diagonal(), parameters.allowed);
  if (parameters.project_borders)
    curves.project_borders(mesh);
  const Feature_curves curves_before = feature_curves(mesh);
  Projection projection(function, input);
  Remesher remesher(mesh, embedding, projection, curves, intersections, parameters, visitor);
  const auto tips = apexes(mesh);
  remesher.project_input();
  orient(projection, mesh);
  fix_apexes(tips, largest_shift_of_tips * input.diagonal(), mesh);
  const double projection_seconds = timer.time();

  timer.reset();
  if (!interruption.is_requested())
  {
    visitor.stage_started(Stage::REMESHING);
    remesher.find_target();
    remesher.run();
  }
  Remeshing_report report = remesher.report();
  report.number_of_regions = number_of_pieces(function);
  report.curves_before = curves_before;
  report.curves_after = feature_curves(mesh);
  report.projections = projection.counters();
  report.projection_seconds = projection_seconds;
  report.remeshing_seconds = timer.time();
  return report;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_IMPL_H
