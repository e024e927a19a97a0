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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
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
  typedef typename Mesh::Vertex Vertex;
  typedef Local_change<Mesh> Change;

  // of an edge, over the length of the part of a curve for which it stands; for a third of a circle it is .83
  static constexpr double smallest_chord = 0.85;
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
    : m_mesh(mesh), m_embedding(embedding), m_curves(curves), m_guard(guard), m_interruption(interruption)
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
      if (!m_guard.is_local() || is_touched_around(e, is_touched))
        choices[i] = internal::squared_length(e, m_mesh, m_embedding) < squared_length ? choose(e, squared_longest)
                                                                                       : Mesh::null_halfedge();
      if (!choices[i].is_valid() || !CGAL::Euler::does_satisfy_link_condition(e, m_mesh.graph()))
        continue;
      touch_around(contract(choices[i]), is_touched);
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
    if ((std::min)(to_target, to_source) < not_allowed && m_guard.accepts(contraction(is_to_target ? h : g)))
      return is_to_target ? h : g;
    if ((std::max)(to_target, to_source) < not_allowed && m_guard.accepts(contraction(is_to_target ? g : h)))
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

  // what contracting h to its target changes
  Change contraction(const Halfedge_index h) const
  {
    Change change(m_mesh);
    const Vertex_index kept = m_mesh.target(h);
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.opposite(h)))
    {
      if (m_mesh.is_border(in))
        continue;
      const Face_index f = m_mesh.face(in);
      change.remove(f);
      const Triangle t(in, m_mesh);
      if (t.a != kept && t.c != kept)
        change.add(change.corner(t.a, in), change.corner(kept, in), change.corner(t.c, in), f);
    }
    return change;
  }

  // Removes the source of h and returns the vertex that stays. Whichever edges the mesh drops, those that stay get the arcs of
  // the edges at the target. On a curve the edge that stays gets the arc of the path that it replaces.
  Vertex_index contract(const Halfedge_index h) const
  {
    const Change change = m_guard.is_local() ? Change(m_mesh) : contraction(h); // a local guard does not look at it
    const Vertex kept = m_mesh.point(m_mesh.target(h));
    const typename Mesh::Sides sides = m_mesh.sides(m_mesh.target(h));
    std::array<std::pair<Vertex_index, Curve_arc>, 3> arcs; // from neighbours to the vertex that stays
    std::size_t number_of_arcs = 0;
    for (const Halfedge_index side : {h, m_mesh.opposite(h)})
    {
      if (m_mesh.is_border(side))
        continue;
      const Halfedge_index to_kept = side == h ? m_mesh.opposite(m_mesh.next(side)) : m_mesh.prev(side);
      arcs[number_of_arcs++] = {m_mesh.source(to_kept), m_mesh.arc(to_kept)};
    }
    if (m_mesh.point(m_mesh.source(h)).is_on_curve)
      arcs[number_of_arcs++] = path_over_source(h);
    const Vertex_index v = CGAL::Euler::collapse_edge(m_mesh.edge(h), m_mesh.graph());
    m_mesh.point(v) = kept;
    m_mesh.sides(v) = sides;
    for (std::size_t i = 0; i < number_of_arcs; ++i)
      m_mesh.set_arc(m_mesh.halfedge(arcs[i].first, v), arcs[i].second);
    m_guard.update(change);
    return v;
  }

  // the vertex before the source of h on the curve of h, and the arc of the curve from there to the target of h
  std::pair<Vertex_index, Curve_arc> path_over_source(const Halfedge_index h) const
  {
    const Halfedge_index before = m_mesh.opposite(Curve_network::next_on_curve(m_mesh.opposite(h), m_mesh));
    const Curve_arc first = m_mesh.arc(before), second = m_mesh.arc(h);
    return {m_mesh.source(before), Curve_arc{first.curve, first.source, first.target + (second.target - second.source)}};
  }

  // The longest squared length of the edges that the contraction of h to its target makes. It is `not_allowed` if that exceeds
  // `squared_longest`, or if the source of h must not be removed this way.
  double cost(const Halfedge_index h, const double squared_longest) const
  {
    const Vertex_index removed = m_mesh.source(h), kept = m_mesh.target(h);
    const Vertex& from = m_mesh.point(removed);
    if (from.is_fixed || (from.is_on_curve && !may_shorten_curve(h)))
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

  // Whether a vertex of a curve may go along h. It goes along the curve only, and past no face whose other edge at the vertex
  // is on the curve, too. The curve must not become much shorter. If the deviation from the polyline is bounded, the curve must
  // not leave its polyline. A boundary keeps at least three edges.
  bool may_shorten_curve(const Halfedge_index h) const
  {
    if (!m_mesh.is_on_curve(m_mesh.edge(h)))
      return false;
    const Halfedge_index g = m_mesh.opposite(h);
    if (m_mesh.is_border(h) ? is_triangle(h) : m_mesh.is_on_curve(m_mesh.edge(m_mesh.prev(h))))
      return false;
    if (m_mesh.is_border(g) ? is_triangle(g) : m_mesh.is_on_curve(m_mesh.edge(m_mesh.next(g))))
      return false;
    const auto path = path_over_source(h);
    const double chord = (m_mesh.point(path.first).point - m_mesh.point(m_mesh.target(h)).point).norm();
    return chord >= smallest_chord * std::abs(path.second.target - path.second.source) && m_curves.accepts(path.second);
  }

  bool is_triangle(const Halfedge_index h) const { return m_mesh.next(m_mesh.next(m_mesh.next(h))) == h; }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Curve_network& m_curves;
  const Guard& m_guard;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_COLLAPSER_H
