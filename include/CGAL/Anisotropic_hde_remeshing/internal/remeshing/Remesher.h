// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_scheme.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remeshing_report.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Operation_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/expected_heights.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/write_stage.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Local_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Vertex_projector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Error_control.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Iteration_plan.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_updater.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/what_binds.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The second of the paper's two steps: makes the mesh uniform and isotropic in the embedding by local operations.
template <typename ConcurrencyTag, typename Embedding, typename Projection>
class Remesher
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef Operation_guard<Mesh, typename Projection::Function> Guard;
  typedef Local_operations<ConcurrencyTag, Embedding, Projection, Guard> Operations;
  typedef Vertex_projector<ConcurrencyTag, Embedding, Projection, Guard> Projector;

  // These are only bounds: passes stop when next to nothing is left to do, because a split halves an edge and a contraction
  // shortens none.
  static constexpr int maximum_number_of_split_passes = 40;
  static constexpr int maximum_number_of_collapse_passes = 40;
  static constexpr int maximum_number_of_paper_rounds = 20;
  // of the number of faces asked for, or of that of the mesh if it is larger; needles without area always have edges that are too long
  static constexpr double largest_growth_of_splits = 4;
  // Contractions that only serve the number of faces are left out if creases make this number too large by more than this
  // ratio.
  static constexpr double largest_ratio_with_creases = 1.1;
  // contractions that only serve the number of faces may make longer edges while the mesh settles
  static constexpr double longest_of_settling = 1.4;

public:
  Remesher(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
           Mesh_intersections<Mesh>& intersections, const Remeshing_parameters& parameters, const Visitor_reference visitor)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_projection(projection),
      m_parameters(parameters),
      m_has_creases(curves.bounds_deviation()),
      m_visitor(visitor),
      m_interruption(visitor.interruption()),
      m_intersections(intersections),
      m_guard(mesh, projection.function(), intersections),
      m_operations(mesh, embedding, projection, curves, m_guard, parameters.allowed, m_interruption),
      m_projector(mesh, embedding, projection, curves, m_guard),
      m_error(mesh, embedding, projection, m_guard, m_operations, m_projector, parameters.error,
              parameters.target.number_of_faces(), m_interruption),
      m_target(parameters.target),
      m_plan(parameters.number_of_iterations)
  {
  }

  void project_input()
  {
    write_stage(m_mesh, "input");
    m_projector.project_input(m_interruption);
    write_stage(m_mesh, "projected");
  }

  // Finds the target length, and the metric where the embedding is one. Throws Too_many_faces.
  void find_target()
  {
    if (m_error.is_active())
      m_error.start(m_target);
    update_target();
    if (is_metric<Embedding>)
      update_target(); // now the metric has its bounds
    check_number_of_faces(m_target);
  }

  // Requires that the target is found. Stops before the end if it is worth to begin again, as more faces intersect than before.
  void run()
  {
    keep_landmarks();
    for (m_is_finished = false; !m_is_finished && !m_intersections.is_to_restart();)
    {
      const unsigned int end = m_plan.iterations_at_next_check(m_intersections.has_near_sheets());
      if (m_intersections.has_near_sheets())
      {
        const State state(*this);
        m_intersections.template keep_pairs<ConcurrencyTag>([&] { iterate_until(end); }, [&] { return_to(state); },
                                                            m_interruption);
      }
      else // that they intersect is so rare that the memory for a copy is not worth it
      {
        iterate_until(end);
        if (!m_interruption.is_requested()) // who stops does not want to wait
          m_intersections.template count_pairs<ConcurrencyTag>();
      }
    }
  }

  // what was done; requires that the mesh is remeshed
  const Remeshing_report& report() const { return m_report; }

private:
  // what changes from iteration to iteration
  struct State
  {
    explicit State(const Remesher& r) : guard(r.m_guard.state()), target(r.m_target), plan(r.m_plan), report(r.m_report)
    {
      mesh = r.m_mesh;
    }

    Mesh mesh;
    typename Guard::State guard;
    Target_length target;
    Iteration_plan plan;
    Remeshing_report report;
  };

  void return_to(const State& state)
  {
    m_mesh = state.mesh;
    m_guard.return_to(state.guard);
    m_target = state.target;
    m_plan = state.plan;
    m_report = state.report;
    m_projector.forget_unprojected();
  }

  // does iterations until so many are done, and finishes if these are all
  void iterate_until(const unsigned int end)
  {
    for (; m_plan.iteration() < end && go_further(); m_plan.advance())
    {
      if (m_parameters.scheme == Remeshing_scheme::PAPER)
        iterate_as_the_paper();
      else
        iterate();
      m_report.number_of_iterations = m_plan.iteration() + 1;
      if (!go_further())
        break;
      if (m_plan.is_first())
        reorder(); // most of the final vertices exist by now
      update_target();
      scale_landmarks();
      if (m_error.is_active() && !m_plan.is_settling()) // the last iterations settle at a number
        m_error.approach(m_target);
      report_progress(1);
    }
    m_is_finished = m_plan.is_done() || m_interruption.is_requested();
    if (m_is_finished)
      finish();
  }

  // Nothing may be lost that the target length does not explain: distances grow with its square.
  void keep_landmarks()
  {
    if (m_plan.is_done())
      return;
    m_length_of_landmarks = m_target.length();
    m_guard.keep_landmarks(expected_heights<ConcurrencyTag>(m_mesh, m_embedding, m_target.length()),
                           m_projection.input().diagonal());
  }

  void scale_landmarks()
  {
    const double ratio = m_target.length() / m_length_of_landmarks;
    m_guard.scale_landmarks(ratio * ratio);
  }

  // Updates the target length, and a metric that follows from the curvature, to the mesh. The bounds of the metric refer to the
  // target length. As long as there is none, the metric has no bounds.
  void update_target()
  {
    if constexpr (is_metric<Embedding>)
      Metric_updater<ConcurrencyTag, Mesh, Embedding>(m_mesh, m_embedding, m_projection.input().diagonal(), m_target.length(),
                                                      m_interruption)();
    m_target.template update<ConcurrencyTag>(m_mesh, m_embedding);
  }

  // puts all vertices on the surface or, if asked for, where the faces fit it best, and sees to the error
  void finish()
  {
    project_exactly();
    write_stage(m_mesh, "exact");
    const bool is_remeshed = m_parameters.number_of_iterations > 0;
    if (m_interruption.is_requested())
      m_error.give_up();
    else
    {
      if (is_remeshed)
      {
        flip(Flip_criterion::ANGLE);
        m_projector.project_rest();
      }
      if (m_parameters.fit_to_surface)
        m_projector.fit(m_interruption);
      if (m_error.is_active())
        is_remeshed ? m_error.refine() : m_error.measure();
    }
    write_stage(m_mesh, "finished");
    m_report.target_length = m_target.length();
    m_report.error = m_error.bound();
    m_report.binding_target = binding_target();
    m_report.number_of_unprojected_vertices = m_projector.number_of_unprojected_vertices();
    m_report.operations = m_operations.statistics();
  }

  void project_exactly()
  {
    if (m_projector.project_exactly(m_interruption))
      return;
    Interruption never; // interrupted: project only the few that are not exact
    const auto is_due = [&](const Vertex_index v)
    { return !m_projection.is_exact(m_mesh.point(v)) || m_mesh.point(v).is_on_input; };
    m_projector.project_exactly(is_due, never);
  }

  // what decided on the number of faces, or kept the mesh from it
  Target binding_target() const
  {
    if (m_error.is_active())
      return m_error.binding_target();
    if (m_target.is_length_given())
      return Target::EDGE_LENGTH;
    const double number_of_faces = m_target.number_of_faces();
    if (m_parameters.number_of_iterations == 0 || m_interruption.is_requested())
      return Target::NUMBER_OF_FACES;
    return what_binds(m_mesh, number_of_faces);
  }

  void reorder()
  {
    const std::vector<Face_index> new_faces = reorder_in_space<ConcurrencyTag>(m_mesh, m_interruption);
    if (!new_faces.empty())
      m_guard.renumber_landmarks(new_faces);
    m_guard.template update_all<ConcurrencyTag>();
  }

  // the number of faces over the one aimed at
  double ratio_to(const double number_of_faces) const { return double(m_mesh.number_of_faces()) / number_of_faces; }

  // the default scheme
  void iterate()
  {
    const double number_of_faces = m_target.number_of_faces() * m_plan.alternating_factor(ratio_to(m_target.number_of_faces()));
    const double length = m_plan.length_factor() * m_target.length() * std::sqrt(m_target.number_of_faces() / number_of_faces);
    if (m_plan.is_first() && number_of_faces_after_splits(length) > largest_number_of_faces(number_of_faces))
      m_operations.collapse(m_parameters.collapse_ratio * length, (std::numeric_limits<double>::infinity)());
    split(length, number_of_faces);
    write_stage(m_mesh, "split");
    report_progress(0.2);
    collapse(length);
    if (!m_plan.is_first() || m_plan.is_settling())
      approach_number_of_faces(number_of_faces, length);
    write_stage(m_mesh, "contracted");
    report_progress(0.3);
    const Flip_criterion criterion = m_plan.is_settling() ? Flip_criterion::ANGLE : Flip_criterion::VALENCE;
    const unsigned int steps = m_parameters.number_of_relaxation_steps;
    for (unsigned int step = 0; step < steps; ++step)
    {
      flip(criterion);
      smooth(step + 1 < steps ? Smoothing_step::PREDICT : Smoothing_step::PROJECT);
      report_progress(0.3 + 0.7 * (step + 1) / (steps + 1));
    }
    flip(criterion);
    write_stage(m_mesh, "smoothed");
  }

  // Algorithm 2 of the paper
  void iterate_as_the_paper()
  {
    // In the paper the length is given. If the number of faces is given, the length must follow the number that results.
    const double length = m_target.is_length_given() ? m_target.length() : m_plan.length_factor() * m_target.length();
    bool is_any_contracted = true;
    for (int round = 0; is_any_contracted && round < maximum_number_of_paper_rounds && go_further(); ++round)
    {
      const std::size_t before = m_operations.statistics().number_of_collapses;
      collapse(length);
      is_any_contracted = m_operations.statistics().number_of_collapses > before;
      smooth();
      flip(Flip_criterion::ANGLE);
    }
    write_stage(m_mesh, "contracted");
    report_progress(0.5);
    split(length, m_target.number_of_faces());
    if (!m_plan.is_first() && !m_target.is_length_given())
      approach_number_of_faces(m_target.number_of_faces(), length);
    flip(Flip_criterion::ANGLE);
    smooth();
    flip(Flip_criterion::ANGLE);
    write_stage(m_mesh, "smoothed");
  }

  // Whether there were so few splits or contractions that another pass over all edges is not worth it. The next iteration does
  // the rest.
  bool is_negligible(const std::size_t count) const { return 1000 * count <= m_mesh.number_of_edges(); }

  // how many faces splits may lead to, where a number is asked for
  double largest_number_of_faces(const double number_of_faces) const
  {
    return largest_growth_of_splits * (std::max)(number_of_faces, double(m_mesh.number_of_faces()));
  }

  // The number of faces if each edge were split alone. It is large for rows of needles, such as the sides of cylinders in CAD
  // exports. Such rows are to be contracted across first. That makes their long edges longer for a while.
  double number_of_faces_after_splits(const double length) const
  {
    const double longest = m_parameters.split_ratio * length;
    const double number_of_splits = parallel_sum<ConcurrencyTag>(
        edge_capacity(m_mesh),
        [&](const std::size_t i)
        {
          const Edge_index e(static_cast<Edge_index::size_type>(i));
          if (m_mesh.is_removed(e))
            return 0.;
          return (std::max)(std::ceil(std::sqrt(squared_length(e, m_mesh, m_embedding)) / longest) - 1, 0.);
        });
    return double(m_mesh.number_of_faces()) + 2 * number_of_splits;
  }

  void split(const double length, const double number_of_faces)
  {
    const double largest = largest_number_of_faces(number_of_faces);
    for (int pass = 0; pass < maximum_number_of_split_passes && go_further(); ++pass)
    {
      const double room = (std::min)((largest - double(m_mesh.number_of_faces())) / 2, // a split adds two faces
                                     room_for_splits(m_mesh.num_halfedges()));
      if (room < 1 || is_negligible(m_operations.split(m_parameters.split_ratio * length, std::size_t(room))))
        break;
    }
  }

  void collapse(const double length)
  {
    for (int pass = 0; pass < maximum_number_of_collapse_passes && go_further(); ++pass)
    {
      if (is_negligible(m_operations.collapse(m_parameters.collapse_ratio * length, m_parameters.split_ratio * length)))
        break;
    }
  }

  void flip(const Flip_criterion criterion)
  {
    if (go_further())
      m_operations.flip(criterion);
  }

  void smooth(const Smoothing_step kind = Smoothing_step::PROJECT)
  {
    if (go_further())
      m_operations.smooth(m_parameters.smoothing_ratio, kind);
  }

  // Makes up for what the thresholds leave of the way to the number of faces. It contracts the shortest edges or splits the
  // longest ones, two faces for each edge.
  void approach_number_of_faces(const double number_of_faces, const double length)
  {
    const double ratio = ratio_to(number_of_faces);
    m_plan.follow_number_of_faces(ratio);
    if (m_has_creases && m_parameters.scheme != Remeshing_scheme::PAPER)
    {
      m_plan.limit_length_by_creases();
      if (ratio > largest_ratio_with_creases)
        return;
    }
    if (!m_plan.is_settling())
    {
      approach_number_of_faces(number_of_faces, length, 1, m_parameters.split_ratio);
      return;
    }
    // where the mesh is very regular, the guards refuse most of the edges: the bounds are widened
    for (const bool is_regular : {false, true})
    {
      m_guard.expect_regular_mesh(is_regular);
      for (const double factor : {1., 1.15, 1.3})
        approach_number_of_faces(number_of_faces, length, factor, longest_of_settling);
    }
    m_guard.expect_regular_mesh(false);
  }

  // `factor` is that of the bounds, `longest` the longest edge that contractions may make, over the length
  void approach_number_of_faces(const double number_of_faces, const double length, const double factor, const double longest)
  {
    const double excess = double(m_mesh.number_of_faces()) - number_of_faces;
    if (excess >= 2)
      m_operations.collapse(factor * length, factor * longest * length, std::size_t(excess / 2));
    else if (excess <= -2)
      m_operations.split(length / factor, std::size_t(-excess / 2));
  }

  bool go_further() { return !m_interruption.ask(); }

  void report_progress(const double share_of_iteration) { m_visitor.progress(m_plan.progress(share_of_iteration)); }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Remeshing_parameters& m_parameters;
  const bool m_has_creases;
  const Visitor_reference m_visitor;
  Interruption& m_interruption;
  Mesh_intersections<Mesh>& m_intersections;
  Guard m_guard;
  Operations m_operations;
  Projector m_projector;
  Error_control<ConcurrencyTag, Embedding, Projection, Guard, Operations, Projector> m_error;
  Target_length m_target;
  Iteration_plan m_plan;
  bool m_is_finished = false;
  double m_length_of_landmarks = 0; // the target length for which their bounds are
  Remeshing_report m_report;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H
