// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_SPLITTER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_SPLITTER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_placement.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_subdivision.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/sorted_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_projection.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Splits edges at their middle and puts the middle on the surface. The ends of an edge do not change while other edges are
// split. So all middles of a pass are projected in parallel first. Then the edges are split in the order of their lengths.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Guard>
class Edge_splitter
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;

  // guard 4: both halves are shorter than this share of the edge
  static constexpr double largest_half = 0.98;

public:
  Edge_splitter(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
                const Guard& guard, Interruption& interruption)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_projection(projection),
      m_curves(embedding, projection, curves),
      m_subdivision(mesh, guard),
      m_guard(guard),
      m_interruption(interruption)
  {
  }

  // one pass over the edges longer than `length`, the longest first, `maximum` at most; returns how many it split
  std::size_t operator()(const double length, const std::size_t maximum = std::size_t(-1)) const
  {
    return split(long_edges(length * length, maximum));
  }

  // splits the given edges; returns how many it split
  std::size_t operator()(const std::vector<Edge_index>& edges) const
  {
    std::vector<Candidate> candidates;
    for (const Edge_index e : edges)
      if (m_mesh.arc(m_mesh.halfedge(e)).curve != Curve_arc::untouchable)
        candidates.push_back(Candidate{squared_length(e, m_mesh, m_embedding), e});
    return split(std::move(candidates));
  }

private:
  struct Candidate
  {
    Candidate(const double squared_length, const Edge_index edge) : squared_length(squared_length), edge(edge) {}

    double squared_length;
    Edge_index edge;
    Vertex middle;
    typename Mesh::Sides sides; // of a middle between two regions
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
      const Halfedge_index h = m_mesh.halfedge(candidate.edge);
      if (candidate.is_good && m_guard.accepts(m_subdivision.change(h, candidate.middle, candidate.sides)))
      {
        m_subdivision.split(h, candidate.middle, candidate.sides);
        ++number_of_splits;
      }
    }
    return number_of_splits;
  }

  // the edges longer than the limit, the longest first
  std::vector<Candidate> long_edges(const double limit, const std::size_t maximum) const
  {
    std::vector<Keyed_edge> edges = sorted_edges<ConcurrencyTag>(
        m_mesh,
        [&](const Edge_index e)
        {
          const double length = squared_length(e, m_mesh, m_embedding);
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
    if (m_mesh.is_on_curve(candidate.edge))
    {
      place_on_curve(h, candidate);
      candidate.is_good = is_good_middle(h, candidate) && is_good_middle(m_mesh.opposite(h), candidate);
      return;
    }
    place_on_surface(h, candidate.middle);
    candidate.is_good = is_good_middle(h, candidate);
  }

  // whether the middle is good as the face of h sees it; if h is on the border, as the face on its other side sees it
  bool is_good_middle(const Halfedge_index h, const Candidate& candidate) const
  {
    const Vertex &a = m_mesh.state(m_mesh.source(h), h), &b = m_mesh.state(m_mesh.target(h), h),
                 &middle = m_subdivision.state(h, candidate.middle, candidate.sides);
    const double largest = largest_half * largest_half * candidate.squared_length;
    return m_embedding.squared_length(a, middle) < largest && m_embedding.squared_length(middle, b) < largest &&
           middle.normal.dot(a.normal + b.normal) > 0;
  }

  void place_on_curve(const Halfedge_index h, Candidate& candidate) const
  {
    const Curve_arc arc = m_mesh.arc(h);
    const Region region = m_mesh.region(h), beyond = m_mesh.region(m_mesh.opposite(h));
    Vertex& middle = candidate.middle;
    middle.is_on_curve = true;
    if (region != beyond)
    {
      middle.is_on_crease = true;
      for (const Region r : {(std::min)(region, beyond), (std::max)(region, beyond)})
        candidate.sides.push_back(Crease_side<Vertex>{r, middle});
    }
    middle.point = m_curves.point(arc.curve, 0.5 * (arc.source + arc.target), region, candidate.sides);
    m_curves.update(middle, region, candidate.sides,
                    [&](Vertex& vertex, const Region r)
                    {
                      const Halfedge_index side = r == region ? h : m_mesh.opposite(h);
                      m_embedding.place_between(m_mesh.state(m_mesh.source(h), side), m_mesh.state(m_mesh.target(h), side),
                                                vertex);
                    });
  }

  void place_on_surface(const Halfedge_index h, Vertex& middle) const
  {
    const Vertex &a = m_mesh.state(m_mesh.source(h), h), &b = m_mesh.state(m_mesh.target(h), h);
    const Vector edge = b.point - a.point;
    middle.point = 0.5 * (a.point + b.point);
    middle.normal = 0.5 * (a.normal + b.normal);
    // the height of the circular arc with these normals over its chord
    if (a.normal.dot(b.normal) > 0)
      middle.point += (b.normal - a.normal).dot(edge) / 8 * middle.normal.normalized();
    m_projection.project_roughly(middle, m_mesh.region(h), 0.5 * edge.norm(), 0.02 * edge.norm());
    m_embedding.place_between(a, b, middle);
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Curve_placement<Embedding, Projection> m_curves;
  const Edge_subdivision<Mesh, Guard> m_subdivision;
  const Guard& m_guard;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_SPLITTER_H
