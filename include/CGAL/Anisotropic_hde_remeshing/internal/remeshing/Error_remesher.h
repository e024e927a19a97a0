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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_reorderer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/vertex_normals.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/write_stage.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_exchanger.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Error_fitter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Error_flipper.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Loss_coarsener.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Reference_samples.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

  // How many samples there are at least: so many for a face of the result, but fewer if they are more than enough in all.
  static constexpr double samples_per_face = 30, least_samples_per_face = 8, enough_samples = 300000;
  static constexpr double largest_number_of_samples = 1e9; // where this is many: their indices have 32 bits
  static constexpr double share_exchanged = 0.1;           // of the vertices, in a round
  static constexpr double share_of_coarsening = 0.3;       // of the progress that is told
  // Longest edge over altitude: up to the first a shape is free, above the second no operation makes it worse.
  static constexpr double free_ratio = 4, largest_ratio = 40;
  static constexpr double price_of_shape = 2, price_of_shape_for_least_distance = 0.1;

public:
  Error_remesher(Mesh& mesh, const Curve_network& curves, const Guard& guard, const Input_surface& input,
                 const Remeshing_parameters& parameters, const Visitor_reference visitor)
    : m_mesh(mesh),
      m_curves(curves),
      m_guard(guard),
      m_input(input),
      m_parameters(parameters),
      m_visitor(visitor),
      m_interruption(visitor.interruption()),
      m_number_of_rounds(parameters.fit_to_surface ? 5 * parameters.number_of_iterations / 2 : parameters.number_of_iterations),
      m_price(parameters.fit_to_surface ? price_of_shape_for_least_distance : price_of_shape, free_ratio, largest_ratio)
  {
  }

  void operator()()
  {
    const std::size_t number_of_faces = std::size_t(m_parameters.target.number_of_faces());
    write_stage(m_mesh, "input");
    const std::vector<Vertex_index> new_vertices = coarsen(number_of_faces);
    write_stage(m_mesh, "coarsened");
    if (m_interruption.ask())
      return;
    report_progress(0);
    const Reference_samples samples(m_input.points(), m_input.facets(), number_of_samples());
    Owners owners(m_mesh, samples);
    owners.start([&](const Reference_sample& s) { return new_vertices[s.start]; });
    measure(owners);
    Edge_exchanger<ConcurrencyTag, Mesh, Guard> exchange(m_mesh, m_curves, m_guard, m_input, owners, m_price, m_interruption);
    Error_flipper<ConcurrencyTag, Mesh, Guard> flip(m_mesh, m_guard, owners, m_price, m_interruption);
    Error_fitter<ConcurrencyTag, Mesh, Guard> fit(m_mesh, m_guard, owners, m_price, m_interruption);
    for (unsigned int round = 0; round < m_number_of_rounds && !m_interruption.ask(); ++round)
    {
      if (3 * round < 2 * m_number_of_rounds)
        exchange_vertices(exchange, share_exchanged);
      write_stage(m_mesh, "exchanged");
      flip_edges(flip);
      write_stage(m_mesh, "flipped");
      fit_vertices(fit, owners);
      fit_vertices(fit, owners);
      write_stage(m_mesh, "fitted");
      m_number_of_rounds_done = round + 1;
      report_progress(double(round + 1) / m_number_of_rounds);
    }
    flip_edges(flip);
    write_stage(m_mesh, "finished");
  }

  const Operation_statistics& statistics() const { return m_statistics; }
  unsigned int number_of_rounds() const { return m_number_of_rounds_done; }

private:
  double number_of_samples() const
  {
    const double n = double(m_mesh.number_of_faces());
    return (std::min)((std::max)(least_samples_per_face * n, (std::min)(samples_per_face * n, enough_samples)),
                      largest_number_of_samples);
  }

  // Returns the vertices that stand for the points of the input.
  std::vector<Vertex_index> coarsen(const std::size_t number_of_faces)
  {
    const Duration duration(m_statistics.collapse_seconds);
    set_vertex_normals<ConcurrencyTag>(m_mesh);
    std::vector<std::uint32_t> points(m_input.points().size());
    {
      Loss_coarsener<ConcurrencyTag, Mesh, Guard> coarsen(m_mesh, m_curves, m_guard, m_interruption);
      const std::vector<Vertex_index> roots = coarsen(number_of_faces);
      m_statistics.number_of_collapses += coarsen.number_of_collapses();
      for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = m_mesh.point(roots[v]).input_vertex;
    }
    reorder_in_space<ConcurrencyTag>(m_mesh, m_interruption);
    m_guard.template update_all<ConcurrencyTag>(m_interruption);
    std::vector<Vertex_index> vertices(points.size());
    for (const Vertex_index v : m_mesh.vertices())
      vertices[m_mesh.point(v).input_vertex] = v;
    std::vector<Vertex_index> result(points.size());
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = vertices[points[v]];
    return result;
  }

  void exchange_vertices(Edge_exchanger<ConcurrencyTag, Mesh, Guard>& exchange, const double share)
  {
    const Duration duration(m_statistics.collapse_seconds);
    const std::size_t number = exchange(std::size_t(std::ceil(share * double(m_mesh.number_of_vertices()))));
    m_statistics.number_of_collapses += number;
    m_statistics.number_of_splits += number;
  }

  void flip_edges(Error_flipper<ConcurrencyTag, Mesh, Guard>& flip)
  {
    const Duration duration(m_statistics.flip_seconds);
    m_statistics.number_of_flips += flip();
  }

  void fit_vertices(Error_fitter<ConcurrencyTag, Mesh, Guard>& fit, Owners& owners)
  {
    const Duration duration(m_statistics.smoothing_seconds);
    fit();
    set_vertex_normals<ConcurrencyTag>(m_mesh);
    measure(owners);
  }

  void measure(Owners& owners)
  {
    owners.update();
    m_price.set_mean_cost(2 * owners.mean_square() / double(m_mesh.number_of_faces())); // both ways
  }

  void report_progress(const double share_of_rounds)
  {
    m_visitor.progress(share_of_coarsening + (1 - share_of_coarsening) * share_of_rounds);
  }

  Mesh& m_mesh;
  const Curve_network& m_curves;
  const Guard& m_guard;
  const Input_surface& m_input;
  const Remeshing_parameters& m_parameters;
  const Visitor_reference m_visitor;
  Interruption& m_interruption;
  const unsigned int m_number_of_rounds;
  Shape_price m_price;
  Operation_statistics m_statistics;
  unsigned int m_number_of_rounds_done = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_ERROR_REMESHER_H
