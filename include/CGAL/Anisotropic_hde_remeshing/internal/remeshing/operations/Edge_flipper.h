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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/embedded_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_flips.h>

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

// Flips edges where the criterion gains.
template <typename ConcurrencyTag, typename Embedding, typename Guard>
class Edge_flipper
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;
  typedef Edge_flips<ConcurrencyTag, Mesh, Guard> Flips;
  typedef typename Flips::Quad Quad;

  static constexpr int maximum_number_of_passes = 10;
  // the gain in the cosine below which a flip is not worth it; it also ends the passes in the case of ties
  static constexpr double smallest_gain = 1e-6;
  // the cosine of 15 degrees: valence flips leave no smaller angle, unless there was a smaller one before
  static constexpr double largest_cosine_of_valence_flip = 0.9659258262890683;

public:
  Edge_flipper(Mesh& mesh, const Embedding& embedding, const Guard& guard, Interruption& interruption)
    : m_mesh(mesh), m_embedding(embedding), m_flips(mesh, guard, interruption), m_interruption(interruption)
  {
  }

  // returns the number of flips
  std::size_t operator()(const Flip_criterion criterion) const
  {
    std::vector<int> valences;
    if (criterion == Flip_criterion::VALENCE)
      valences = compute_valences();
    return m_flips(
        maximum_number_of_passes, [&](const Edge_index e) { return gains(e, criterion, valences); },
        [&](const Edge_index e) { flip(e, valences); });
  }

private:
  // the states of the vertices of a quad; an edge inside a region has one state of each
  struct Quad_states
  {
    const Vertex &a, &b, &c, &d;

    Quad_states(const Edge_index e, const Quad& q, const Mesh& mesh) : Quad_states(mesh.halfedge(e), q, mesh) {}
    Quad_states(const Halfedge_index h, const Quad& q, const Mesh& mesh)
      : a(mesh.state(q.a, h)), b(mesh.state(q.b, h)), c(mesh.state(q.c, h)), d(mesh.state(q.d, h))
    {
    }
  };

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

  bool gains(const Edge_index e, const Flip_criterion criterion, const std::vector<int>& valences) const
  {
    if (m_mesh.is_on_curve(e))
      return false;
    const Quad q = m_flips.quad(e);
    return (criterion == Flip_criterion::VALENCE ? gains_valence(e, q, valences) : gains_angle(e, q)) &&
           m_flips.is_allowed(e, q);
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
  void flip(const Edge_index e, std::vector<int>& valences) const
  {
    if (!valences.empty())
    {
      const Quad q = m_flips.quad(e);
      --valences[q.a];
      --valences[q.b];
      ++valences[q.c];
      ++valences[q.d];
    }
    m_flips.flip(e);
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

  const Mesh& m_mesh;
  const Embedding& m_embedding;
  const Flips m_flips;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_FLIPPER_H
