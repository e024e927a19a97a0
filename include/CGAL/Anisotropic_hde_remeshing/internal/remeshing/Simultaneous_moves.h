// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SIMULTANEOUS_MOVES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SIMULTANEOUS_MOVES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Face_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// New states of vertices that all move at once, of which those are taken back that would fold faces over: what is done does
// not depend on the order of the vertices.
template <typename Mesh>
class Simultaneous_moves
{
  typedef typename Mesh::Vertex Vertex;

public:
  explicit Simultaneous_moves(const Mesh& mesh) : m_mesh(mesh) { clear(); }

  // for moves of the mesh as it is by now, in the memory of the last ones
  void clear()
  {
    m_states.resize(vertex_capacity(m_mesh));
    m_is_moved.assign(vertex_capacity(m_mesh), 0);
  }

  // Asks `propose(vertex, state)` of every vertex for which `is_chosen(vertex)`, concurrently, whether it moves and whereto:
  // `state` comes as it is in the mesh, which does not change meanwhile.
  template <typename ConcurrencyTag, typename IsChosen, typename Propose>
  void propose(const IsChosen& is_chosen, const Propose& propose, Interruption& interruption)
  {
    parallel_for<ConcurrencyTag>(m_states.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Vertex_index v(static_cast<Vertex_index::size_type>(i));
                                   if (m_mesh.is_removed(v) || !is_chosen(v))
                                     return;
                                   m_states[i] = m_mesh.point(v);
                                   m_is_moved[i] = propose(v, m_states[i]);
                                 },
                                 64, interruption);
  }

  bool is_moved(const Vertex_index v) const { return m_is_moved[v]; }

  const Vertex& state(const Vertex_index v) const { return m_is_moved[v] ? m_states[v] : m_mesh.point(v); }

  // Takes back the moves of the vertices of folded faces, and then of those that this has folded, until there are none: each
  // round takes back at least one move. Returns how many moves it took back.
  template <typename ConcurrencyTag>
  std::size_t revert_folds(Interruption& interruption)
  {
    std::vector<char> is_folded(face_capacity(m_mesh), 0);
    parallel_for<ConcurrencyTag>(
        is_folded.size(),
        [&](const std::size_t i)
        {
          const Face_index f(static_cast<Face_index::size_type>(i));
          is_folded[i] = !m_mesh.is_removed(f) && folds(f);
        },
        256, interruption);
    std::vector<Face_index> folded;
    for (std::size_t i = 0; i < is_folded.size(); ++i)
      if (is_folded[i])
        folded.push_back(Face_index(static_cast<Face_index::size_type>(i)));
    std::size_t number_of_reverted = 0;
    while (!folded.empty())
    {
      const std::vector<Vertex_index> reverted = revert(folded);
      number_of_reverted += reverted.size();
      folded.clear();
      for (const Vertex_index v : reverted)
        for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
          if (!m_mesh.is_border(h) && folds(m_mesh.face(h)))
            folded.push_back(m_mesh.face(h));
    }
    return number_of_reverted;
  }

  // changes the mesh
  template <typename ConcurrencyTag>
  void accept(Mesh& mesh) const
  {
    parallel_for<ConcurrencyTag>(m_states.size(),
                                 [&](const std::size_t i)
                                 {
                                   if (m_is_moved[i])
                                     mesh.point(Vertex_index(static_cast<Vertex_index::size_type>(i))) = m_states[i];
                                 });
  }

private:
  // whether the moves fold the face
  bool folds(const Face_index f) const
  {
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    if (!m_is_moved[t.a] && !m_is_moved[t.b] && !m_is_moved[t.c])
      return false;
    const double after = Face_guard::quality(state(t.a), state(t.b), state(t.c));
    return after < Face_guard::smallest_cosine &&
           !Face_guard::accepts(after, Face_guard::quality(m_mesh.point(t.a), m_mesh.point(t.b), m_mesh.point(t.c)));
  }

  // the vertices whose moves it takes back
  std::vector<Vertex_index> revert(const std::vector<Face_index>& folded)
  {
    std::vector<Vertex_index> result;
    for (const Face_index f : folded)
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      for (const Vertex_index v : {t.a, t.b, t.c})
        if (m_is_moved[v])
        {
          m_is_moved[v] = 0;
          result.push_back(v);
        }
    }
    return result;
  }

  const Mesh& m_mesh;
  std::vector<Vertex> m_states;
  std::vector<char> m_is_moved;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SIMULTANEOUS_MOVES_H
