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
#include "verdict.h"
#include "wrapped.h"

#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace hde_remesh {

namespace {

class Table
{
public:
  Table(const Report& report, std::ostream& stream) : m_report(report), m_stream(stream) {}

  void print_verdict()
  {
    static constexpr std::size_t column_of_texts = 26;
    m_stream << m_report.input << " -> " << m_report.output << '\n';
    for (const Verdict_line& line : verdict(m_report))
    {
      std::string beginning = line.name.empty() ? "" : line.name + ":";
      beginning.resize(column_of_texts, ' ');
      m_stream << wrapped(beginning, line.text, column_of_texts);
    }
    m_stream << '\n';
  }

  // With the line of names, the time and D, these are 15 lines.
  void print_most_important()
  {
    static constexpr std::size_t number = 12;
    print_rows(most_important_rows(table_rows(m_report), number));
    row("time", "", fixed(total_time(), 2) + " s");
    m_stream << "D = " << number_of_diagonal() << " is the diagonal of the bounding box. --details prints all figures.\n";
  }

  void print_all()
  {
    print_rows(table_rows(m_report));
    m_stream << '\n';
    print_stages();
    m_stream << '\n';
    print_work();
    m_stream << "D = " << number_of_diagonal() << " is the diagonal of the bounding box\n";
  }

private:
  void row(const std::string& name, const std::string& before, const std::string& after)
  {
    m_stream << std::left << std::setw(46) << name << std::right << std::setw(14) << before << std::setw(14) << after << '\n';
  }

  void print_rows(const std::vector<Table_row>& rows)
  {
    row("", "before", "after");
    for (const Table_row& each : rows)
      row(each.name, each.before, each.after);
  }

  // a length, relative to the diagonal
  std::string relative(const double length) const { return number(length / m_report.diagonal, 3) + " D"; }
  std::string number_of_diagonal() const { return number(m_report.diagonal, 6); }

  double total_time() const
  {
    double total = 0;
    for (const auto& stage : m_report.stages)
      total += stage.second;
    return total;
  }

  void print_stages()
  {
    const double total = total_time();
    for (const auto& stage : m_report.stages)
      row("time: " + stage.first, fixed(stage.second, 2) + " s", fixed(100 * stage.second / total, 1) + " %");
    row("time: all", fixed(total, 2) + " s", "");
  }

  void print(const std::ostringstream& text) { m_stream << wrapped("", text.str(), 2); }

  void print_work()
  {
    const Hde::Remeshing_result& result = m_report.result;
    if (m_report.points)
      print_points(*m_report.points);
    if (m_report.pieces)
      print_pieces(*m_report.pieces);
    else if (m_report.rbf)
      print_function(*m_report.rbf);
    std::ostringstream text;
    text << "remeshing: " << result.number_of_iterations << " iterations, " << result.number_of_splits << " splits, "
         << result.number_of_collapses << " contractions, " << result.number_of_flips << " flips; " << m_report.embedding;
    print(text);
    if (m_report.has_function())
      print_projections(result);
  }

  void print_points(const Points_figures& points)
  {
    const Hde::Reconstruction_result& found = points.found;
    std::ostringstream text;
    text << "points: " << points.number << ", " << points.number_without_normal << " without normal"
         << (points.are_normals_estimated ? " of those estimated" : "") << ", " << found.number_of_outliers << " outliers, "
         << found.number_of_wrong_normals << " wrong normals; spacing " << relative(found.spacing) << ", noise "
         << relative(found.noise) << "; " << found.number_of_closed_holes << " holes closed, " << found.number_of_components
         << " components, " << found.number_of_missed_places << " places missed, " << found.number_of_faces << " faces";
    if (points.trim)
      text << ", " << points.number_of_faces_after_trimming << " after trimming at " << relative(*points.trim);
    if (points.number_of_removed_components > 0)
      text << "; " << points.number_of_removed_components << " components removed";
    print(text);
  }

  void print_projections(const Hde::Remeshing_result& result)
  {
    std::ostringstream text;
    text << "projections: " << result.projections.newton << " by Newton's method, " << result.projections.bisection
         << " by bisection, " << result.projections.descent << " by descent, " << result.projections.closest_point
         << " by the closest point of the input";
    print(text);
  }

  void print_pieces(const Hde::Piecewise_rbf_diagnostics& pieces)
  {
    std::ostringstream text, check;
    text << "function: " << m_report.kernel << ", " << pieces.number_of_regions << " regions: " << pieces.number_of_fields
         << " fields, " << pieces.number_of_planes << " planes, " << pieces.number_of_closest_point_regions
         << " too small for a field, " << pieces.number_of_regions_without_area << " without area; " << pieces.number_of_points
         << " points (" << pieces.number_of_points_on_facets << " on facets, in place of " << pieces.number_of_replaced_vertices
         << " vertices; " << pieces.number_of_points_on_edges << " on edges), " << pieces.number_of_patches << " patches, "
         << fixed(static_cast<double>(pieces.memory_bytes) / 1e6, 1) << " MB, residual " << number(pieces.worst_residual, 2);
    print(text);
    check << "self-check: " << pieces.patches_repaired << " patches repaired, " << pieces.patches_on_fallback
          << " replaced by the distance to the input (" << pieces.patches_off_facets << " too far from facets, after "
          << pieces.number_of_refined_places << " points were added there), " << pieces.number_of_failed_checks
          << " checks of the others failed";
    print(check);
    print_noise(pieces.noise);
  }

  void print_function(const Hde::Rbf_diagnostics& rbf)
  {
    std::ostringstream text, check;
    text << "function: " << m_report.kernel << ", " << rbf.number_of_points << " points (" << rbf.number_of_points_on_facets
         << " on facets, in place of " << rbf.number_of_replaced_vertices << " vertices; " << rbf.number_of_points_on_edges
         << " on edges), " << rbf.number_of_patches << " patches of " << fixed(rbf.mean_centres, 0) << " centres (at most "
         << rbf.max_centres << "), " << fixed(static_cast<double>(rbf.memory_bytes) / 1e6, 1) << " MB, residual "
         << number(rbf.worst_residual, 2);
    print(text);
    check << "self-check: " << rbf.patches_repaired << " patches repaired, " << rbf.patches_on_fallback
          << " replaced by the distance to the input (" << rbf.patches_off_facets << " too far from facets, after "
          << rbf.number_of_refined_places << " points were added there), " << rbf.number_of_failed_checks
          << " checks of the others failed; solved with ridge " << rbf.patches_with_ridge << ", by LU " << rbf.patches_with_lu
          << "; " << rbf.number_of_shortened_offsets << " offsets shortened";
    print(check);
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

void print_table(const Report& report, const bool with_details, std::ostream& stream)
{
  Table table(report, stream);
  table.print_verdict();
  if (with_details)
    table.print_all();
  else
    table.print_most_important();
}

} // namespace hde_remesh
