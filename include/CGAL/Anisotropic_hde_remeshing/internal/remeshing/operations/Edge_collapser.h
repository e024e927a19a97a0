// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_COLLAPSER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_COLLAPSER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_contraction.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/sorted_edges.h>

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

// Contracts an edge to one of its ends. The end lies on the surface already, so no projection is needed (the paper's figure 3).
template <typename ConcurrencyTag, typename Embedding, typename Guard>
class Edge_collapser
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  // If all short edges may be contracted, their exact order does not matter. In the exact order the next edge is far away in
  // memory. So the edges are sorted into classes: contractions in a mesh of 1,000,000 faces take 2.5 instead of 4.0
  // microseconds a face.
  static constexpr double classes_per_octave = 2;
  // The centre of a larger fan stays until contractions across the fan and flips have made the fan smaller. The reason is that
  // the guard looks at all pairs of faces of the fan.
  static constexpr std::size_t largest_degree = 64;
  static constexpr double not_allowed = (std::numeric_limits<double>::max)(); // a cost

public:
  Edge_collapser(Mesh& mesh, const Embedding& embedding, const Curve_network& curves, const Guard& guard,
                 Interruption& interruption)
    : m_mesh(mesh), m_embedding(embedding), m_contraction(mesh, curves, guard), m_guard(guard), m_interruption(interruption)
  {
  }

  // One pass over the edges shorter than `length`, the shorter ones first. It makes at most `maximum` contractions. None of
  // them makes an edge longer than `longest`. Returns how many edges it contracted. It finds out in parallel which edges may be
  // contracted. It contracts them one after the other, and asks again only where an earlier contraction has changed something.
  // So the result is that of one thread.
  std::size_t operator()(const double length, const double longest, const std::size_t maximum = std::size_t(-1)) const
  {
    const double squared_length = length * length, squared_longest = longest * longest;
    const std::vector<Keyed_edge> candidates = short_edges(squared_length, maximum == std::size_t(-1) ? classes_per_octave : 0);
    std::vector<Halfedge_index> choices(candidates.size());
    std::vector<char> is_touched(vertex_capacity(m_mesh), 0);
    parallel_for<ConcurrencyTag>(
        candidates.size(), [&](const std::size_t i) { choices[i] = choose(candidates[i].second, squared_longest); }, 64,
        m_interruption);
    std::size_t number_of_collapses = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      if (number_of_collapses == maximum || m_interruption.poll())
        break;
      const Edge_index e = candidates[i].second;
      if (m_mesh.is_removed(e))
        continue;
      if (is_touched_around(e, is_touched) || (choices[i].is_valid() && !m_guard.is_local(e)))
        choices[i] = internal::squared_length(e, m_mesh, m_embedding) < squared_length ? choose(e, squared_longest)
                                                                                       : Mesh::null_halfedge();
      if (!choices[i].is_valid() || !CGAL::Euler::does_satisfy_link_condition(e, m_mesh.graph()))
        continue;
      touch_around(m_contraction.contract(choices[i]), is_touched);
      ++number_of_collapses;
    }
    return number_of_collapses;
  }

private:
  // The edges shorter than the limit, the shortest first. If `classes` is positive, it is the number of classes for a factor of
  // two in the squared length. Within a class the edges are in the order of memory.
  std::vector<Keyed_edge> short_edges(const double limit, const double classes) const
  {
    return sorted_edges<ConcurrencyTag>(
        m_mesh,
        [&](const Edge_index e)
        {
          const double length = squared_length(e, m_mesh, m_embedding);
          if (!(length < limit))
            return no_key;
          return classes > 0 ? std::ceil(classes * std::log2(length / limit)) : length;
        },
        m_interruption);
  }

  // The halfedge to whose target the edge is to be contracted; none if the guard accepts neither of the two. The one with the
  // shorter new edges is asked for first.
  Halfedge_index choose(const Edge_index e, const double squared_longest) const
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    const double to_target = cost(h, squared_longest), to_source = cost(g, squared_longest);
    const bool is_to_target = to_target <= to_source;
    if ((std::min)(to_target, to_source) < not_allowed && m_guard.accepts(m_contraction.change(is_to_target ? h : g)))
      return is_to_target ? h : g;
    if ((std::max)(to_target, to_source) < not_allowed && m_guard.accepts(m_contraction.change(is_to_target ? g : h)))
      return is_to_target ? g : h;
    return Mesh::null_halfedge();
  }

  // Whether something has changed that `choose()` looks at: the faces at the ends, and the faces beyond these. A face beyond
  // has two neighbours of an end.
  bool is_touched_around(const Edge_index e, const std::vector<char>& is_touched) const
  {
    for (const Halfedge_index h : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(h))
        if (is_touched[m_mesh.source(in)])
          return true;
    return false;
  }

  void touch_around(const Vertex_index v, std::vector<char>& is_touched) const
  {
    is_touched[v] = 1;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      is_touched[m_mesh.source(in)] = 1;
  }

  // The longest squared length of the edges that the contraction of h to its target makes. It is `not_allowed` if that exceeds
  // `squared_longest`, or if the source of h must not be removed this way.
  double cost(const Halfedge_index h, const double squared_longest) const
  {
    const Vertex_index kept = m_mesh.target(h);
    if (!m_contraction.is_removable(h))
      return not_allowed;
    double longest = 0;
    std::size_t degree = 0;
    for (Halfedge_index in = m_mesh.opposite(h);;)
    {
      if (++degree > largest_degree)
        return not_allowed;
      // `in` ends at the removed vertex
      const Vertex_index neighbor = m_mesh.source(in);
      if (neighbor != kept)
      {
        longest = (std::max)(longest, squared_length_to(neighbor, in, kept));
        if (longest > squared_longest)
          return not_allowed; // guard 2
      }
      in = m_mesh.prev(m_mesh.opposite(in));
      if (in == m_mesh.opposite(h))
        break;
    }
    return longest;
  }

  // The squared length of the edge from `neighbor`, the source of `in`, to `kept`. `kept` is to take the place of the target of
  // `in`.
  double squared_length_to(const Vertex_index neighbor, const Halfedge_index in, const Vertex_index kept) const
  {
    const double length = m_embedding.squared_length(m_mesh.state(neighbor, in), m_mesh.state(kept, in));
    if (!m_mesh.is_on_curve(m_mesh.edge(in)))
      return length;
    const Halfedge_index out = m_mesh.opposite(in);
    return (std::max)(length, m_embedding.squared_length(m_mesh.state(neighbor, out), m_mesh.state(kept, out)));
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Edge_contraction<Mesh, Guard> m_contraction;
  const Guard& m_guard;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_COLLAPSER_H
