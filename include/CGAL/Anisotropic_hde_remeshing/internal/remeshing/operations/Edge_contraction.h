// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_CONTRACTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_CONTRACTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Contracts an edge: what that changes, whether curves allow it, and how it is done.
template <typename Mesh, typename Guard>
class Edge_contraction
{
  typedef typename Mesh::Vertex Vertex;
  typedef Local_change<Mesh> Change;

  // of an edge, over the length of the part of a curve for which it stands; for a third of a circle it is .83
  static constexpr double smallest_chord = 0.85;

public:
  Edge_contraction(Mesh& mesh, const Curve_network& curves, const Guard& guard) : m_mesh(mesh), m_curves(curves), m_guard(guard)
  {
  }

  // whether the source of h may be removed this way
  bool is_removable(const Halfedge_index h) const
  {
    const Vertex& from = m_mesh.point(m_mesh.source(h));
    return !from.is_fixed && (!from.is_on_curve || may_shorten_curve(h));
  }

  // what contracting h to its target changes
  Change change(const Halfedge_index h) const
  {
    Change result(m_mesh);
    add_change(h, result);
    return result;
  }

  // What contracting h to a new state changes. A target that is on a curve or fixed stays as it is.
  Change change(const Halfedge_index h, const Vertex& moved) const
  {
    Change result(m_mesh);
    if (moved.is_on_curve || moved.is_fixed)
      add_change(h, result);
    else
      add_change(h, moved, result);
    return result;
  }

  // Removes the source of h and returns the vertex that stays. Whichever edges the mesh drops, those that stay get the arcs of
  // the edges at the target. On a curve the edge that stays gets the arc of the path that it replaces.
  Vertex_index contract(const Halfedge_index h) const
  {
    return contract(h, m_mesh.point(m_mesh.target(h)), m_guard.needs_changes() ? change(h) : Change(m_mesh));
  }

  // the same to a new state; a target on a curve must keep its own
  Vertex_index contract(const Halfedge_index h, const Vertex& kept) const
  {
    return contract(h, kept, m_guard.needs_changes() ? change(h, kept) : Change(m_mesh));
  }

private:
  void add_change(const Halfedge_index h, Change& result) const
  {
    const Vertex_index kept = m_mesh.target(h);
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.opposite(h)))
    {
      if (m_mesh.is_border(in))
        continue;
      const Face_index f = m_mesh.face(in);
      result.remove(f);
      const Triangle t(in, m_mesh);
      if (t.a != kept && t.c != kept)
        result.add(result.corner(t.a, in), result.corner(kept, in), result.corner(t.c, in), f);
    }
  }

  void add_change(const Halfedge_index h, const Vertex& moved, Change& result) const
  {
    const Vertex_index removed = m_mesh.source(h), kept = m_mesh.target(h);
    for (const Halfedge_index end : {m_mesh.opposite(h), h})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
      {
        if (m_mesh.is_border(in))
          continue;
        const Face_index f = m_mesh.face(in);
        const Triangle t(in, m_mesh);
        const bool has_both = t.a == removed || t.c == removed || t.a == kept || t.c == kept;
        if (has_both && end == h)
          continue; // seen from the other end
        result.remove(f);
        if (!has_both)
          result.add(result.corner(t.a, in), typename Change::Corner{kept, &moved}, result.corner(t.c, in), f);
      }
  }

  // the change is empty where the guard does not look at it
  Vertex_index contract(const Halfedge_index h, const Vertex kept, const Change& change) const
  {
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

  // Whether a vertex of a curve may go along h. It goes along the curve only, and past no face whose other edge at the vertex
  // is on the curve, too. The curve must not become much shorter. If the deviation from the polyline is bounded, the curve must
  // not leave its polyline. A boundary keeps at least three edges.
  bool may_shorten_curve(const Halfedge_index h) const
  {
    if (!m_mesh.is_on_curve(m_mesh.edge(h)) || !m_curves.may_collapse())
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
  const Curve_network& m_curves;
  const Guard& m_guard;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_CONTRACTION_H
