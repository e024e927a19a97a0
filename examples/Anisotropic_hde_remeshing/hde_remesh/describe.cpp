// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the report says of a run: its options, what it did, and what of its result no one expects.

#include "describe.h"
#include "measure.h"

#include <iomanip>
#include <sstream>
#include <string>

namespace hde_remesh {

namespace {

void measure_all(const Mesh& input, const Remeshed& remeshed, const Options& options, Report& report)
{
  const double sigma = remeshed.result.sigma, length = remeshed.result.target_edge_length;
  report.before = measure(input, remeshed.function, sigma, length, options.self_intersections);
  report.after = measure(remeshed.mesh, remeshed.function, sigma, length, options.self_intersections);
  if (!options.no_distance)
    report.distance = measure_distance(remeshed.mesh, input);
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

// what is no error, but no one expects
void add_warnings(Report& report)
{
  static constexpr double largest_distance = 0.02; // of the diagonal
  const std::vector<std::string> of_result = report.result.warnings();
  report.warnings.insert(report.warnings.end(), of_result.begin(), of_result.end()); // after those of the reading
  if (report.distance && !(report.distance->max() <= largest_distance * report.diagonal))
  {
    std::ostringstream text;
    text << "IN and OUT are up to " << std::setprecision(2) << report.distance->max() / report.diagonal << " D apart";
    report.warnings.push_back(text.str());
  }
}

} // namespace

void describe(const Options& options, const Checked_mesh& input, const Sizes& sizes, const Remeshed& remeshed, Report& report)
{
  describe_run(options, input, sizes, remeshed, report);
  measure_all(input.mesh, remeshed, options, report);
  add_warnings(report);
}

} // namespace hde_remesh
