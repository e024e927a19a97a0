// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Report.h"
#include "number_text.h"
#include "table_rows.h"

#include <iomanip>
#include <ostream>
#include <string>

namespace hde_remesh {

namespace {

class Table
{
public:
  Table(const Report& report, std::ostream& stream) : m_report(report), m_stream(stream) {}

  void print()
  {
    row("", "before", "after");
    for (const Table_row& each : table_rows(m_report))
      row(each.name, each.before, each.after);
    m_stream << '\n';
    print_stages();
    m_stream << '\n';
    print_work();
  }

private:
  void row(const std::string& name, const std::string& before, const std::string& after)
  {
    m_stream << std::left << std::setw(46) << name << std::right << std::setw(14) << before << std::setw(14) << after << '\n';
  }

  // a length, relative to the diagonal
  std::string relative(const double length) const { return number(length / m_report.diagonal, 3) + " D"; }

  void print_stages()
  {
    double total = 0;
    for (const auto& stage : m_report.stages)
      total += stage.second;
    for (const auto& stage : m_report.stages)
      row("time: " + stage.first, fixed(stage.second, 2) + " s", fixed(100 * stage.second / total, 1) + " %");
    row("time: all", fixed(total, 2) + " s", "");
  }

  void print_work()
  {
    const Hde::Remeshing_result& result = m_report.result;
    if (m_report.points)
      print_points(*m_report.points);
    if (m_report.pieces)
      print_pieces(*m_report.pieces);
    else if (m_report.rbf)
      print_function(*m_report.rbf);
    m_stream << "remeshing: " << result.number_of_iterations << " iterations, " << result.number_of_splits << " splits, "
             << result.number_of_collapses << " contractions, " << result.number_of_flips << " flips; " << m_report.embedding
             << '\n';
    if (m_report.error)
      m_stream << (result.approximation_error <= *m_report.error * (1 + 1e-12) ? "the error asked for is kept"
                   : result.binding_target == Hde::Target::NUMBER_OF_FACES
                       ? "the number of faces was reached before the error asked for"
                       : "the error asked for is not kept: the function has no surface near some faces")
               << '\n';
    if (m_report.has_function())
      print_projections(result);
    m_stream << "D = " << number(m_report.diagonal, 6) << ", the diagonal of the bounding box\n";
    m_stream << m_report.input << " -> " << m_report.output << '\n';
  }

  void print_points(const Points_figures& points)
  {
    const Hde::Reconstruction_result& found = points.found;
    m_stream << "points: " << points.number << ", " << points.number_without_normal << " without normal"
             << (points.are_normals_estimated ? " of those estimated" : "") << ", " << found.number_of_outliers << " outliers, "
             << found.number_of_wrong_normals << " wrong normals; spacing " << relative(found.spacing) << ", noise "
             << relative(found.noise) << "; " << found.number_of_closed_holes << " holes closed, " << found.number_of_components
             << " components, " << found.number_of_missed_places << " places missed, " << found.number_of_faces << " faces";
    if (points.trim)
      m_stream << ", " << points.number_of_faces_after_trimming << " after trimming at " << relative(*points.trim);
    if (points.number_of_removed_components > 0)
      m_stream << "; " << points.number_of_removed_components << " components removed";
    m_stream << '\n';
  }

  void print_projections(const Hde::Remeshing_result& result)
  {
    m_stream << "projections: " << result.projections.newton << " by Newton's method, " << result.projections.bisection
             << " by bisection, " << result.projections.descent << " by descent, " << result.projections.closest_point
             << " by the closest point of the input\n";
    if (result.number_of_unprojected_vertices > 0)
      m_stream << result.number_of_unprojected_vertices
               << " vertices are not on the surface: no way leads there, or the last one would fold a face or make it "
                  "intersect others\n";
  }

  void print_pieces(const Hde::Piecewise_rbf_diagnostics& pieces)
  {
    m_stream << "function: " << m_report.kernel << ", " << pieces.number_of_regions << " regions: " << pieces.number_of_fields
             << " fields, " << pieces.number_of_planes << " planes, " << pieces.number_of_closest_point_regions
             << " too small for a field, " << pieces.number_of_regions_without_area << " without area; "
             << pieces.number_of_points << " points (" << pieces.number_of_points_on_facets << " on facets, in place of "
             << pieces.number_of_replaced_vertices << " vertices; " << pieces.number_of_points_on_edges << " on edges), "
             << pieces.number_of_patches << " patches, " << fixed(static_cast<double>(pieces.memory_bytes) / 1e6, 1)
             << " MB, residual " << number(pieces.worst_residual, 2) << '\n';
    m_stream << "self-check: " << pieces.patches_repaired << " patches repaired, " << pieces.patches_on_fallback
             << " answered by the input itself (" << pieces.patches_off_facets << " too far from facets, after "
             << pieces.number_of_refined_places << " points were added there), " << pieces.number_of_failed_checks
             << " checks of the others failed\n";
    print_noise(pieces.noise);
  }

  void print_function(const Hde::Rbf_diagnostics& rbf)
  {
    m_stream << "function: " << m_report.kernel << ", " << rbf.number_of_points << " points (" << rbf.number_of_points_on_facets
             << " on facets, in place of " << rbf.number_of_replaced_vertices << " vertices; " << rbf.number_of_points_on_edges
             << " on edges), " << rbf.number_of_patches << " patches of " << fixed(rbf.mean_centres, 0) << " centres (at most "
             << rbf.max_centres << "), " << fixed(static_cast<double>(rbf.memory_bytes) / 1e6, 1) << " MB, residual "
             << number(rbf.worst_residual, 2) << '\n';
    m_stream << "self-check: " << rbf.patches_repaired << " patches repaired, " << rbf.patches_on_fallback
             << " answered by the input itself (" << rbf.patches_off_facets << " too far from facets, after "
             << rbf.number_of_refined_places << " points were added there), " << rbf.number_of_failed_checks
             << " checks of the others failed; solved with ridge " << rbf.patches_with_ridge << ", by LU "
             << rbf.patches_with_lu << "; " << rbf.number_of_shortened_offsets << " offsets shortened\n";
    print_noise(rbf.noise);
  }

  void print_noise(const double noise)
  {
    if (noise > 0)
      m_stream << "noise of the vertices, standard deviation: " << relative(noise) << '\n';
  }

  const Report& m_report;
  std::ostream& m_stream;
};

} // namespace

void print_table(const Report& report, std::ostream& stream) { Table(report, stream).print(); }

} // namespace hde_remesh
