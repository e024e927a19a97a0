// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "table_rows.h"
#include "number_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace hde_remesh {

namespace {

std::string text(const std::size_t count) { return std::to_string(count); }

std::string text(const std::optional<std::size_t>& count) { return count ? std::to_string(*count) : "-"; }

// Rounded down, so that 100 % means all.
std::string percent(const double share) { return fixed(std::floor(share * 1e4 + 1e-6) / 100, 2) + " %"; }

class Rows
{
public:
  explicit Rows(const Report& report) : m_report(report) {}

  std::vector<Table_row> make()
  {
    add_topology(m_report.before.topology, m_report.after.topology);
    if (m_report.sharp)
      add_features(m_report.result.curves_before, m_report.result.curves_after);
    add_shape(m_report.before.shape, m_report.after.shape);
    if (m_report.before.of_function && m_report.after.of_function)
      add_by_function(*m_report.before.of_function, *m_report.after.of_function);
    add_surface();
    return std::move(m_rows);
  }

private:
  void row(const std::string& name, const std::string& before, const std::string& after, const int rank = 0)
  {
    m_rows.push_back({name, before, after, rank});
  }

  // a length, relative to the diagonal
  std::string relative(const double length, const int digits = 3) const
  {
    return number(length / m_report.diagonal, digits) + " D";
  }

  void add_topology(const Hde::Topology_measures& before, const Hde::Topology_measures& after)
  {
    row("vertices", text(before.number_of_vertices), text(after.number_of_vertices), 1);
    row("faces", text(before.number_of_faces), text(after.number_of_faces), 1);
    row("components", text(before.number_of_components), text(after.number_of_components), 1);
    row("boundary loops", text(before.number_of_boundary_loops), text(after.number_of_boundary_loops), 1);
    row("Euler characteristic", std::to_string(before.euler_characteristic), std::to_string(after.euler_characteristic), 1);
    row("interior vertices with 6 edges", percent(before.valence_6_share), percent(after.valence_6_share));
  }

  void add_features(const Hde::Feature_curves& before, const Hde::Feature_curves& after)
  {
    row("regions between creases", text(m_report.result.number_of_regions), text(m_report.result.number_of_regions), 2);
    row("feature curves, boundaries included", text(before.number_of_curves), text(after.number_of_curves), 2);
    row("corners", text(before.number_of_corners), text(after.number_of_corners), 2);
    row("length of the feature curves", relative(before.length, 6), relative(after.length, 6));
  }

  void add_shape(const Hde::Shape_measures& before, const Hde::Shape_measures& after)
  {
    row("aspect ratio q = R / 2r, mean", fixed(before.aspect_ratio_mean, 3), fixed(after.aspect_ratio_mean, 3), 5);
    row("aspect ratio, 99th percentile", fixed(before.aspect_ratio_p99, 3), fixed(after.aspect_ratio_p99, 3));
    row("aspect ratio, largest", fixed(before.aspect_ratio_max, 3), fixed(after.aspect_ratio_max, 3));
    row("degenerate faces", text(before.number_of_degenerate_faces), text(after.number_of_degenerate_faces), 5);
    row("folded edges", text(before.number_of_folded_edges), text(after.number_of_folded_edges), 3);
  }

  void add_by_function(const Function_figures& before, const Function_figures& after)
  {
    if (m_report.has_6d_lengths)
      add_lengths(before.embedding, after.embedding, after.embedding_to_target);
    row("folded faces", text(before.embedding.number_of_folded_faces), text(after.embedding.number_of_folded_faces), 3);
    add_alignment(before.alignment, after.alignment);
    add_zero_set(before, after);
  }

  void add_lengths(const Hde::Embedding_measures& before, const Hde::Embedding_measures& after,
                   const Hde::Embedding_measures& to_target)
  {
    row("6D edge length, mean m", relative(before.edge_length_mean, 4), relative(after.edge_length_mean, 4));
    row("6D edge lengths in [.7, 1.41] m", percent(before.share_within_sqrt_2), percent(after.share_within_sqrt_2));
    row("6D edge lengths in [.5, 1.5] m", percent(before.share_within_half), percent(after.share_within_half));
    row("6D edge length aimed at, l", "-", relative(to_target.target_edge_length, 4));
    row("6D edge lengths in [.7, 1.41] l", "-", percent(to_target.share_within_sqrt_2), 4);
    row("least 6D angle of a face, mean, degrees", fixed(before.minimum_angle_mean, 2), fixed(after.minimum_angle_mean, 2));
    row("least 6D angle of all", fixed(before.minimum_angle_least, 2), fixed(after.minimum_angle_least, 2));
  }

  void add_alignment(const Hde::Alignment_measures& before, const Hde::Alignment_measures& after)
  {
    const auto angle = [](const Hde::Alignment_measures& m)
    { return m.number_of_faces > 0 ? fixed(m.angle_mean, 2) : std::string("-"); };
    row("stretched faces where the curvatures differ", text(before.number_of_faces), text(after.number_of_faces));
    row("their angle to the flatter direction, mean, degrees", angle(before), angle(after));
  }

  void add_zero_set(const Function_figures& before, const Function_figures& after)
  {
    const auto both = [&](const std::string& name, const double of_before, const double of_after)
    { row(name, relative(of_before), relative(of_after)); };
    both("interior vertices to the zero set, largest", before.zero_set.interior_vertex_max, after.zero_set.interior_vertex_max);
    both("boundary vertices to the zero set, largest", before.zero_set.boundary_vertex_max, after.zero_set.boundary_vertex_max);
    row("faces to the zero set, rms", relative(before.zero_set.face_rms), relative(after.zero_set.face_rms), 4);
    both("faces to the zero set, largest", before.zero_set.face_max, after.zero_set.face_max);
    // how much further than the best mesh of as many faces with vertices on the surface
    const auto over_bound = [](const double distance, const double bound)
    { return bound > 0 ? fixed(distance / bound, 2) : std::string("-"); };
    row("rms over the least possible, asymptotically", over_bound(before.zero_set.face_rms, before.bounds.rms_on_surface),
        over_bound(after.zero_set.face_rms, after.bounds.rms_on_surface));
    row("largest distance over the least possible", over_bound(before.zero_set.face_max, before.bounds.max_on_surface),
        over_bound(after.zero_set.face_max, after.bounds.max_on_surface));
  }

  void add_surface()
  {
    const Figures &before = m_report.before, &after = m_report.after;
    if (before.self_intersections || after.self_intersections)
      row("pairs of faces that intersect", text(before.self_intersections), text(after.self_intersections), 3);
    if (m_report.error)
      row(m_report.has_function() ? "bound on the distance, without curves" : "bound on the distance, both ways", "-",
          relative(m_report.result.approximation_error));
    if (!m_report.distance)
      return;
    const Hde::Distance_measures& distance = *m_report.distance;
    row("distance to the input, rms", "-", relative(distance.rms_from_first));
    row("distance to the input, largest", "-", relative(distance.max_from_first));
    row("distance from the input, rms", "-", relative(distance.rms_from_second));
    row("distance from the input, largest", "-", relative(distance.max_from_second));
  }

  const Report& m_report;
  std::vector<Table_row> m_rows;
};

} // namespace

std::vector<Table_row> table_rows(const Report& report) { return Rows(report).make(); }

std::vector<Table_row> most_important_rows(const std::vector<Table_row>& rows, const std::size_t number)
{
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].rank > 0)
      chosen.push_back(i);
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](const std::size_t i, const std::size_t j) { return rows[i].rank < rows[j].rank; });
  chosen.resize((std::min)(chosen.size(), number));
  std::sort(chosen.begin(), chosen.end());
  std::vector<Table_row> result;
  for (const std::size_t i : chosen)
    result.push_back(rows[i]);
  return result;
}

} // namespace hde_remesh
