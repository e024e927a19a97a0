// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_ERROR_REMESHER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_ERROR_REMESHER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Duration.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remeshing_report.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/vertex_normals.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/write_stage.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Bounded_coarsener.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Bounded_refiner.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_exchanger.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Error_fitter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Error_flipper.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Loss_coarsener.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Sampled_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Reference_samples.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Two_sided_check.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/distance_both_ways.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Remeshes by measured error, for meshes with fewer faces than the input. First edges are contracted in the order of what is
// lost. Then rounds follow. Each exchanges vertices, flips edges and moves the vertices where the distances are least.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Error_remesher
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;
  typedef typename Two_sided_check<ConcurrencyTag, Mesh>::Failing_face Failing_face;

  // How many samples there are at least: so many for a face of the result, but fewer if they are more than enough in all. Small
  // faces have about as many as large ones. That is worth twice the number of samples that are spread evenly.
  static constexpr double samples_per_face = 30, least_samples_per_face = 4, enough_samples = 150000;
  static constexpr double more_samples_for_error = 2; // times: where the largest distance counts, those between samples matter
  static constexpr double largest_number_of_samples = 1e9; // where this is many: their indices have 32 bits
  static constexpr double share_exchanged = 0.1;           // of the vertices, in a round
  static constexpr double share_of_coarsening = 0.3;       // of the progress that is told
  static constexpr int refinements_without_progress = 10;
  static constexpr double share_in_the_mean = 0.7; // of the distance that samples may have

public:
  // Samples stay below a share of the error, because between them the distance is larger.
  Error_remesher(Mesh& mesh, const Curve_network& curves, Guard& guard, const Input_surface& input,
                 const Remeshing_parameters& parameters, const Visitor_reference visitor, const double share_of_error)
    : m_mesh(mesh),
      m_curves(curves),
      m_guard(guard),
      m_input(input),
      m_parameters(parameters),
      m_visitor(visitor),
      m_interruption(visitor.interruption()),
      m_intersections(guard.intersections()),
      m_distance_of_samples(share_of_error * parameters.error),
      m_number_of_rounds(parameters.fit_to_surface ? 5 * parameters.number_of_iterations / 2 : parameters.number_of_iterations),
      m_price(parameters.shape_weight, parameters.aspect_ratio_bound)
  {
  }

  // Stops before the end if it is worth to begin again, as more faces intersect than before.
  void operator()()
  {
    write_stage(m_mesh, "input");
    const std::vector<Vertex_index> new_vertices = coarsen();
    write_stage(m_mesh, "coarsened");
    if (m_interruption.ask())
      return;
    m_intersections.template count_pairs<ConcurrencyTag>();
    if (m_intersections.is_to_restart())
      return;
    report_progress(0);
    Start start;
    if ((!keeps_error() && m_statistics.number_of_collapses == 0) || (compares_rounds() && is_exact(start)))
    {
      write_stage(m_mesh, "finished");
      return; // it is the input, or what that was split to
    }
    Mesh coarse; // to return to
    if (m_intersections.is_active())
      coarse = m_mesh;
    m_intersections.template keep_pairs<ConcurrencyTag>([&] { improve(new_vertices, start); }, [&] { m_mesh = coarse; },
                                                        m_interruption);
    write_stage(m_mesh, "finished");
  }

  // the faces that do not keep the error in the end
  const std::vector<Failing_face>& failing() const { return m_failing; }

  // the bound on the distances between the mesh and the input if an error was asked for; otherwise 0
  double error_bound() const { return m_error_bound; }

  const Operation_statistics& statistics() const { return m_statistics; }
  unsigned int number_of_rounds() const { return m_number_of_rounds_done; }

private:
  // the mesh before the rounds, and its distance to the input
  struct Start
  {
    Mesh mesh;
    Rms_and_max distance;
  };

  // does the rounds; `new_vertices` stand for the points of the input
  void improve(const std::vector<Vertex_index>& new_vertices, const Start& start)
  {
    Reference_samples samples(m_input.points(), m_input.facets(), areas_around(new_vertices), number_of_samples());
    samples.template sort_by<ConcurrencyTag>([&](const Reference_sample& s) { return new_vertices[s.start]; });
    Owners owners(m_mesh, samples);
    owners.start([&](const Reference_sample& s) { return new_vertices[s.start]; });
    Tools tools(*this, owners);
    if (keeps_error())
      owners.set_largest_distance(m_distance_of_samples);
    measure(owners, true);
    if (has_lost_nothing(owners))
      return; // what follows works with samples, and between them something can be lost
    for (unsigned int round = 0; round < m_number_of_rounds && !m_interruption.ask(); ++round)
    {
      do_round(tools, round < number_of_rounds_that_change_vertices());
      m_number_of_rounds_done = round + 1;
      report_progress(double(round + 1) / m_number_of_rounds);
    }
    if (compares_rounds())
      return_to(start);
    if (keeps_error())
    {
      flip_edges(tools);
      refine(tools);
      m_statistics.number_of_collapses += tools.refine.number_of_collapses();
      m_statistics.number_of_splits += tools.refine.number_of_splits();
    }
  }

  double number_of_samples() const
  {
    const double n = double(m_mesh.number_of_faces()), factor = keeps_error() ? more_samples_for_error : 1.;
    return (std::min)(
        (std::max)(factor * least_samples_per_face * n, (std::min)(samples_per_face * n, factor * enough_samples)),
        largest_number_of_samples);
  }

  // for each vertex the mean area of the faces around it, or a small one at least
  std::vector<double> areas_around(const std::vector<Vertex_index>& vertices) const
  {
    static constexpr double least_share = 1e-4; // of the mean of all faces
    double total = 0;
    for (const Face_index f : m_mesh.faces())
      total += face_normal(m_mesh.halfedge(f), m_mesh).norm();
    const double least = least_share * total / double(m_mesh.number_of_faces());
    std::vector<double> areas(vertices.size());
    const auto mean_area = [&](const Vertex_index v)
    {
      double sum = 0;
      std::size_t number = 0;
      for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if (!m_mesh.is_border(h))
        {
          sum += face_normal(h, m_mesh).norm();
          ++number;
        }
      return (std::max)(sum / double(number), least);
    };
    parallel_for<ConcurrencyTag>(vertices.size(), [&](const std::size_t i) { areas[i] = mean_area(vertices[i]); });
    return areas;
  }

  // Long and exact facets are samples of nothing. So the rounds, which go by samples, may take the mesh away from them.
  bool compares_rounds() const
  {
    return m_parameters.has_long_facets && !keeps_error() && m_number_of_rounds > 0 && m_parameters.aspect_ratio_bound == 0;
  }

  // Whether the mesh is the input, to the rounding of files in single precision. If not, the start is kept.
  bool is_exact(Start& start) const
  {
    static constexpr double rounding = 1e-7; // of the diagonal
    start.distance = distance_both_ways<ConcurrencyTag>(m_mesh, m_input);
    if (start.distance.max <= rounding * m_input.diagonal())
      return true;
    start.mesh = m_mesh;
    return false;
  }

  // Takes the rounds back if they have gained less in one of the distances than they have lost in the other.
  void return_to(const Start& start)
  {
    const Rms_and_max distance = distance_both_ways<ConcurrencyTag>(m_mesh, m_input);
    if (distance.rms * distance.max <= start.distance.rms * start.distance.max)
      return;
    m_mesh = start.mesh;
    m_guard.template update_all<ConcurrencyTag>();
  }

  // whether the mesh with a number of faces is the input to rounding
  bool has_lost_nothing(const Owners& owners) const
  {
    static constexpr double rounding = 1e-10; // of the diagonal
    return !keeps_error() && owners.mean_square() <= rounding * rounding * m_input.diagonal() * m_input.diagonal();
  }

  bool keeps_error() const { return m_parameters.error > 0; }

  // The last rounds only fit; where an error is to be kept, few faces are worth more.
  unsigned int number_of_rounds_that_change_vertices() const
  {
    return keeps_error() ? m_number_of_rounds - 1 : (2 * m_number_of_rounds + 2) / 3;
  }

  // what the rounds work with
  struct Tools
  {
    Tools(Error_remesher& r, Owners& owners)
      : owners(owners),
        operations(r.m_mesh, r.m_curves, r.m_guard, owners),
        exchange(r.m_mesh, r.m_input, owners, r.m_price, operations, r.m_interruption),
        contract(r.m_mesh, owners, r.m_price, operations, r.m_interruption),
        refine(r.m_mesh, r.m_input, owners, r.m_price, operations, r.m_interruption),
        flip(r.m_mesh, r.m_guard, owners, r.m_price, r.m_interruption),
        fit(r.m_mesh, r.m_guard, owners, r.m_price, r.m_interruption)
    {
    }

    Owners& owners;
    Sampled_operations<ConcurrencyTag, Mesh, Guard> operations;
    Edge_exchanger<ConcurrencyTag, Mesh, Guard> exchange;
    Bounded_coarsener<ConcurrencyTag, Mesh, Guard> contract;
    Bounded_refiner<ConcurrencyTag, Mesh, Guard> refine;
    Error_flipper<ConcurrencyTag, Mesh, Guard> flip;
    Error_fitter<ConcurrencyTag, Mesh, Guard> fit;
  };

  void do_round(Tools& tools, const bool changes_vertices)
  {
    if (changes_vertices && keeps_error())
      contract_edges(tools);
    if (changes_vertices)
      exchange_vertices(tools);
    write_stage(m_mesh, "exchanged");
    flip_edges(tools);
    write_stage(m_mesh, "flipped");
    fit_vertices(tools, false);
    fit_vertices(tools, true);
    write_stage(m_mesh, "fitted");
  }

  // To a number of faces; or as far as the mean loss allows, where an error is to be kept. Returns the vertices that stand for the
  // points of the input.
  std::vector<Vertex_index> coarsen()
  {
    const Duration duration(m_statistics.collapse_seconds);
    set_vertex_normals<ConcurrencyTag>(m_mesh);
    std::vector<std::uint32_t> points(m_input.points().size());
    {
      Loss_coarsener<ConcurrencyTag, Mesh, Guard> coarsen(m_mesh, m_curves, m_guard, m_parameters.has_long_facets,
                                                          m_interruption);
      const double mean = share_in_the_mean * m_distance_of_samples;
      const std::vector<Vertex_index> roots =
          keeps_error() ? coarsen(0, mean * mean) : coarsen(std::size_t(m_parameters.target.number_of_faces()));
      m_statistics.number_of_collapses += coarsen.number_of_collapses();
      for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = m_mesh.point(roots[v]).input_vertex;
    }
    reorder_in_space<ConcurrencyTag>(m_mesh, m_interruption);
    m_guard.template update_all<ConcurrencyTag>();
    std::vector<Vertex_index> vertices(points.size());
    for (const Vertex_index v : m_mesh.vertices())
      vertices[m_mesh.point(v).input_vertex] = v;
    std::vector<Vertex_index> result(points.size());
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = vertices[points[v]];
    return result;
  }

  void exchange_vertices(Tools& tools)
  {
    const Duration duration(m_statistics.collapse_seconds);
    const std::size_t number = tools.exchange(std::size_t(std::ceil(share_exchanged * double(m_mesh.number_of_vertices()))));
    m_statistics.number_of_collapses += number;
    m_statistics.number_of_splits += number;
  }

  void contract_edges(Tools& tools)
  {
    const Duration duration(m_statistics.collapse_seconds);
    m_statistics.number_of_collapses += tools.contract(m_distance_of_samples);
  }

  void flip_edges(Tools& tools)
  {
    const Duration duration(m_statistics.flip_seconds);
    m_statistics.number_of_flips += tools.flip();
  }

  // to search for far samples once a round is enough
  void fit_vertices(Tools& tools, const bool searches_for_far_samples)
  {
    const Duration duration(m_statistics.smoothing_seconds);
    tools.fit();
    set_vertex_normals<ConcurrencyTag>(m_mesh);
    measure(tools.owners, searches_for_far_samples);
  }

  // Brings the faces that do not keep the error nearer to the input, until all do, or nothing helps, or the input has fewer faces.
  void refine(Tools& tools)
  {
    Two_sided_check<ConcurrencyTag, Mesh> check(m_mesh, m_input, m_interruption);
    std::size_t least = (std::numeric_limits<std::size_t>::max)();
    int last_progress = 0;
    for (int round = 0; !m_interruption.ask(); ++round)
    {
      m_failing = check(m_parameters.error);
      m_error_bound = check.bound();
      if (m_failing.size() < least)
      {
        least = m_failing.size();
        last_progress = round;
      }
      if (m_failing.empty() || round == last_progress + refinements_without_progress ||
          m_mesh.number_of_faces() > m_input.facets().size() || tools.refine(m_failing, round) == 0)
        return;
      flip_edges(tools);
    }
    m_error_bound = (std::numeric_limits<double>::infinity)();
  }

  void measure(Owners& owners, const bool searches_for_far_samples)
  {
    owners.update(searches_for_far_samples);
    m_price.set_mean_cost(2 * owners.mean_square() / double(m_mesh.number_of_faces())); // both ways
  }

  void report_progress(const double share_of_rounds)
  {
    m_visitor.progress(share_of_coarsening + (1 - share_of_coarsening) * share_of_rounds);
  }

  Mesh& m_mesh;
  const Curve_network& m_curves;
  Guard& m_guard;
  const Input_surface& m_input;
  const Remeshing_parameters& m_parameters;
  const Visitor_reference m_visitor;
  Interruption& m_interruption;
  Mesh_intersections<Mesh>& m_intersections;
  const double m_distance_of_samples; // at most
  const unsigned int m_number_of_rounds;
  Shape_price m_price;
  Operation_statistics m_statistics;
  unsigned int m_number_of_rounds_done = 0;
  std::vector<Failing_face> m_failing;
  double m_error_bound = keeps_error() ? (std::numeric_limits<double>::infinity)() : 0; // until it is measured
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_ERROR_REMESHER_H
