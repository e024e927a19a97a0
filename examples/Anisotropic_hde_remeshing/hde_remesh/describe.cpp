// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the report says of a run: its options, what it did, and what of its result no one expects.

#include "describe.h"
#include "in_short.h"
#include "measure.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/regions/has_long_facets.h>

#include <string>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

constexpr double sharp_edge_degrees = 60; // of which scans have few

// what the steps take of the time: those of both meshes, the distance between them and that of the sharp edges
std::vector<double> costs_of_all(const Mesh& input, const Remeshed& remeshed, const Options& options)
{
  static constexpr double cost_of_distance = 7; // of a face
  std::vector<double> costs = costs_of_measures(input, remeshed.function, options.self_intersections);
  const std::vector<double> of_after = costs_of_measures(remeshed.mesh, remeshed.function, options.self_intersections);
  costs.insert(costs.end(), of_after.begin(), of_after.end());
  if (!options.no_distance)
    costs.push_back(cost_of_distance * static_cast<double>(input.number_of_faces() + remeshed.mesh.number_of_faces()));
  return costs;
}

void measure_all(const Mesh& input, const Remeshed& remeshed, const Options& options, Report& report, Progress& progress)
{
  Steps steps(progress, "measuring", costs_of_all(input, remeshed, options));
  const auto step_is_done = [&steps] { steps.next(); };
  const double sigma = remeshed.result.sigma, length = remeshed.result.target_edge_length;
  report.before = measure(input, remeshed.function, sigma, length, options.self_intersections, step_is_done);
  report.after = measure(remeshed.mesh, remeshed.function, sigma, length, options.self_intersections, step_is_done);
  if (!options.self_intersections && options.avoid_self_intersections)
  {
    report.before.self_intersections = remeshed.result.number_of_self_intersections_before;
    report.after.self_intersections = remeshed.result.number_of_self_intersections;
  }
  if (!options.no_distance)
  {
    report.distance = measure_distance(remeshed.mesh, input);
    steps.next();
  }
}

void describe_run(const Options& options, const Checked_mesh& input, const Sizes& sizes, const Remeshed& remeshed,
                  Report& report)
{
  report.version = version_text();
  report.input = options.input;
  report.output = options.output;
  report.number_of_isolated_vertices = input.number_of_isolated_vertices;
  report.kernel = remeshed.kernel;
  report.scheme = scheme_text(sizes.scheme);
  report.embedding = embedding_text(sizes, options);
  report.has_6d_lengths = has_6d_lengths(sizes, options);
  report.error = sizes.error;
  report.diagonal = diagonal(input.mesh);
  report.number_of_target_faces = sizes.number_of_faces;
  report.result = remeshed.result;
  report.rbf = remeshed.rbf;
  report.sharp = options.sharp;
  report.pieces = remeshed.pieces;
}

// Options that change nothing, as there is no function, or none that they could change.
void warn_of_options(const Options& options, const Remeshed& remeshed, Report& report)
{
  if (!remeshed.function.has_values() || remeshed.keeps_facets)
  {
    const std::string reason =
        remeshed.keeps_facets ? "the facets of IN are exact, and kept" : "by measured error there is no function";
    const std::vector<std::pair<const char*, bool>> given = {
        {"--kernel", options.kernel != "r3"},       {"--shape", options.shape.has_value()},
        {"--patches", options.patches.has_value()}, {"--overlap", options.overlap.has_value()},
        {"--offset", options.offset.has_value()},   {"--smoothing", options.smoothing || options.automatic_smoothing},
        {"--vertices-only", options.vertices_only}, {"--smooth-edges", options.smooth_edges}};
    for (const auto& [name, is_given] : given)
      if (is_given)
        report.warnings.push_back(std::string(name) + " has no effect: " + reason);
  }
  if (!remeshed.function.has_values())
    return;
  for (const auto& [name, is_given] :
       {std::make_pair("--aspect-ratio", options.aspect_ratio), std::make_pair("--shape-weight", options.shape_weight)})
    if (is_given)
      report.warnings.push_back(std::string(name) + " has no effect by an embedding: --scheme measured-error takes it");
  const std::size_t number = remeshed.rbf ? remeshed.rbf->number_of_patches : remeshed.pieces->number_of_patches,
                    on_fallback = remeshed.rbf ? remeshed.rbf->patches_on_fallback : remeshed.pieces->patches_on_fallback;
  if ((options.smoothing || options.automatic_smoothing) && 2 * on_fallback > number)
    report.warnings.push_back("--smoothing has " + std::string(on_fallback == number ? "no" : "little") +
                              " effect: " + std::to_string(on_fallback) + " of " + std::to_string(number) +
                              " patches of the function are replaced by the distance to IN");
}

// Sharp edges that no one wanted to keep, where they have become round.
void warn_of_creases(const Mesh& input, const Remeshed& remeshed, const Options& options, Report& report)
{
  static constexpr double largest_distance = 0.01; // of the diagonal
  if (options.sharp || !report.distance || !(report.distance->max() > largest_distance * report.diagonal))
    return;
  const double distance = distance_of_sharp_edges(input, remeshed.mesh, sharp_edge_degrees);
  if (distance > largest_distance * report.diagonal)
    report.warnings.push_back("edges of IN that turn by " + in_short(sharp_edge_degrees) + " degrees or more are up to " +
                              in_short(distance / report.diagonal) + " D from OUT: --sharp " + in_short(sharp_edge_degrees) +
                              " keeps them");
}

// Long and exact facets, where an embedding was asked for that has not kept them: the measured error led instead. Or the vertices stand
// where the lengths want them, and not on the edges between facets.
void note_long_facets(const Mesh& input, const Options& options, const Remeshed& remeshed, Report& report)
{
  static constexpr double rounding = 1e-6; // of the diagonal
  namespace Hde_internal = CGAL::Anisotropic_hde_remeshing::internal;
  const bool is_embedding_given = options.scheme == "default" && (options.metric || options.sigma || options.absolute_sigma);
  if (!remeshed.function.has_values() && is_embedding_given)
    report.notes.push_back(
        "IN has the long and exact facets of a CAD program, which so many triangles do not keep in an embedding: "
        "the measured error leads. --scheme embedding is uniform in any case");
  if (!remeshed.function.has_values() || !report.distance || !(report.distance->max() > rounding * report.diagonal) ||
      !Hde_internal::has_long_facets(faces(input), input, input.points()))
    return;
  report.notes.push_back("IN has the long and exact facets of a CAD program: by an embedding IN and OUT are up to " +
                         in_short(report.distance->max() / report.diagonal) + " D apart, by a number of faces alone less");
}

// what is no error, but no one expects
void add_warnings(Report& report)
{
  static constexpr double largest_distance = 0.02; // of the diagonal
  const std::vector<std::string> of_result = report.result.warnings();
  report.warnings.insert(report.warnings.end(), of_result.begin(), of_result.end()); // after those of the reading
  if (report.error && report.rounding > *report.error)
    report.warnings.push_back("the coordinates of IN are rounded to " + in_short(report.rounding) +
                              ", which is more than the error asked for");
  if (report.distance && !(report.distance->max() <= largest_distance * report.diagonal))
    report.warnings.push_back("IN and OUT are up to " + in_short(report.distance->max() / report.diagonal) + " D apart");
}

} // namespace

void describe(const Options& options, const Checked_mesh& input, const Sizes& sizes, const Remeshed& remeshed, Report& report,
              Progress& progress)
{
  describe_run(options, input, sizes, remeshed, report);
  measure_all(input.mesh, remeshed, options, report, progress);
  add_warnings(report);
  warn_of_creases(input.mesh, remeshed, options, report);
  warn_of_options(options, remeshed, report);
  note_long_facets(input.mesh, options, remeshed, report);
}

} // namespace hde_remesh
