// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Flips edges in passes over those whose surroundings have changed. A pass finds out in parallel which edges gain. It flips them
// one after the other, and looks again only at edges next to an earlier flip. Why a flip gains is the caller's.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Edge_flips
{
  typedef Local_change<Mesh> Change;

public:
  // the two faces of an edge from a to b; c and d are their third vertices
  struct Quad
  {
    Vertex_index a, b, c, d;
  };

  Edge_flips(Mesh& mesh, const Guard& guard, Interruption& interruption)
    : m_mesh(mesh), m_guard(guard), m_interruption(interruption)
  {
  }

  // Returns the number of flips. A pass flips edges in the order of the mesh. The next pass looks at the edges around them.
  // Only few edges are flipped, so it is enough to find them in parallel. `gains(e)` includes that the flip is allowed.
  // `flip(e)` does it.
  template <typename Gains, typename Flip>
  std::size_t operator()(const int maximum_number_of_passes, const Gains& gains, const Flip& flip) const
  {
    std::vector<char> is_queued(edge_capacity(m_mesh), 0);
    std::vector<Edge_index> queue(m_mesh.edges().begin(), m_mesh.edges().end());
    std::size_t number_of_flips = 0;
    for (int pass = 0; pass < maximum_number_of_passes && !queue.empty() && !m_interruption.is_requested(); ++pass)
    {
      const std::vector<Edge_index> flipped = flip_all(gaining(queue, gains), gains, flip);
      number_of_flips += flipped.size();
      queue = surroundings(flipped, is_queued);
    }
    return number_of_flips;
  }

  Quad quad(const Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h)), m_mesh.target(m_mesh.next(g))};
  }

  // whether the mesh stays a manifold, and what the guard says
  bool is_allowed(const Edge_index e, const Quad& q) const
  {
    return q.c != q.d && !m_mesh.halfedge(q.c, q.d).is_valid() && m_mesh.degree(q.a) > 3 && m_mesh.degree(q.b) > 3 &&
           m_guard.accepts(change(e, q));
  }

  void flip(const Edge_index e) const
  {
    CGAL::Euler::flip_edge(m_mesh.halfedge(e), m_mesh.graph());
    m_guard.update_at(m_mesh.halfedge(e));
  }

private:
  // the edges that gain by a flip, in the given order
  template <typename Gains>
  std::vector<Edge_index> gaining(const std::vector<Edge_index>& edges, const Gains& gains) const
  {
    std::vector<char> is_gain(edges.size(), 0);
    parallel_for<ConcurrencyTag>(
        edges.size(), [&](const std::size_t i) { is_gain[i] = gains(edges[i]); }, 64, m_interruption);
    std::vector<Edge_index> result;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (is_gain[i])
        result.push_back(edges[i]);
    return result;
  }

  // Flips the edges one after the other. An edge is left out if an earlier flip has taken its gain. Returns the edges that were
  // flipped.
  template <typename Gains, typename Flip>
  std::vector<Edge_index> flip_all(const std::vector<Edge_index>& edges, const Gains& gains, const Flip& flip) const
  {
    std::vector<Edge_index> flipped;
    std::vector<char> is_touched(vertex_capacity(m_mesh), 0);
    for (const Edge_index e : edges)
    {
      if (m_interruption.poll())
        break;
      const Quad q = quad(e);
      const bool is_changed = is_touched[q.a] || is_touched[q.b] || is_touched[q.c] || is_touched[q.d] || !m_guard.is_local(e);
      if (is_changed && !gains(e))
        continue;
      flip(e);
      for (const Vertex_index v : {q.a, q.b, q.c, q.d})
        is_touched[v] = 1;
      flipped.push_back(e);
    }
    return flipped;
  }

  // The edges of the faces at the given edges, each once, in the order of the mesh. `is_queued` is 0 for all edges before and
  // after.
  std::vector<Edge_index> surroundings(const std::vector<Edge_index>& edges, std::vector<char>& is_queued) const
  {
    std::vector<Edge_index> result;
    for (const Edge_index e : edges)
    {
      const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
      for (const Halfedge_index side : {h, m_mesh.next(h), m_mesh.prev(h), m_mesh.next(g), m_mesh.prev(g)})
      {
        const Edge_index edge = m_mesh.edge(side);
        if (!is_queued[edge])
          result.push_back(edge);
        is_queued[edge] = 1;
      }
    }
    for (const Edge_index e : result)
      is_queued[e] = 0;
    std::sort(result.begin(), result.end());
    return result;
  }

  // what a flip changes
  Change change(const Edge_index e, const Quad& q) const
  {
    Change change(m_mesh);
    const Halfedge_index h = m_mesh.halfedge(e);
    change.remove(m_mesh.face(h));
    change.remove(m_mesh.face(m_mesh.opposite(h)));
    const auto a = change.corner(q.a, h), b = change.corner(q.b, h), c = change.corner(q.c, h), d = change.corner(q.d, h);
    change.add(c, a, d);
    change.add(d, b, c);
    return change;
  }

  Mesh& m_mesh;
  const Guard& m_guard;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPS_H
