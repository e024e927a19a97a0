// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Report.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace hde_remesh {

namespace {

std::string text(const std::size_t count) { return std::to_string(count); }

std::string text(const std::optional<std::size_t>& count) { return count ? std::to_string(*count) : "-"; }

std::string number(const double value, const int digits)
{
  std::ostringstream stream;
  stream << std::setprecision(digits) << value;
  return stream.str();
}

std::string fixed(const double value, const int decimals)
{
  if (!std::isfinite(value) || std::abs(value) >= 1e6)
    return number(value, 4);
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals) << value;
  return stream.str();
}

// Rounded down, so that 100 % means all.
std::string percent(const double share) { return fixed(std::floor(share * 1e4 + 1e-6) / 100, 2) + " %"; }

class Table
{
public:
  Table(const Report& report, std::ostream& stream) : m_report(report), m_stream(stream) {}

  void print()
  {
    row("", "before", "after");
    print_topology(m_report.before.topology, m_report.after.topology);
    if (m_report.sharp)
      print_features(m_report.result.curves_before, m_report.result.curves_after);
    print_shape(m_report.before.shape, m_report.after.shape);
    if (m_report.before.of_function && m_report.after.of_function)
      print_by_function(*m_report.before.of_function, *m_report.after.of_function);
    print_surface();
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

  void print_topology(const Hde::Topology_measures& before, const Hde::Topology_measures& after)
  {
    row("vertices", text(before.number_of_vertices), text(after.number_of_vertices));
    row("faces", text(before.number_of_faces), text(after.number_of_faces));
    row("components", text(before.number_of_components), text(after.number_of_components));
    row("boundary loops", text(before.number_of_boundary_loops), text(after.number_of_boundary_loops));
    row("Euler characteristic", std::to_string(before.euler_characteristic), std::to_string(after.euler_characteristic));
    row("interior vertices with 6 edges", percent(before.valence_6_share), percent(after.valence_6_share));
  }

  void print_features(const Hde::Feature_curves& before, const Hde::Feature_curves& after)
  {
    row("regions between creases", text(m_report.result.number_of_regions), text(m_report.result.number_of_regions));
    row("feature curves, boundaries included", text(before.number_of_curves), text(after.number_of_curves));
    row("corners", text(before.number_of_corners), text(after.number_of_corners));
    row("length of the feature curves", number(before.length, 6), number(after.length, 6));
  }

  void print_shape(const Hde::Shape_measures& before, const Hde::Shape_measures& after)
  {
    row("aspect ratio q = R / 2r, mean", fixed(before.aspect_ratio_mean, 3), fixed(after.aspect_ratio_mean, 3));
    row("aspect ratio, 99th percentile", fixed(before.aspect_ratio_p99, 3), fixed(after.aspect_ratio_p99, 3));
    row("aspect ratio, largest", fixed(before.aspect_ratio_max, 3), fixed(after.aspect_ratio_max, 3));
    row("degenerate faces", text(before.number_of_degenerate_faces), text(after.number_of_degenerate_faces));
    row("folded edges", text(before.number_of_folded_edges), text(after.number_of_folded_edges));
  }

  void print_by_function(const Function_figures& before, const Function_figures& after)
  {
    if (m_report.has_6d_lengths)
      print_lengths(before.embedding, after.embedding, after.embedding_to_target);
    row("folded faces", text(before.embedding.number_of_folded_faces), text(after.embedding.number_of_folded_faces));
    print_alignment(before.alignment, after.alignment);
    print_zero_set(before, after);
  }

  void print_lengths(const Hde::Embedding_measures& before, const Hde::Embedding_measures& after,
                     const Hde::Embedding_measures& to_target)
  {
    row("6D edge length, mean m", number(before.edge_length_mean, 5), number(after.edge_length_mean, 5));
    row("6D edge lengths in [.7, 1.41] m", percent(before.share_within_sqrt_2), percent(after.share_within_sqrt_2));
    row("6D edge lengths in [.5, 1.5] m", percent(before.share_within_half), percent(after.share_within_half));
    row("6D edge length aimed at, l", "-", number(to_target.target_edge_length, 5));
    row("6D edge lengths in [.7, 1.41] l", "-", percent(to_target.share_within_sqrt_2));
    row("least 6D angle of a face, mean, degrees", fixed(before.minimum_angle_mean, 2), fixed(after.minimum_angle_mean, 2));
    row("least 6D angle of all", fixed(before.minimum_angle_least, 2), fixed(after.minimum_angle_least, 2));
  }

  void print_alignment(const Hde::Alignment_measures& before, const Hde::Alignment_measures& after)
  {
    const auto angle = [](const Hde::Alignment_measures& m)
    { return m.number_of_faces > 0 ? fixed(m.angle_mean, 2) : std::string("-"); };
    row("stretched faces where the curvatures differ", text(before.number_of_faces), text(after.number_of_faces));
    row("their angle to the flatter direction, mean, degrees", angle(before), angle(after));
  }

  void print_zero_set(const Function_figures& before, const Function_figures& after)
  {
    const auto both = [&](const std::string& name, const double of_before, const double of_after)
    { row(name, relative(of_before), relative(of_after)); };
    both("interior vertices to the zero set, largest", before.zero_set.interior_vertex_max, after.zero_set.interior_vertex_max);
    both("boundary vertices to the zero set, largest", before.zero_set.boundary_vertex_max, after.zero_set.boundary_vertex_max);
    both("faces to the zero set, rms", before.zero_set.face_rms, after.zero_set.face_rms);
    both("faces to the zero set, largest", before.zero_set.face_max, after.zero_set.face_max);
    // how much further than the best mesh of as many faces with vertices on the surface
    const auto over_bound = [](const double distance, const double bound)
    { return bound > 0 ? fixed(distance / bound, 2) : std::string("-"); };
    row("rms over the least possible, asymptotically", over_bound(before.zero_set.face_rms, before.bounds.rms_on_surface),
        over_bound(after.zero_set.face_rms, after.bounds.rms_on_surface));
    row("largest distance over the least possible", over_bound(before.zero_set.face_max, before.bounds.max_on_surface),
        over_bound(after.zero_set.face_max, after.bounds.max_on_surface));
  }

  void print_surface()
  {
    const Figures &before = m_report.before, &after = m_report.after;
    if (before.self_intersections || after.self_intersections)
      row("pairs of faces that intersect", text(before.self_intersections), text(after.self_intersections));
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
      m_stream << "noise of the vertices, standard deviation: " << number(noise / m_report.diagonal, 3) << " D\n";
  }

  const Report& m_report;
  std::ostream& m_stream;
};

} // namespace

void print_table(const Report& report, std::ostream& stream) { Table(report, stream).print(); }

} // namespace hde_remesh
