// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "verdict.h"
#include "number_text.h"

#include <cstddef>
#include <utility>

namespace hde_remesh {

namespace {

class Verdict
{
public:
  explicit Verdict(const Report& report) : m_report(report) {}

  std::vector<Verdict_line> make()
  {
    add_faces();
    add_distances();
    if (m_report.error)
      add("error asked for", relative(*m_report.error) + ", " + about_error());
    add_worst_triangle();
    if (const std::size_t number = m_report.result.number_of_unprojected_vertices; m_report.has_function() && number > 0)
      add("vertices off the surface",
          std::to_string(number) + ": no way leads there, or the last step would fold a face or make it intersect others");
    add_warnings();
    return std::move(m_lines);
  }

private:
  void add(const std::string& name, const std::string& text) { m_lines.push_back({name, text}); }

  // a length, relative to the diagonal
  std::string relative(const double length) const { return number(length / m_report.diagonal, 3) + " D"; }

  void add_faces()
  {
    std::string text = std::to_string(m_report.after.topology.number_of_faces);
    if (m_report.number_of_target_faces)
      text += ", about " + std::to_string(*m_report.number_of_target_faces) +
              (m_report.error ? " at most were asked for" : " were asked for");
    add("faces", text + "; the input has " + std::to_string(m_report.before.topology.number_of_faces));
  }

  void add_distances()
  {
    const auto both = [this](const double rms, const double max)
    { return relative(rms) + " root mean square, " + relative(max) + " largest"; };
    if (!m_report.distance)
      return add("distance to the input", "not measured");
    add("distance to the input", both(m_report.distance->rms_from_first, m_report.distance->max_from_first));
    add("distance from the input", both(m_report.distance->rms_from_second, m_report.distance->max_from_second));
  }

  std::string about_error() const
  {
    const Hde::Remeshing_result& result = m_report.result;
    if (result.approximation_error <= *m_report.error * (1 + 1e-12))
      return "kept: the distance is " + relative(result.approximation_error) + " at most";
    if (result.binding_target == Hde::Target::NUMBER_OF_FACES)
      return "not kept: the number of faces was reached before";
    return "not kept: the function has no surface near some faces";
  }

  void add_worst_triangle()
  {
    const Hde::Shape_measures& shape = m_report.after.shape;
    std::string text = "aspect ratio " + fixed(shape.aspect_ratio_max, 3) + " (an equilateral triangle has 1)";
    if (shape.number_of_degenerate_faces > 0)
      text += "; " + std::to_string(shape.number_of_degenerate_faces) + " triangles have no area";
    add("worst triangle", text);
  }

  void add_warnings()
  {
    if (m_report.warnings.empty())
      add("warnings", "none");
    for (const std::string& warning : m_report.warnings)
      add(&warning == &m_report.warnings.front() ? "warnings" : "", warning);
  }

  const Report& m_report;
  std::vector<Verdict_line> m_lines;
};

} // namespace

std::vector<Verdict_line> verdict(const Report& report) { return Verdict(report).make(); }

} // namespace hde_remesh
