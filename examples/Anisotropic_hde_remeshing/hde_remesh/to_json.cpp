// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Report.h"

#include <nlohmann/json.hpp>

namespace hde_remesh {

namespace {

// keeps the order in which the figures are named here
typedef nlohmann::ordered_json Json;

Json to_json(const Hde::Topology_measures& m)
{
  return {{"vertices", m.number_of_vertices},
          {"edges", m.number_of_edges},
          {"faces", m.number_of_faces},
          {"components", m.number_of_components},
          {"boundary_loops", m.number_of_boundary_loops},
          {"boundary_edges", m.number_of_boundary_edges},
          {"euler_characteristic", m.euler_characteristic},
          {"valence_6_share", m.valence_6_share}};
}

Json to_json(const Hde::Shape_measures& m)
{
  return {{"mean", m.aspect_ratio_mean},
          {"p99", m.aspect_ratio_p99},
          {"max", m.aspect_ratio_max}, // null where infinite: JSON has no infinity
          {"degenerate_faces", m.number_of_degenerate_faces},
          {"folded_edges", m.number_of_folded_edges}};
}

Json to_json(const Hde::Embedding_measures& m, const Hde::Embedding_measures& to_target)
{
  return {{"sigma", m.sigma},
          {"mean_edge_length", m.edge_length_mean},
          {"share_within_0.7_1.41_of_mean", m.share_within_sqrt_2},
          {"share_within_0.5_1.5_of_mean", m.share_within_half},
          {"target_edge_length", to_target.target_edge_length},
          {"share_within_0.7_1.41_of_target", to_target.share_within_sqrt_2},
          {"share_within_0.5_1.5_of_target", to_target.share_within_half},
          {"minimum_angle_mean", m.minimum_angle_mean},
          {"minimum_angle_least", m.minimum_angle_least},
          {"folded_faces", m.number_of_folded_faces}};
}

Json to_json(const Hde::Alignment_measures& m)
{
  return {{"faces", m.number_of_faces}, {"angle_mean", m.angle_mean}, {"share_within_15_degrees", m.share_within_15_degrees}};
}

Json to_json(const Hde::Zero_set_measures& m)
{
  return {{"interior_vertex_max", m.interior_vertex_max},
          {"boundary_vertex_max", m.boundary_vertex_max},
          {"face_rms", m.face_rms},
          {"face_max", m.face_max},
          {"samples", m.number_of_samples}};
}

Json to_json(const Hde::Approximation_bounds& m)
{
  return {{"rms_on_surface", m.rms_on_surface},
          {"rms_off_surface", m.rms_off_surface},
          {"max_on_surface", m.max_on_surface},
          {"max_off_surface", m.max_off_surface}};
}

Json to_json(const Figures& figures)
{
  Json json = {{"topology", to_json(figures.topology)}, {"aspect_ratio", to_json(figures.shape)}};
  if (figures.of_function)
  {
    const Function_figures& of_function = *figures.of_function;
    json["embedding"] = to_json(of_function.embedding, of_function.embedding_to_target);
    json["alignment"] = to_json(of_function.alignment);
    json["distance_to_zero_set"] = to_json(of_function.zero_set);
    json["least_distance_possible"] = to_json(of_function.bounds);
  }
  if (figures.self_intersections)
    json["self_intersections"] = *figures.self_intersections;
  return json;
}

Json to_json(const Hde::Rbf_diagnostics& rbf)
{
  return {{"points", rbf.number_of_points},
          {"points_on_facets", rbf.number_of_points_on_facets},
          {"replaced_vertices", rbf.number_of_replaced_vertices},
          {"points_on_edges", rbf.number_of_points_on_edges},
          {"duplicate_points", rbf.number_of_duplicate_points},
          {"points_without_normal", rbf.number_of_points_without_normal},
          {"noise", rbf.noise},
          {"patches", rbf.number_of_patches},
          {"mean_centres", rbf.mean_centres},
          {"max_centres", rbf.max_centres},
          {"worst_residual", rbf.worst_residual},
          {"worst_value_residual", rbf.worst_value_residual},
          {"worst_condition", rbf.worst_condition},
          {"patches_repaired", rbf.patches_repaired},
          {"failed_checks", rbf.number_of_failed_checks},
          {"patches_with_ridge", rbf.patches_with_ridge},
          {"patches_with_lu", rbf.patches_with_lu},
          {"patches_on_fallback", rbf.patches_on_fallback},
          {"patches_off_facets", rbf.patches_off_facets},
          {"refined_places", rbf.number_of_refined_places},
          {"shortened_offsets", rbf.number_of_shortened_offsets},
          {"memory_bytes", rbf.memory_bytes},
          {"input_seconds", rbf.input_seconds},
          {"constraint_seconds", rbf.constraint_seconds},
          {"partition_seconds", rbf.partition_seconds},
          {"solve_seconds", rbf.solve_seconds}};
}

Json to_json(const Hde::Piecewise_rbf_diagnostics& pieces)
{
  return {{"regions", pieces.number_of_regions},
          {"fields", pieces.number_of_fields},
          {"planes", pieces.number_of_planes},
          {"closest_point_regions", pieces.number_of_closest_point_regions},
          {"regions_without_area", pieces.number_of_regions_without_area},
          {"points", pieces.number_of_points},
          {"points_on_facets", pieces.number_of_points_on_facets},
          {"replaced_vertices", pieces.number_of_replaced_vertices},
          {"points_on_edges", pieces.number_of_points_on_edges},
          {"noise", pieces.noise},
          {"patches", pieces.number_of_patches},
          {"worst_residual", pieces.worst_residual},
          {"worst_value_residual", pieces.worst_value_residual},
          {"worst_condition", pieces.worst_condition},
          {"patches_repaired", pieces.patches_repaired},
          {"failed_checks", pieces.number_of_failed_checks},
          {"patches_on_fallback", pieces.patches_on_fallback},
          {"patches_off_facets", pieces.patches_off_facets},
          {"refined_places", pieces.number_of_refined_places},
          {"memory_bytes", pieces.memory_bytes}};
}

Json to_json(const Hde::Feature_curves& curves)
{
  return {{"curves", curves.number_of_curves}, {"corners", curves.number_of_corners}, {"length", curves.length}};
}

Json to_json(const Hde::Remeshing_result& result)
{
  return {{"iterations", result.number_of_iterations},
          {"splits", result.number_of_splits},
          {"collapses", result.number_of_collapses},
          {"flips", result.number_of_flips},
          {"projections_newton", result.projections.newton},
          {"projections_bisection", result.projections.bisection},
          {"projections_descent", result.projections.descent},
          {"projections_closest_point", result.projections.closest_point},
          {"unprojected_vertices", result.number_of_unprojected_vertices},
          {"needles", result.number_of_needles},
          {"faces_beyond_aspect_ratio", result.number_of_faces_beyond_aspect_ratio},
          {"lone_faces", result.number_of_lone_faces},
          {"long_facets", result.has_long_facets}};
}

Json to_json(const Hde::Distance_measures& m)
{
  return {{"rms_output_to_input", m.rms_from_first},
          {"max_output_to_input", m.max_from_first},
          {"rms_input_to_output", m.rms_from_second},
          {"max_input_to_output", m.max_from_second},
          {"rms", m.rms()},
          {"max", m.max()}};
}

Json to_json(const Repair& repair)
{
  return {{"merged_points", repair.merged_points},   {"near_points", repair.near_points},
          {"wall_faces", repair.wall_faces},         {"added_points", repair.added_points},
          {"removed_points", repair.removed_points}, {"removed_faces", repair.removed_faces},
          {"turned_faces", repair.turned_faces},     {"doubled_points", repair.doubled_points},
          {"divided_faces", repair.divided_faces},   {"stitched_edges", repair.stitched_edges}};
}

Json to_json(const Points_figures& points)
{
  const Hde::Reconstruction_result& found = points.found;
  Json json = {{"number", points.number},
               {"normals_are_estimated", points.are_normals_estimated},
               {"without_normal", points.number_without_normal},
               {"outliers", found.number_of_outliers},
               {"wrong_normals", found.number_of_wrong_normals},
               {"holes_closed", found.number_of_closed_holes},
               {"noise", found.noise},
               {"spacing", found.spacing},
               {"components", found.number_of_components},
               {"missed_places", found.number_of_missed_places},
               {"vertices", found.number_of_vertices},
               {"faces", found.number_of_faces},
               {"facet_size", found.facet_size},
               {"evaluations", found.number_of_evaluations},
               {"function_seconds", found.function_seconds},
               {"meshing_seconds", found.meshing_seconds},
               {"removed_components", points.number_of_removed_components},
               {"carried", points.carried}};
  if (points.trim)
    json["trim"] = {{"distance", *points.trim}, {"faces_left", points.number_of_faces_after_trimming}};
  return json;
}

} // namespace

std::string to_json(const Report& report)
{
  Json json = {{"program", report.version},
               {"input", report.input},
               {"output", report.output},
               {"unit", "lengths and distances are in the unit of the mesh, angles in degrees"},
               {"diagonal", report.diagonal},
               {"scheme", report.scheme},
               {"isolated_vertices", report.number_of_isolated_vertices}};
  if (report.points)
    json["points"] = to_json(*report.points);
  if (report.has_function())
  {
    json["sigma"] = report.result.sigma;
    json["kernel"] = report.kernel;
    json["target_edge_length"] = report.result.target_edge_length;
  }
  if (report.flat_faces.number > 0)
    json["faces_without_area"] = {{"removed", report.flat_faces.number - report.flat_faces.number_left},
                                  {"left", report.flat_faces.number_left}};
  if (report.tolerance > 0)
    json["cracks"] = {{"tolerance", report.tolerance}, {"merged_points", report.number_of_merged_points}};
  if (report.repair)
    json["repair"] = to_json(*report.repair);
  if (report.number_of_target_faces)
    json["target_faces"] = *report.number_of_target_faces;
  json["embedding"] = report.embedding;
  json["regions"] = report.result.number_of_regions;
  json["feature_curves"] = {{"before", to_json(report.result.curves_before)}, {"after", to_json(report.result.curves_after)}};
  if (report.sharp)
    json["sharp"] = *report.sharp;
  if (report.error)
  {
    json["error"] = *report.error;
    json["error_bound"] = report.result.approximation_error;
    json["error_is_kept"] = report.result.approximation_error <= *report.error * (1 + 1e-12);
  }
  json["notes"] = report.notes;
  json["warnings"] = report.warnings;
  json["before"] = to_json(report.before);
  json["after"] = to_json(report.after);
  if (report.distance)
    json["distance"] = to_json(*report.distance);
  for (const auto& stage : report.stages)
    json["seconds"][stage.first] = stage.second;
  json["remeshing"] = to_json(report.result);
  if (report.has_function())
    json["function"] = report.pieces ? to_json(*report.pieces) : to_json(*report.rbf);
  // a file name need not be UTF-8, which JSON is
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace hde_remesh
