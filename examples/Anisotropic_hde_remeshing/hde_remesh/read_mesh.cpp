// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "read_mesh.h"
#include "Failure.h"
#include "Format.h"
#include "Stopwatch.h"
#include "cracks.h"
#include "creases.h"
#include "field_file.h"
#include "flat_faces.h"
#include "in_short.h"
#include "intersecting_faces.h"
#include "measure.h"
#include "mesh_file.h"
#include "mesh_of_points.h"
#include "reading_position.h"
#include "repair.h"
#include "rounding.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

constexpr double number_of_roundings = 4;

// What the steps take of the time, in hundredths of a second on the bunny with 75,000 triangles.
const std::vector<double> costs_of_repair = {1, 11, 2, 2, 2, 17, 2, 1}, costs_of_checks = {5, 1, 1, 10},
                          costs_of_checks_and_untangling = {5, 1, 1, 19, 10};

void read_field(const Options& options, Checked_mesh& input)
{
  const std::vector<double> values = read_vertex_property(options.input, options.field);
  Field field = add_field(input.mesh);
  for (const Mesh::Vertex_index v : input.mesh.vertices())
    field[v] = values.at(input.positions[v]);
}

// Points that are no further apart close cracks: those of a few roundings in STL files, which have no numbers of vertices. The points
// of other files are what they are, unless they are to be repaired.
double tolerance_of_cracks(const Options& options, const double rounding)
{
  const bool is_rounding_mended = options.repair || format_of(options.input) == Format::STL;
  return (std::max)(options.merge.value_or(0), is_rounding_mended ? number_of_roundings * rounding : 0);
}

// Faces of no more height are flat but for rounding, that of the file only if it is mended.
double tolerance_of_rounding(const Options& options, const Soup& soup)
{
  const bool is_rounding_mended = options.repair || format_of(options.input) == Format::STL;
  return number_of_roundings * (is_rounding_mended ? soup.rounding : rounding_of_doubles(soup.points));
}

void mend(const Options& options, Soup& soup, Report& report, Progress& progress)
{
  const double tolerance = tolerance_of_cracks(options, soup.rounding);
  if (options.repair)
  {
    Steps steps(progress, "repairing", costs_of_repair);
    soup = repaired(std::move(soup), tolerance, report.repair.emplace(), [&steps] { steps.next(); });
    report.notes.push_back("repair: " + report.repair->text());
    report.number_of_merged_points = report.repair->near_points;
  }
  else if (tolerance > 0)
  {
    progress.stage("closing cracks");
    report.number_of_merged_points = close_cracks(soup, tolerance, Orientation::OPPOSITE);
    if (report.number_of_merged_points > 0)
      report.notes.push_back(std::to_string(report.number_of_merged_points) + " points are one with others within " +
                             in_short(tolerance) + ", which closes cracks");
  }
  report.tolerance = tolerance;
}

// rounded up to two digits
double rounded_up(const double value)
{
  const double unit = std::pow(10., std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit * (1 + 1e-9)) * unit;
}

// A mesh that is open, but only by cracks: which option closes them.
void advise_on_cracks(const Soup& soup, const double diagonal, Report& report)
{
  static constexpr double widest = 1e-5; // of the diagonal
  const std::optional<double> width = width_of_cracks(soup, widest * diagonal);
  if (!width)
    return;
  if (*width == 0)
    report.warnings.push_back("IN is open only where points coincide: --repair joins them");
  else
  {
    const std::string length = in_short(rounded_up(*width));
    report.warnings.push_back("IN is open only by cracks of up to " + length + ": --merge " + length + " closes them");
  }
}

// Triangles that have no neighbour, though their points are there several times.
void advise_on_single_triangles(const Checked_mesh& input, Report& report)
{
  static constexpr std::size_t many = 100;
  const Mesh& mesh = input.mesh;
  const auto is_single = [&](const Mesh::Face_index f)
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    return CGAL::is_border_edge(h, mesh) && CGAL::is_border_edge(mesh.next(h), mesh) &&
           CGAL::is_border_edge(mesh.prev(h), mesh);
  };
  const auto number = static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(), is_single));
  if (number < many)
    return;
  const std::set<Point_3> points(mesh.points().begin(), mesh.points().end());
  if (points.size() + number <= mesh.number_of_vertices())
    report.warnings.push_back(
        std::to_string(number) + " triangles of IN have no neighbour, as each has points of its own, though " +
        std::to_string(mesh.number_of_vertices() - points.size()) + " coincide with others: --repair joins them");
}

void advise(const Soup& soup, const Checked_mesh& input, const double diagonal, Report& report)
{
  if (CGAL::is_closed(input.mesh))
    return;
  const std::size_t number_of_warnings = report.warnings.size();
  advise_on_cracks(soup, diagonal, report);
  if (report.warnings.size() == number_of_warnings)
    advise_on_single_triangles(input, report);
}

void tell_flat_faces(Report& report)
{
  const std::size_t left = report.flat_faces.number_left, removed = report.flat_faces.number - left;
  if (removed > 0)
    report.notes.push_back(std::to_string(removed) + " faces without area are contracted or flipped");
  if (left > 0)
    report.warnings.push_back(std::to_string(left) + " faces of IN have no area, and cannot be contracted or flipped first");
}

void untangle_faces(Mesh& mesh, Report& report)
{
  const Intersecting_faces pairs = untangle(mesh);
  if (pairs.number == 0)
    return;
  const std::string left = pairs.number_left == 0 ? "none" : std::to_string(pairs.number_left);
  if (pairs.number_left < pairs.number)
    report.notes.push_back(std::to_string(pairs.number) + " pairs of faces of IN intersect, " + left +
                           " after CGAL's repair: " + std::to_string(pairs.number_of_new_points) +
                           " points have moved, or are new");
  else
    report.warnings.push_back(std::to_string(pairs.number) +
                              " pairs of faces of IN intersect, and CGAL's repair has not helped");
}

Checked_mesh checked_mesh(Soup soup, const Options& options, Report& report, Progress& progress)
{
  check_options_of_mesh(options);
  check_points(soup, options.input);
  mend(options, soup, report, progress);
  Steps steps(progress, "checking", options.repair ? costs_of_checks_and_untangling : costs_of_checks);
  Checked_mesh input = mesh_of_soup(soup, options.input);
  if (input.number_of_isolated_vertices > 0)
    report.notes.push_back(std::to_string(input.number_of_isolated_vertices) + " vertices without a face are left out");
  steps.next();
  const double d = diagonal(input.mesh);
  if (!std::isfinite(d * d) || !(d * d > 0))
    throw Failure(in_quotes(options.input) + ": its bounding box has the diagonal " + std::to_string(d) +
                  ", with which nobody can compute");
  advise(soup, input, d, report);
  steps.next();
  if (!options.field.empty())
    read_field(options, input);
  report.flat_faces = remove_flat_faces(input.mesh, tolerance_of_rounding(options, soup));
  tell_flat_faces(report);
  steps.next();
  if (options.repair)
  {
    untangle_faces(input.mesh, report);
    steps.next();
  }
  find_creases(input.mesh, options);
  return input;
}

Checked_mesh checked_mesh_of_points(Soup points, const Options& options, Report& report, Progress& progress)
{
  Checked_mesh input;
  input.mesh = mesh_of_points(points, options, report, progress);
  input.points = std::move(points);
  find_creases(input.mesh, options);
  return input;
}

} // namespace

Checked_mesh read_mesh(const Options& options, Report& report, Progress& progress)
{
  const Stopwatch stopwatch;
  progress.stage("reading", [] { return reading_position().share(); });
  Soup soup = read_soup(options.input);
  report.notes = soup.notes;
  report.rounding = soup.rounding;
  const bool is_of_points = soup.is_of_points();
  if (is_of_points)
    report.stages.emplace_back("reading", stopwatch.seconds());
  Checked_mesh input = is_of_points ? checked_mesh_of_points(std::move(soup), options, report, progress)
                                    : checked_mesh(std::move(soup), options, report, progress);
  if (!is_of_points)
    report.stages.emplace_back("reading", stopwatch.seconds());
  return input;
}

} // namespace hde_remesh
