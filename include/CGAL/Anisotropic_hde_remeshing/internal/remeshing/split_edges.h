// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_EDGES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_EDGES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Face_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Surface_projection.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/sorted_edges.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Splits edges at their middle, put on the surface. The ends of an edge do not change while others are split, so that all
// middles of a pass are projected in parallel first; the splits are done in the order of the lengths.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Guard>
class Edge_splitter
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;
  typedef Local_change<Mesh> Change;

  // guard 4: both halves are shorter than this share of the edge
  static constexpr double largest_half = 0.98;

public:
  Edge_splitter(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
                const Guard& guard, Interruption& interruption)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_projection(projection),
      m_curves(curves),
      m_guard(guard),
      m_interruption(interruption)
  {
  }

  // one pass over the edges longer than `length`, the longest first, `maximum` at most; returns how many it split
  std::size_t operator()(const double length, const std::size_t maximum = std::size_t(-1)) const
  {
    return split(long_edges(length * length, maximum));
  }

  // the edges given; returns how many it split
  std::size_t operator()(const std::vector<Edge_index>& edges) const
  {
    std::vector<Candidate> candidates;
    for (const Edge_index e : edges)
      if (m_mesh.arc(m_mesh.halfedge(e)).curve != Curve_arc::untouchable)
        candidates.push_back(Candidate{squared_length(e), e});
    return split(std::move(candidates));
  }

private:
  struct Candidate
  {
    Candidate(const double squared_length, const Edge_index edge) : squared_length(squared_length), edge(edge) {}

    double squared_length;
    Edge_index edge;
    Vertex middle;
    bool is_good = false;
  };

  std::size_t split(std::vector<Candidate> candidates) const
  {
    parallel_for<ConcurrencyTag>(
        candidates.size(), [&](const std::size_t i) { place_middle(candidates[i]); }, 16, m_interruption);
    std::size_t number_of_splits = 0;
    for (const Candidate& candidate : candidates)
    {
      if (m_interruption.poll())
        break;
      if (candidate.is_good && is_allowed(candidate))
      {
        split(candidate);
        ++number_of_splits;
      }
    }
    return number_of_splits;
  }

  double squared_length(const Edge_index e) const
  {
    return m_embedding.squared_length(m_mesh.point(m_mesh.vertex(e, 0)), m_mesh.point(m_mesh.vertex(e, 1)));
  }

  // the longest first
  std::vector<Candidate> long_edges(const double limit, const std::size_t maximum) const
  {
    std::vector<Keyed_edge> edges = sorted_edges<ConcurrencyTag>(
        m_mesh,
        [&](const Edge_index e)
        {
          const double length = squared_length(e);
          return length > limit ? -length : no_key;
        },
        m_interruption);
    edges.resize((std::min)(edges.size(), maximum));
    std::vector<Candidate> candidates;
    candidates.reserve(edges.size());
    for (const Keyed_edge& edge : edges)
      candidates.push_back(Candidate{-edge.first, edge.second});
    return candidates;
  }

  void place_middle(Candidate& candidate) const
  {
    const Halfedge_index h = m_mesh.halfedge(candidate.edge);
    const Vertex &a = m_mesh.point(m_mesh.source(h)), &b = m_mesh.point(m_mesh.target(h));
    if (m_mesh.is_on_curve(candidate.edge))
      place_on_curve(m_mesh.arc(h), candidate.middle);
    else
      place_on_surface(a, b, candidate.middle);
    m_embedding.place_between(a, b, candidate.middle);
    const double largest = largest_half * largest_half * candidate.squared_length;
    candidate.is_good = m_embedding.squared_length(a, candidate.middle) < largest &&
                        m_embedding.squared_length(candidate.middle, b) < largest &&
                        candidate.middle.normal.dot(a.normal + b.normal) > 0;
  }

  void place_on_curve(const Curve_arc& arc, Vertex& middle) const
  {
    middle.is_on_curve = true;
    middle.point = m_curves.point(arc.curve, 0.5 * (arc.source + arc.target));
    m_projection.update_normal(middle);
  }

  void place_on_surface(const Vertex& a, const Vertex& b, Vertex& middle) const
  {
    const Vector edge = b.point - a.point;
    middle.point = 0.5 * (a.point + b.point);
    middle.normal = 0.5 * (a.normal + b.normal);
    // the height of the circular arc with these normals over its chord
    if (a.normal.dot(b.normal) > 0)
      middle.point += (b.normal - a.normal).dot(edge) / 8 * middle.normal.normalized();
    m_projection.project_roughly(middle, 0.5 * edge.norm(), 0.02 * edge.norm());
  }

  // guard 1
  bool is_allowed(const Candidate& candidate) const
  {
    const Halfedge_index h = m_mesh.halfedge(candidate.edge);
    return is_allowed(h, candidate.middle) && is_allowed(m_mesh.opposite(h), candidate.middle) &&
           m_guard.accepts(subdivision(h, candidate.middle));
  }

  bool is_allowed(const Halfedge_index h, const Vertex& middle) const
  {
    if (m_mesh.is_border(h))
      return true;
    const Triangle t(h, m_mesh);
    const Vertex &a = m_mesh.point(t.a), &b = m_mesh.point(t.b), &c = m_mesh.point(t.c);
    const double before = Face_guard::quality(a, b, c);
    return Face_guard::accepts(Face_guard::quality(a, middle, c), before) &&
           Face_guard::accepts(Face_guard::quality(middle, b, c), before);
  }

  // what splitting h changes
  Change subdivision(const Halfedge_index h, const Vertex& middle) const
  {
    Change change(m_mesh);
    const typename Change::Corner m{Mesh::null_vertex(), &middle};
    for (const Halfedge_index side : {h, m_mesh.opposite(h)})
    {
      if (m_mesh.is_border(side))
        continue;
      change.remove(m_mesh.face(side));
      const Triangle t(side, m_mesh);
      change.add(change.corner(t.a), m, change.corner(t.c));
      change.add(m, change.corner(t.b), change.corner(t.c));
    }
    return change;
  }

  void split(const Candidate& candidate) const
  {
    const Halfedge_index to = m_mesh.halfedge(candidate.edge);
    const Curve_arc arc = m_mesh.arc(to);
    const double middle = 0.5 * (arc.source + arc.target);
    const Halfedge_index from = CGAL::Euler::split_edge(to, m_mesh.graph());
    m_mesh.point(m_mesh.target(from)) = candidate.middle;
    m_mesh.set_arc(from, Curve_arc{arc.curve, arc.source, middle});
    m_mesh.set_arc(to, Curve_arc{arc.curve, middle, arc.target});
    if (!m_mesh.is_border(from))
      split_face(from, m_mesh.next(m_mesh.next(from)));
    const Halfedge_index back = m_mesh.opposite(from);
    if (!m_mesh.is_border(back))
      split_face(m_mesh.prev(back), m_mesh.next(back));
    m_guard.update_around(m_mesh.target(from));
  }

  void split_face(const Halfedge_index g, const Halfedge_index h) const
  {
    const std::size_t input_face = m_mesh.input_face(m_mesh.face(g));
    const Halfedge_index between = CGAL::Euler::split_face(g, h, m_mesh.graph());
    m_mesh.set_input_face(m_mesh.face(between), input_face);
    m_mesh.set_input_face(m_mesh.face(m_mesh.opposite(between)), input_face);
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Curve_network& m_curves;
  const Guard& m_guard;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_EDGES_H
