// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_IMPL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_IMPL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_by_error.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_impl.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Two_sided_check.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Returns the faces that do not keep the error, if one was asked for.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
auto remesh_once(Mesh& mesh, const Curve_network& curves, Guard& guard, const Input_surface& input,
                 const Remeshing_parameters& parameters, const Visitor_reference visitor, const double share_of_error,
                 Remeshing_report& report)
{
  Error_remesher<ConcurrencyTag, Mesh, Guard> remesher(mesh, curves, guard, input, parameters, visitor, share_of_error);
  remesher();
  report.number_of_iterations = remesher.number_of_rounds();
  report.operations = remesher.statistics();
  report.error = remesher.error_bound();
  return remesher.failing();
}

// Marks the vertices of the input near faces that do not keep the error.
template <typename ConcurrencyTag, typename FailingFaces>
void mark_vertices_near(const FailingFaces& failing, const double distance, const Input_surface& input,
                        std::vector<char>& marks)
{
  for (const auto& f : failing)
    for (const std::size_t v : input.facets()[input.closest(f.place).facet])
      marks[v] = 1;
  parallel_for<ConcurrencyTag>(marks.size(),
                               [&](const std::size_t v)
                               {
                                 for (const auto& f : failing)
                                   if (f.triangle.closest(input.points()[v]).squared_distance <= distance * distance)
                                     marks[v] = 1;
                               });
}

// Where some faces cannot be brought near enough to the input, it begins again, and keeps the input there as it is. If that does
// not help either, all of the input stays: it keeps every error. Where that takes more faces than allowed, their number leads.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
void keep_error(Mesh& mesh, const Curve_network& curves, Guard& guard, const Input_surface& input,
                const Remeshing_parameters& parameters, const Visitor_reference visitor, Remeshing_report& report)
{
  static constexpr double reach_of_faces = 2; // over the error: so near to a face the input is kept
  Mesh original;
  original = mesh;
  std::vector<char> is_kept(vertex_capacity(mesh), 0);
  for (const double share_of_error : {0.92, 0.92, 0.8, 0.6, 0.4, 0.4})
  {
    const auto failing = remesh_once<ConcurrencyTag>(mesh, curves, guard, input, parameters, visitor, share_of_error, report);
    if (guard.intersections().is_to_restart())
      return;
    for (const Vertex_index v : mesh.vertices())
      if (mesh.point(v).input_vertex != Vertex_state::no_vertex)
        mesh.point(v).is_fixed = original.point(Vertex_index(mesh.point(v).input_vertex)).is_fixed;
    if (report.error <= parameters.error || visitor.interruption().is_requested() ||
        mesh.number_of_faces() > original.number_of_faces())
      break;
    mark_vertices_near<ConcurrencyTag>(failing, reach_of_faces * parameters.error, input, is_kept);
    mesh = original;
    for (const Vertex_index v : mesh.vertices())
      mesh.point(v).is_fixed = mesh.point(v).is_fixed || is_kept[v];
    guard.template update_all<ConcurrencyTag>();
  }
  if (visitor.interruption().is_requested())
    return;
  if (!(report.error <= parameters.error) || mesh.number_of_faces() > original.number_of_faces())
  {
    mesh = original;
    guard.template update_all<ConcurrencyTag>();
    report.error = 0;
  }
  if (double(mesh.number_of_faces()) > parameters.target.number_of_faces())
  {
    mesh = original;
    guard.template update_all<ConcurrencyTag>();
    Remeshing_parameters by_number = parameters;
    by_number.error = 0;
    remesh_once<ConcurrencyTag>(mesh, curves, guard, input, by_number, visitor, 0, report);
    report.error = bound_on_distance<ConcurrencyTag>(mesh, input, parameters.error, visitor.interruption());
  }
}

// Remeshes the copy of the mesh by measured error. The facets of the input are the surface.
template <typename ConcurrencyTag>
Remeshing_report remesh_by_error(Working_mesh<Normal_embedding::Vertex_data>& mesh, const bool is_piecewise,
                                 const Input_surface& input,
                                 Mesh_intersections<Working_mesh<Normal_embedding::Vertex_data>>& intersections,
                                 const Remeshing_parameters& parameters, const Visitor_reference visitor)
{
  typedef Working_mesh<Normal_embedding::Vertex_data> Mesh;
  static constexpr double share_of_faces = 0.98;          // as many as these: the number of faces has been reached
  static constexpr double share_of_error_at_curves = 0.5; // the faces beside need the rest
  typedef Operation_guard<Mesh, Surface_function> Guard;
  Real_timer timer;
  timer.start();
  visitor.stage_started(Stage::PROJECTION);
  Remeshing_report report;
  intersections.template find_near_sheets<ConcurrencyTag>(expected_length<ConcurrencyTag>(mesh, parameters, input.diagonal()),
                                                          parameters.error, visitor.interruption());
  Curve_network curves = curve_network(mesh, is_piecewise, input.diagonal(), parameters.allowed);
  if (parameters.error > 0)
    curves.set_largest_deviation((std::min)(curves.largest_deviation(), share_of_error_at_curves * parameters.error));
  report.curves_before = feature_curves(mesh);
  const Surface_function no_function;
  Guard guard(mesh, no_function, intersections);
  report.projection_seconds = timer.time();
  if (visitor.interruption().is_requested())
    return report;

  timer.reset();
  visitor.stage_started(Stage::REMESHING);
  if (parameters.error > 0)
  {
    keep_error<ConcurrencyTag>(mesh, curves, guard, input, parameters, visitor, report);
    intersections.template count_pairs<ConcurrencyTag>(); // the mesh may be another one than the last that was remeshed
  }
  else
    remesh_once<ConcurrencyTag>(mesh, curves, guard, input, parameters, visitor, 0, report);
  report.curves_after = feature_curves(mesh);
  if (parameters.error > 0)
    report.binding_target = report.error <= parameters.error ? Target::APPROXIMATION_ERROR
                            : double(mesh.number_of_faces()) > share_of_faces * parameters.target.number_of_faces()
                                ? Target::NUMBER_OF_FACES
                                : Target::GUARDS;
  else if (!visitor.interruption().is_requested())
    report.binding_target = what_binds(mesh, parameters.target.number_of_faces());
  report.remeshing_seconds = timer.time();
  return report;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_BY_ERROR_IMPL_H
