// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_COLLAPSE_EDGES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_COLLAPSE_EDGES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Face_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Contracts edges to one of their ends, which lies on the surface already: no projection is needed (the paper's figure 3).
template <typename Embedding>
class Edge_collapser
{
public:
  Edge_collapser(Working_mesh& mesh, const Embedding& embedding) : m_mesh(mesh), m_embedding(embedding) {}

  // one pass over the edges shorter than `length`, the shortest first, `maximum` contractions at most; none makes an edge
  // longer than `longest`. Returns how many it contracted.
  std::size_t operator()(const double length, const double longest, const std::size_t maximum = std::size_t(-1)) const
  {
    const double squared_length = length * length;
    std::size_t number_of_collapses = 0;
    for (const auto& candidate : short_edges(squared_length))
    {
      if (number_of_collapses == maximum)
        break;
      // earlier contractions may have removed the edge or moved its ends
      if (!m_mesh.is_removed(candidate.second) && this->squared_length(candidate.second) < squared_length &&
          collapse(candidate.second, longest * longest))
        ++number_of_collapses;
    }
    return number_of_collapses;
  }

private:
  double squared_length(const Edge_index e) const
  {
    return m_embedding.squared_length(m_mesh.point(m_mesh.vertex(e, 0)), m_mesh.point(m_mesh.vertex(e, 1)));
  }

  std::vector<std::pair<double, Edge_index>> short_edges(const double limit) const
  {
    std::vector<std::pair<double, Edge_index>> candidates;
    for (const Edge_index e : m_mesh.edges())
      if (squared_length(e) < limit)
        candidates.emplace_back(squared_length(e), e);
    std::sort(candidates.begin(), candidates.end());
    return candidates;
  }

  bool collapse(const Edge_index e, const double squared_longest) const
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    const double to_target = cost(h, squared_longest), to_source = cost(g, squared_longest);
    if ((std::min)(to_target, to_source) == (std::numeric_limits<double>::max)() ||
        !CGAL::Euler::does_satisfy_link_condition(e, m_mesh))
      return false;
    const Vertex_state kept = m_mesh.point(to_target <= to_source ? m_mesh.target(h) : m_mesh.source(h));
    m_mesh.point(CGAL::Euler::collapse_edge(e, m_mesh)) = kept;
    return true;
  }

  // the longest squared edge that contracting h to its target makes; the largest double if that is not allowed
  double cost(const Halfedge_index h, const double squared_longest) const
  {
    static constexpr double not_allowed = (std::numeric_limits<double>::max)();
    const Vertex_index removed = m_mesh.source(h), kept = m_mesh.target(h);
    const Vertex_state &from = m_mesh.point(removed), &to = m_mesh.point(kept);
    // a vertex of the boundary goes along the boundary only, and a boundary keeps three edges at least
    if (from.is_fixed || (from.is_on_boundary() && !m_mesh.is_border(m_mesh.edge(h))))
      return not_allowed;
    if (from.is_on_boundary() && is_border_triangle(h))
      return not_allowed;
    double longest = 0;
    for (Halfedge_index in = m_mesh.opposite(h); ; )
    {
      // `in` ends at the removed vertex
      const Vertex_index neighbor = m_mesh.source(in);
      if (neighbor != kept)
      {
        longest = (std::max)(longest, m_embedding.squared_length(m_mesh.point(neighbor), to));
        if (longest > squared_longest)
          return not_allowed; // guard 2
      }
      if (!m_mesh.is_border(in) && !accepts_face(in, kept, to))
        return not_allowed; // guards 1 and 3
      in = m_mesh.prev(m_mesh.opposite(in));
      if (in == m_mesh.opposite(h))
        break;
    }
    return longest;
  }

  // whether the face of `in` is as good with `to` in the place of the target of `in`
  bool accepts_face(const Halfedge_index in, const Vertex_index kept, const Vertex_state& to) const
  {
    const Triangle t(in, m_mesh);
    if (t.a == kept || t.c == kept)
      return true; // it vanishes
    const Vertex_state &a = m_mesh.point(t.a), &c = m_mesh.point(t.c);
    const double after = Face_guard::quality(a, to, c);
    return after >= Face_guard::smallest_cosine ||
           Face_guard::accepts(after, Face_guard::quality(a, m_mesh.point(t.b), c));
  }

  bool is_border_triangle(Halfedge_index h) const
  {
    if (!m_mesh.is_border(h))
      h = m_mesh.opposite(h);
    return m_mesh.next(m_mesh.next(m_mesh.next(h))) == h;
  }

  Working_mesh& m_mesh;
  const Embedding& m_embedding;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_COLLAPSE_EDGES_H
