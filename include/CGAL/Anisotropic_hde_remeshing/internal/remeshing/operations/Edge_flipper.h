// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPPER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPPER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/embedded_triangle.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

enum class Flip_criterion
{
  VALENCE, // towards six neighbours inside, four on the boundary
  ANGLE    // towards a larger smallest angle in the embedding
};

// Flips edges where the criterion gains, in passes over the edges whose surroundings have changed. A pass finds out in parallel
// which edges gain. It flips them one after the other, and looks again only at edges next to an earlier flip.
template <typename ConcurrencyTag, typename Embedding, typename Guard>
class Edge_flipper
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;
  typedef Local_change<Mesh> Change;

  static constexpr int maximum_number_of_passes = 10;
  // the gain in the cosine below which a flip is not worth it; it also ends the passes in the case of ties
  static constexpr double smallest_gain = 1e-6;
  // the cosine of 15 degrees: valence flips leave no smaller angle, unless there was a smaller one before
  static constexpr double largest_cosine_of_valence_flip = 0.9659258262890683;

public:
  Edge_flipper(Mesh& mesh, const Embedding& embedding, const Guard& guard, Interruption& interruption)
    : m_mesh(mesh), m_embedding(embedding), m_guard(guard), m_interruption(interruption)
  {
  }

  // Returns the number of flips. A pass flips edges in the order of the mesh. The next pass looks at the edges around them.
  // Only few edges are flipped, so it is enough to find them in parallel.
  std::size_t operator()(const Flip_criterion criterion) const
  {
    std::vector<char> is_queued(edge_capacity(m_mesh), 0);
    std::vector<int> valences;
    if (criterion == Flip_criterion::VALENCE)
      valences = compute_valences();
    std::vector<Edge_index> queue = all_edges();
    std::size_t number_of_flips = 0;
    for (int pass = 0; pass < maximum_number_of_passes && !queue.empty() && !m_interruption.is_requested(); ++pass)
    {
      const std::vector<Edge_index> flipped = flip(gaining(queue, criterion, valences), criterion, valences);
      number_of_flips += flipped.size();
      queue = surroundings(flipped, is_queued);
    }
    return number_of_flips;
  }

private:
  // the two faces of an edge from a to b; c and d are their third vertices
  struct Quad
  {
    Vertex_index a, b, c, d;
  };

  // the states of these vertices; an edge inside a region has one state of each
  struct Quad_states
  {
    const Vertex &a, &b, &c, &d;

    Quad_states(const Edge_index e, const Quad& q, const Mesh& mesh) : Quad_states(mesh.halfedge(e), q, mesh) {}
    Quad_states(const Halfedge_index h, const Quad& q, const Mesh& mesh)
      : a(mesh.state(q.a, h)), b(mesh.state(q.b, h)), c(mesh.state(q.c, h)), d(mesh.state(q.d, h))
    {
    }
  };

  Quad quad(const Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h)), m_mesh.target(m_mesh.next(g))};
  }

  std::vector<Edge_index> all_edges() const
  {
    std::vector<Edge_index> edges;
    edges.reserve(m_mesh.number_of_edges());
    for (const Edge_index e : m_mesh.edges())
      edges.push_back(e);
    return edges;
  }

  std::vector<int> compute_valences() const
  {
    // An inner vertex wants six edges, a boundary vertex four. Two are added at the boundary, so that every vertex wants six.
    std::vector<int> valences(vertex_capacity(m_mesh), 0);
    parallel_for<ConcurrencyTag>(
        valences.size(),
        [&](const std::size_t i)
        {
          const Vertex_index v(static_cast<Vertex_index::size_type>(i));
          if (!m_mesh.is_removed(v))
            for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
              valences[i] += m_mesh.is_border(h) ? 3 : 1;
        },
        256, m_interruption);
    return valences;
  }

  // the edges that gain by a flip, in the given order
  std::vector<Edge_index> gaining(const std::vector<Edge_index>& edges, const Flip_criterion criterion,
                                  const std::vector<int>& valences) const
  {
    std::vector<char> is_gain(edges.size(), 0);
    parallel_for<ConcurrencyTag>(
        edges.size(), [&](const std::size_t i) { is_gain[i] = gains(edges[i], criterion, valences); }, 64, m_interruption);
    std::vector<Edge_index> result;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (is_gain[i])
        result.push_back(edges[i]);
    return result;
  }

  // Flips the edges one after the other. An edge is left out if an earlier flip has taken its gain. Returns the edges that were
  // flipped.
  std::vector<Edge_index> flip(const std::vector<Edge_index>& edges, const Flip_criterion criterion,
                               std::vector<int>& valences) const
  {
    std::vector<Edge_index> flipped;
    std::vector<char> is_touched(vertex_capacity(m_mesh), 0);
    for (const Edge_index e : edges)
    {
      if (m_interruption.poll())
        break;
      const Quad q = quad(e);
      const bool is_changed = is_touched[q.a] || is_touched[q.b] || is_touched[q.c] || is_touched[q.d] || !m_guard.is_local();
      if (is_changed && !gains(e, criterion, valences))
        continue;
      flip(e, q, valences);
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

  bool gains(const Edge_index e, const Flip_criterion criterion, const std::vector<int>& valences) const
  {
    if (m_mesh.is_on_curve(e))
      return false;
    const Quad q = quad(e);
    return (criterion == Flip_criterion::VALENCE ? gains_valence(e, q, valences) : gains_angle(e, q)) && is_allowed(e, q);
  }

  bool gains_valence(const Edge_index e, const Quad& q, const std::vector<int>& valences) const
  {
    const auto square = [](const int x) { return x * x; };
    const int before =
        square(valences[q.a] - 6) + square(valences[q.b] - 6) + square(valences[q.c] - 6) + square(valences[q.d] - 6);
    const int after =
        square(valences[q.a] - 7) + square(valences[q.b] - 7) + square(valences[q.c] - 5) + square(valences[q.d] - 5);
    if (after >= before)
      return false;
    double cosine_before, cosine_after;
    largest_cosines(e, q, cosine_before, cosine_after);
    return !(cosine_after > (std::max)(cosine_before, largest_cosine_of_valence_flip));
  }

  bool gains_angle(const Edge_index e, const Quad& q) const
  {
    double cosine_before, cosine_after;
    largest_cosines(e, q, cosine_before, cosine_after);
    return cosine_after < cosine_before - smallest_gain;
  }

  // `valences` are empty if they do not matter
  void flip(const Edge_index e, const Quad& q, std::vector<int>& valences) const
  {
    if (!valences.empty())
    {
      --valences[q.a];
      --valences[q.b];
      ++valences[q.c];
      ++valences[q.d];
    }
    CGAL::Euler::flip_edge(m_mesh.halfedge(e), m_mesh.graph());
    m_guard.update_at(m_mesh.halfedge(e));
  }

  // the cosines of the smallest angles in the embedding of the two faces, now and after a flip
  void largest_cosines(const Edge_index e, const Quad& q, double& before, double& after) const
  {
    const Quad_states s(e, q, m_mesh);
    const Vertex &a = s.a, &b = s.b, &c = s.c, &d = s.d;
    const double ab = m_embedding.squared_length(a, b), bc = m_embedding.squared_length(b, c),
                 ca = m_embedding.squared_length(c, a), ad = m_embedding.squared_length(a, d),
                 db = m_embedding.squared_length(d, b), cd = m_embedding.squared_length(c, d);
    before = (std::max)(Embedded_triangle::largest_cosine(ab, bc, ca), Embedded_triangle::largest_cosine(ab, ad, db));
    after = (std::max)(Embedded_triangle::largest_cosine(cd, ca, ad), Embedded_triangle::largest_cosine(cd, db, bc));
  }

  // whether the mesh stays a manifold, and what the guard says
  bool is_allowed(const Edge_index e, const Quad& q) const
  {
    return q.c != q.d && !m_mesh.halfedge(q.c, q.d).is_valid() && m_mesh.degree(q.a) > 3 && m_mesh.degree(q.b) > 3 &&
           m_guard.accepts(exchange(e, q));
  }

  // what a flip changes
  Change exchange(const Edge_index e, const Quad& q) const
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
  const Embedding& m_embedding;
  const Guard& m_guard;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPPER_H
