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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Boundary_curves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Face_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Surface_projection.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Splits edges at their middle, put on the surface. The ends of an edge do not change while others are split, so that all
// middles of a pass are projected in parallel first; the splits are done in the order of the lengths.
template <typename ConcurrencyTag, typename Embedding, typename Projection>
class Edge_splitter
{
  // guard 4: both halves are shorter than this share of the edge
  static constexpr double largest_half = 0.98;

public:
  Edge_splitter(Working_mesh& mesh, const Embedding& embedding, const Projection& projection,
                const Boundary_curves& boundary)
    : m_mesh(mesh), m_embedding(embedding), m_projection(projection), m_boundary(boundary)
  {
  }

  // one pass over the edges longer than `length`, the longest first, `maximum` at most; returns how many it split
  std::size_t operator()(const double length, const std::size_t maximum = std::size_t(-1)) const
  {
    std::vector<Candidate> candidates = long_edges(length * length);
    if (candidates.size() > maximum)
      candidates.resize(maximum);
    parallel_for<ConcurrencyTag>(candidates.size(), [&](const std::size_t i) { place_middle(candidates[i]); }, 16);
    std::size_t number_of_splits = 0;
    for (const Candidate& candidate : candidates)
      if (candidate.is_good && is_allowed(candidate))
      {
        split(candidate);
        ++number_of_splits;
      }
    return number_of_splits;
  }

private:
  struct Candidate
  {
    double squared_length;
    Edge_index edge;
    Vertex_state middle;
    bool is_good = false;
  };

  std::vector<Candidate> long_edges(const double squared_length) const
  {
    std::vector<Candidate> candidates;
    for (const Edge_index e : m_mesh.edges())
    {
      const double candidate =
          m_embedding.squared_length(m_mesh.point(m_mesh.vertex(e, 0)), m_mesh.point(m_mesh.vertex(e, 1)));
      if (candidate > squared_length)
        candidates.push_back(Candidate{candidate, e, Vertex_state()});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b)
              { return std::make_pair(-a.squared_length, a.edge) < std::make_pair(-b.squared_length, b.edge); });
    return candidates;
  }

  void place_middle(Candidate& candidate) const
  {
    const Halfedge_index h = m_mesh.halfedge(candidate.edge);
    const Vertex_state &a = m_mesh.point(m_mesh.source(h)), &b = m_mesh.point(m_mesh.target(h));
    if (m_mesh.is_border(candidate.edge))
      place_on_curve(m_mesh.is_border(h) ? a : b, m_mesh.is_border(h) ? b : a, candidate.middle);
    else
      place_on_surface(a, b, candidate.middle);
    const double largest = largest_half * largest_half * candidate.squared_length;
    candidate.is_good = m_embedding.squared_length(a, candidate.middle) < largest &&
                        m_embedding.squared_length(candidate.middle, b) < largest &&
                        candidate.middle.normal.dot(a.normal + b.normal) > 0;
  }

  void place_on_curve(const Vertex_state& from, const Vertex_state& to, Vertex_state& middle) const
  {
    middle.normal = from.normal;
    if (!Boundary_curves::are_on_one_curve(from, to))
      return; // the halves will be too long, and the edge stays
    m_boundary.place(middle, from, 0.5 * m_boundary.distance(from, to));
    m_projection.update_normal(middle);
  }

  void place_on_surface(const Vertex_state& a, const Vertex_state& b, Vertex_state& middle) const
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
    return is_allowed(h, candidate.middle) && is_allowed(m_mesh.opposite(h), candidate.middle);
  }

  bool is_allowed(const Halfedge_index h, const Vertex_state& middle) const
  {
    if (m_mesh.is_border(h))
      return true;
    const Triangle t(h, m_mesh);
    const Vertex_state &a = m_mesh.point(t.a), &b = m_mesh.point(t.b), &c = m_mesh.point(t.c);
    const double before = Face_guard::quality(a, b, c);
    return Face_guard::accepts(Face_guard::quality(a, middle, c), before) &&
           Face_guard::accepts(Face_guard::quality(middle, b, c), before);
  }

  void split(const Candidate& candidate) const
  {
    const Halfedge_index from = CGAL::Euler::split_edge(m_mesh.halfedge(candidate.edge), m_mesh);
    m_mesh.point(m_mesh.target(from)) = candidate.middle;
    if (!m_mesh.is_border(from))
      CGAL::Euler::split_face(from, m_mesh.next(m_mesh.next(from)), m_mesh);
    const Halfedge_index back = m_mesh.opposite(from);
    if (!m_mesh.is_border(back))
      CGAL::Euler::split_face(m_mesh.prev(back), m_mesh.next(back), m_mesh);
  }

  Working_mesh& m_mesh;
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Boundary_curves& m_boundary;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SPLIT_EDGES_H
