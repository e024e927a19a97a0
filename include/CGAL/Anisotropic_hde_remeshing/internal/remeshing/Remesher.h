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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Operation_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Local_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Vertex_projector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Error_target.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_updater.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The second of the paper's two steps: makes the mesh uniform and isotropic in the embedding by local operations.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Intersections>
class Remesher
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef Operation_guard<Mesh, typename Projection::Function, Intersections> Guard;
  typedef Error_target<ConcurrencyTag, Mesh, typename Projection::Function> Error_of_mesh;
  typedef Local_operations<ConcurrencyTag, Embedding, Projection, Guard> Operations;
  typedef Vertex_projector<ConcurrencyTag, Embedding, Projection, Guard> Projector;

  // These are only bounds: passes stop when next to nothing is left to do, because a split halves an edge and a contraction
  // shortens none.
  static constexpr int maximum_number_of_split_passes = 40;
  static constexpr int maximum_number_of_collapse_passes = 40;
  static constexpr int maximum_number_of_paper_rounds = 20;
  static constexpr int maximum_number_of_error_rounds = 16;
  static constexpr double largest_deviation = 1.5; // of a face's centroid during the remeshing, over the error
  // of the number of faces asked for, or of that of the mesh if it is larger; needles without area always have edges that are too long
  static constexpr double largest_growth_of_splits = 4;
  static constexpr double largest_growth_of_refinement = 8; // of the number of faces; it ends a hopeless refinement

  // The default scheme aims alternately at a little fewer and a little more faces than asked for, and flips edges towards
  // valence six. So it contracts and splits edges where the mesh is least regular. This anneals the connectivity: on an
  // ellipsoid the share of valence six rises from 73 to 81%, the mean of the smallest angles from 51.6 to 53.7 degrees. The
  // last iterations settle at the number asked for, and flip towards larger angles.
  static constexpr double alternation = 0.07;
  // A mesh with little to split or contract may be a grid of right triangles, where no operation finds anything to do. So the
  // first iteration disturbs it by more. The mean of the smallest angles of a torus of 131,072 faces is 50.8 degrees without
  // this and 53.5 with it; of an ellipsoid from 81,920 to 40,000 faces 51.3 and 53.5. To refine a mesh disturbs it enough.
  static constexpr double first_alternation = 0.4;
  static constexpr double largest_ratio_to_right_number = 2.5, smallest_ratio_to_right_number = 0.67;
  static constexpr unsigned int settling_share = 6; // one iteration in this many settles, rounded up
  // When a mesh is coarsened, the edges that the thresholds leave are shorter than the target on average. So the length to
  // which the thresholds refer starts larger by this factor. Later it follows the number of faces that results.
  static constexpr double first_length_factor = 1.05;
  static constexpr double feedback = 0.25;
  static constexpr double largest_feedback_ratio = 1.3;
  // Creases may keep more vertices than the mesh shall have. The rest of the mesh is not given up for them: the length stays
  // near the one that the area asks for. Contractions that only serve the number of faces are left out if this number is too
  // large by more than this ratio.
  static constexpr double largest_length_factor_with_creases = 1.2, largest_ratio_with_creases = 1.1;
  static constexpr double largest_miss = 0.01; // of the number of faces asked for
  // contractions that only serve the number of faces may make longer edges while the mesh settles
  static constexpr double longest_of_settling = 1.4;

public:
  Remesher(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
           Intersections& intersections, const Remeshing_parameters& parameters, const double diagonal,
           const Visitor_reference visitor, Interruption& interruption, Remeshing_result& result)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_projection(projection),
      m_parameters(parameters),
      m_diagonal(diagonal),
      m_has_creases(curves.bounds_deviation()),
      m_visitor(visitor),
      m_interruption(interruption),
      m_result(result),
      m_guard(mesh, projection.function(), projection.unit(), intersections),
      m_operations(mesh, embedding, projection, curves, m_guard, interruption, result),
      m_projector(mesh, embedding, projection, curves, m_guard, result)
  {
  }

  // Updates the target length, and a metric that follows from the curvature, to the mesh. The bounds of the metric refer to the
  // target length. As long as there is none, the metric has no bounds.
  void update(Target_length& target)
  {
    if constexpr (is_metric<Embedding>)
      Metric_updater<ConcurrencyTag, Mesh, Embedding>(m_mesh, m_embedding, m_diagonal, target.length(), m_interruption)();
    target.template update<ConcurrencyTag>(m_mesh, m_embedding);
  }

  // aims at the number of faces that the error seems to ask for, at most that of `target`
  void start_from_error(Target_length& target)
  {
    m_largest_number_of_faces = target.number_of_faces();
    limit_number_of_faces(error_of_mesh().first_number_of_faces(), target);
  }

  void project_input() { m_projector.project_input(m_interruption); }

  // requires that `target` is up to date
  void run(Target_length target)
  {
    const unsigned int n = m_parameters.number_of_iterations;
    for (m_iteration = 0; m_iteration < n && go_further(); ++m_iteration)
    {
      if (m_parameters.scheme == Remeshing_scheme::PAPER)
        iterate_as_the_paper(target);
      else
        iterate(target);
      m_result.number_of_iterations = m_iteration + 1;
      if (!go_further())
        break;
      if (m_iteration == 0)
        reorder(); // most of the final vertices exist by now
      update(target);
      if (m_parameters.error > 0)
        approach_error(target);
      report(1);
    }
    m_result.target_edge_length = target.length();
    if (!m_projector.project_exactly(m_interruption)) // interrupted: project only the few that are not exact
    {
      Interruption never;
      const auto is_due = [&](const Vertex_index v)
      { return !m_projection.is_exact(m_mesh.point(v)) || m_mesh.point(v).is_on_input; };
      m_projector.project_exactly(is_due, never);
    }
    if (m_interruption.is_requested())
    {
      m_result.approximation_error = m_parameters.error > 0 ? (std::numeric_limits<double>::infinity)() : 0;
      return;
    }
    if (n > 0)
      flip(Flip_criterion::ANGLE);
    if (m_parameters.fit_to_surface)
      m_projector.fit(m_interruption);
    if (m_parameters.error > 0)
    {
      if (n > 0)
        refine_to_error();
      else
        measure_error();
    }
    else if (n > 0 && m_result.binding_target == Target::NUMBER_OF_FACES)
      m_result.binding_target = binding_target(target.number_of_faces());
  }

private:
  // what kept the mesh from the number of faces; that number itself if the mesh has reached it
  Target binding_target(const double number_of_faces) const
  {
    const double tolerance = (std::max)(largest_miss * number_of_faces, 2.); // a split adds two faces
    if (!(std::abs(double(m_mesh.number_of_faces()) - number_of_faces) > tolerance))
      return Target::NUMBER_OF_FACES;
    std::size_t number_at_curves = 0;
    for (const Face_index f : m_mesh.faces())
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      number_at_curves += is_kept(t.a) || is_kept(t.b) || is_kept(t.c);
    }
    return 2 * number_at_curves > m_mesh.number_of_faces() ? Target::FEATURE_CURVES : Target::GUARDS;
  }

  bool is_kept(const Vertex_index v) const { return m_mesh.point(v).is_on_curve || m_mesh.point(v).is_fixed; }

  void reorder()
  {
    reorder_in_space<ConcurrencyTag>(m_mesh, m_interruption);
    m_guard.template update_all<ConcurrencyTag>(m_interruption);
  }

  Error_of_mesh error_of_mesh() const
  {
    return Error_of_mesh(m_mesh, m_projection.function(), m_projection.input(), m_projection.unit(), m_parameters.error,
                         m_interruption);
  }

  void limit_number_of_faces(const double wanted, Target_length& target)
  {
    m_result.binding_target = wanted < m_largest_number_of_faces ? Target::APPROXIMATION_ERROR : Target::NUMBER_OF_FACES;
    const double number_of_faces = (std::max)((std::min)(wanted, m_largest_number_of_faces), 4.);
    target.set_number_of_faces(number_of_faces);
    // where the number binds, the error cannot be kept
    m_guard.set_largest_distance(wanted > m_largest_number_of_faces ? (std::numeric_limits<double>::infinity)()
                                                                    : largest_deviation * m_parameters.error);
  }

  void approach_error(Target_length& target)
  {
    if (is_settling())
      return; // the last iterations settle at a number
    limit_number_of_faces(error_of_mesh().factor_of_number_of_faces() * double(m_mesh.number_of_faces()), target);
    target.template update<ConcurrencyTag>(m_mesh, m_embedding);
  }

  // Without an iteration the vertices are only projected. Then the error is measured, but the mesh is not refined.
  void measure_error()
  {
    Error_of_mesh error = error_of_mesh();
    error.failing_faces();
    m_result.approximation_error =
        m_interruption.is_requested() ? (std::numeric_limits<double>::infinity)() : error.largest_bound();
    m_result.binding_target =
        m_result.approximation_error <= m_parameters.error ? Target::APPROXIMATION_ERROR : Target::NUMBER_OF_FACES;
  }

  // Splits edges of the faces that exceed the error, until no face does or the mesh has as many faces as allowed. Each round
  // halves edges and so quarters their errors. A measurement comes last.
  void refine_to_error()
  {
    const double largest_number_of_faces =
        (std::min)(m_largest_number_of_faces, largest_growth_of_refinement * double(m_mesh.number_of_faces()));
    Error_of_mesh error = error_of_mesh();
    for (int round = 0; go_further(); ++round)
    {
      std::vector<Edge_index> edges = edges_to_split(error.failing_faces());
      m_result.approximation_error = error.largest_bound();
      const double room =
          (std::min)((largest_number_of_faces - double(m_mesh.number_of_faces())) / 2, // an edge splits two faces
                     room_for_splits(m_mesh.num_halfedges()));
      if (!edges.empty() && room < 1 && largest_number_of_faces == m_largest_number_of_faces)
        m_result.binding_target = Target::NUMBER_OF_FACES;
      if (edges.empty() || room < 1 || round == maximum_number_of_error_rounds)
        break;
      if (double(edges.size()) > room)
        edges.resize(std::size_t(room));
      refine(edges);
    }
    if (m_interruption.is_requested()) // not all faces have been measured
      m_result.approximation_error = (std::numeric_limits<double>::infinity)();
  }

  // Splits the edges and puts the new vertices exactly on the surface. The other vertices do not move, because their faces have
  // passed.
  void refine(const std::vector<Edge_index>& edges)
  {
    std::vector<char> is_old(vertex_capacity(m_mesh) + edges.size(), 0);
    for (const Vertex_index v : m_mesh.vertices())
      is_old[v] = 1;
    m_operations.split(edges);
    m_operations.flip(Flip_criterion::ANGLE);
    const auto is_new = [&](const Vertex_index v) { return !is_old[v]; };
    if (!m_projector.project_exactly(is_new, m_interruption)) // interrupted, but they are on the surface only roughly
    {
      Interruption never;
      m_projector.project_exactly(is_new, never);
    }
  }

  // The longest edge in the embedding of each face; the next one if that could not be split. Each edge comes once, in the order
  // of the mesh.
  std::vector<Edge_index> edges_to_split(const std::vector<typename Error_of_mesh::Failing_face>& faces) const
  {
    std::vector<Edge_index> edges;
    for (const auto& failing : faces)
    {
      std::array<std::pair<double, Edge_index>, 3> sides;
      std::size_t k = 0;
      for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(failing.face)))
        sides[k++] = {-squared_length(m_mesh.edge(h), m_mesh, m_embedding), m_mesh.edge(h)};
      std::sort(sides.begin(), sides.end());
      edges.push_back(sides[std::size_t(failing.attempt % 3)].second);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  // the default scheme
  void iterate(const Target_length& target)
  {
    const double number_of_faces = target.number_of_faces() * alternating_factor(target.number_of_faces());
    const double length = m_length_factor * target.length() * std::sqrt(target.number_of_faces() / number_of_faces);
    if (m_iteration == 0 && number_of_faces_after_splits(length) > largest_number_of_faces(number_of_faces))
      m_operations.collapse(m_parameters.collapse_ratio * length, (std::numeric_limits<double>::infinity)());
    split(length, number_of_faces);
    report(0.2);
    collapse(length);
    if (m_iteration > 0 || is_settling())
      approach_number_of_faces(number_of_faces, length);
    report(0.3);
    const Flip_criterion criterion = is_settling() ? Flip_criterion::ANGLE : Flip_criterion::VALENCE;
    const unsigned int steps = m_parameters.number_of_relaxation_steps;
    for (unsigned int step = 0; step < steps; ++step)
    {
      flip(criterion);
      smooth(step + 1 < steps ? Smoothing_step::PREDICT : Smoothing_step::PROJECT);
      report(0.3 + 0.7 * (step + 1) / (steps + 1));
    }
    flip(criterion);
  }

  // Algorithm 2 of the paper
  void iterate_as_the_paper(const Target_length& target)
  {
    // In the paper the length is given. If the number of faces is given, the length must follow the number that results.
    const double length = target.is_length_given() ? target.length() : m_length_factor * target.length();
    bool is_any_contracted = true;
    for (int round = 0; is_any_contracted && round < maximum_number_of_paper_rounds && go_further(); ++round)
    {
      const std::size_t before = m_result.number_of_collapses;
      collapse(length);
      is_any_contracted = m_result.number_of_collapses > before;
      smooth();
      flip(Flip_criterion::ANGLE);
    }
    report(0.5);
    split(length, target.number_of_faces());
    if (m_iteration > 0 && !target.is_length_given())
      approach_number_of_faces(target.number_of_faces(), length);
    flip(Flip_criterion::ANGLE);
    smooth();
    flip(Flip_criterion::ANGLE);
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

  unsigned int number_of_settling_iterations() const
  {
    return (m_parameters.number_of_iterations + settling_share - 1) / settling_share;
  }

  bool is_settling() const { return m_iteration + number_of_settling_iterations() >= m_parameters.number_of_iterations; }

  // the last alternation aims at fewer faces: that measures better than more
  double alternating_factor(const double number_of_faces) const
  {
    if (is_settling())
      return 1;
    const double ratio = double(m_mesh.number_of_faces()) / number_of_faces;
    if (m_iteration == 0 && ratio < largest_ratio_to_right_number && ratio > smallest_ratio_to_right_number)
      return 1 + first_alternation;
    const unsigned int to_go = m_parameters.number_of_iterations - number_of_settling_iterations() - m_iteration;
    return to_go % 2 == 0 ? 1 + alternation : 1 - alternation;
  }

  // Makes up for what the thresholds leave of the way to the number of faces. It contracts the shortest edges or splits the
  // longest ones, two faces for each edge.
  void approach_number_of_faces(const double number_of_faces, const double length)
  {
    const double ratio = double(m_mesh.number_of_faces()) / number_of_faces;
    if (!is_settling())
      m_length_factor *= std::pow((std::min)((std::max)(ratio, 1 / largest_feedback_ratio), largest_feedback_ratio), feedback);
    if (m_has_creases && m_parameters.scheme == Remeshing_scheme::DEFAULT)
    {
      m_length_factor = (std::min)(m_length_factor, largest_length_factor_with_creases);
      if (ratio > largest_ratio_with_creases)
        return;
    }
    const double longest = is_settling() ? longest_of_settling : m_parameters.split_ratio;
    // where the mesh is very regular, the guards refuse most of the edges: the bounds are widened while it settles
    for (const double factor : {1., 1.15, 1.3})
    {
      const double excess = double(m_mesh.number_of_faces()) - number_of_faces;
      if (excess >= 2)
        m_operations.collapse(factor * length, factor * longest * length, std::size_t(excess / 2));
      else if (excess <= -2)
        m_operations.split(length / factor, std::size_t(-excess / 2));
      if (!is_settling())
        break;
    }
  }

  bool go_further() { return !m_interruption.ask(); }

  void report(const double share_of_iteration)
  {
    m_visitor.progress((m_iteration + share_of_iteration) / m_parameters.number_of_iterations);
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Remeshing_parameters m_parameters;
  const double m_diagonal; // of the mesh
  const bool m_has_creases;
  const Visitor_reference m_visitor;
  Interruption& m_interruption;
  Remeshing_result& m_result;
  Guard m_guard;
  Operations m_operations;
  Projector m_projector;
  unsigned int m_iteration = 0;
  double m_length_factor = first_length_factor;
  double m_largest_number_of_faces = 0; // with an error as the target
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHER_H
