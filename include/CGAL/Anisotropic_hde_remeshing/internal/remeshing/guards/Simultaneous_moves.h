// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_SIMULTANEOUS_MOVES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_SIMULTANEOUS_MOVES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/folded_edge.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Face_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// what counts as a fold
enum class Fold_test
{
  EDGES, // while the vertices have no normals yet; a face that loses its height counts as a fold, too
  NORMALS_AND_EDGES
};

// New states of vertices that all move at once. Moves that would fold faces are taken back. The result does not depend on the
// order of the vertices.
template <typename Mesh>
class Simultaneous_moves
{
  typedef typename Mesh::Vertex Vertex;
  typedef typename Mesh::Sides Sides;

  static constexpr double flat_cosine = 0.82, flat_cosine_of_normals = 0.5;

public:
  explicit Simultaneous_moves(const Mesh& mesh) : m_mesh(mesh) { clear(); }

  // prepares for moves of the mesh as it is now, in the memory of the last moves
  void clear()
  {
    m_states.resize(vertex_capacity(m_mesh));
    m_sides.resize(vertex_capacity(m_mesh));
    m_is_moved.assign(vertex_capacity(m_mesh), 0);
  }

  // Calls `propose(vertex, state, sides)` concurrently for every vertex for which `is_chosen(vertex)` holds. The call returns
  // whether the vertex moves, and changes `state`, and on a crease `sides`, to where it moves. Both come as they are in the
  // mesh. The mesh does not change meanwhile.
  template <typename ConcurrencyTag, typename IsChosen, typename Propose>
  void propose(const IsChosen& is_chosen, const Propose& propose, Interruption& interruption)
  {
    parallel_for<ConcurrencyTag>(
        m_states.size(),
        [&](const std::size_t i)
        {
          const Vertex_index v(static_cast<Vertex_index::size_type>(i));
          if (m_mesh.is_removed(v) || !is_chosen(v))
            return;
          m_states[i] = m_mesh.point(v);
          if (m_states[i].is_on_crease)
            m_sides[i] = m_mesh.sides(v);
          else
            m_sides[i].clear();
          m_is_moved[i] = propose(v, m_states[i], m_sides[i]);
        },
        64, interruption);
  }

  bool is_moved(const Vertex_index v) const { return m_is_moved[v]; }

  // where the vertex will be
  const Vertex& state(const Vertex_index v) const { return m_is_moved[v] ? m_states[v] : m_mesh.point(v); }

  // the vertex as the face of h will see it
  const Vertex& state(const Vertex_index v, const Halfedge_index h) const
  {
    if (!m_is_moved[v])
      return m_mesh.state(v, h);
    return m_states[v].is_on_crease ? Mesh::side(m_sides[v], m_mesh.region(h)) : m_states[v];
  }

  // Takes back the moves of the vertices of folded faces. This may fold other faces: their vertices are next, until no face is
  // folded. It ends because each round takes back at least one move. Returns how many moves it took back.
  template <typename ConcurrencyTag>
  std::size_t revert_folds(Interruption& interruption, const Fold_test test = Fold_test::NORMALS_AND_EDGES)
  {
    return revert(folded_faces<ConcurrencyTag>(interruption, test), test).size();
  }

  // Takes back the moves of the vertices of these faces, and then of the faces that this has folded. Returns all vertices whose
  // moves it took back.
  std::vector<Vertex_index> revert(std::vector<Face_index> faces, const Fold_test test = Fold_test::NORMALS_AND_EDGES)
  {
    std::vector<Vertex_index> result;
    while (!faces.empty())
    {
      const std::vector<Vertex_index> reverted = revert_vertices(faces);
      result.insert(result.end(), reverted.begin(), reverted.end());
      faces.clear();
      for (const Vertex_index v : reverted)
        for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
          if (!m_mesh.is_border(h))
            add_if_folded(h, test, faces);
    }
    return result;
  }

  // Takes back the moves of both ends of the edges for which `is_bad(edge)` holds, until no such edge has an end that moves. It
  // ends because each round takes back at least one move. This may fold faces: ask for folds afterwards.
  template <typename ConcurrencyTag, typename IsBad>
  void revert_edges(const IsBad& is_bad, Interruption& interruption)
  {
    std::vector<char> is_reverted(edge_capacity(m_mesh));
    for (bool is_any_reverted = true; is_any_reverted && !interruption.is_requested();)
    {
      parallel_for<ConcurrencyTag>(
          is_reverted.size(),
          [&](const std::size_t i)
          {
            const Edge_index e(static_cast<Edge_index::size_type>(i));
            is_reverted[i] =
                !m_mesh.is_removed(e) && (is_moved(m_mesh.vertex(e, 0)) || is_moved(m_mesh.vertex(e, 1))) && is_bad(e);
          },
          256, interruption);
      is_any_reverted = false;
      for (std::size_t i = 0; i < is_reverted.size(); ++i)
        if (is_reverted[i])
        {
          const Edge_index e(static_cast<Edge_index::size_type>(i));
          m_is_moved[m_mesh.vertex(e, 0)] = m_is_moved[m_mesh.vertex(e, 1)] = 0;
          is_any_reverted = true;
        }
    }
  }

  // makes the moves in the mesh
  template <typename ConcurrencyTag>
  void accept(Mesh& mesh) const
  {
    parallel_for<ConcurrencyTag>(m_states.size(),
                                 [&](const std::size_t i)
                                 {
                                   if (!m_is_moved[i])
                                     return;
                                   const Vertex_index v(static_cast<Vertex_index::size_type>(i));
                                   mesh.point(v) = m_states[i];
                                   if (m_states[i].is_on_crease)
                                     mesh.sides(v) = m_sides[i];
                                 });
  }

private:
  // What is known of a face. Two flat faces do not fold over their edge. The edge of two unmoved faces is as it was.
  enum : char
  {
    BENT,
    FLAT,
    UNMOVED
  };

  template <typename ConcurrencyTag>
  std::vector<Face_index> folded_faces(Interruption& interruption, const Fold_test test) const
  {
    std::vector<char> is_folded(face_capacity(m_mesh), 0), shapes(face_capacity(m_mesh), BENT);
    const auto for_each_face = [&](const auto& visit)
    {
      parallel_for<ConcurrencyTag>(
          is_folded.size(),
          [&](const std::size_t i)
          {
            const Face_index f(static_cast<Face_index::size_type>(i));
            if (!m_mesh.is_removed(f))
              visit(f);
          },
          256, interruption);
    };
    for_each_face([&](const Face_index f) { is_folded[f] = folds(f, test, shapes[f]); });
    for_each_face(
        [&](const Face_index f)
        {
          for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
          {
            const Face_index g = m_mesh.face(m_mesh.opposite(h));
            if (g.is_valid() && (shapes[f] != shapes[g] || shapes[f] == BENT) && folds_over_edge(h))
              is_folded[f] = 1;
          }
        });
    std::vector<Face_index> result;
    for (std::size_t i = 0; i < is_folded.size(); ++i)
      if (is_folded[i])
        result.push_back(Face_index(static_cast<Face_index::size_type>(i)));
    return result;
  }

  // adds the face of h and the faces beyond its edges, if they are folded
  void add_if_folded(const Halfedge_index h, const Fold_test test, std::vector<Face_index>& faces) const
  {
    char shape = BENT;
    bool is_folded = folds(m_mesh.face(h), test, shape);
    for (const Halfedge_index side : m_mesh.halfedges_around_face(h))
    {
      const Halfedge_index beyond = m_mesh.opposite(side);
      if (m_mesh.is_border(beyond) || !folds_over_edge(side))
        continue;
      is_folded = true;
      faces.push_back(m_mesh.face(beyond));
    }
    if (is_folded)
      faces.push_back(m_mesh.face(h));
  }

  // Whether the moves fold the face itself. `shape` is set to what is known of the face, or is not changed.
  bool folds(const Face_index f, const Fold_test test, char& shape) const
  {
    const Halfedge_index h = m_mesh.halfedge(f);
    const Triangle t(h, m_mesh);
    if (!m_is_moved[t.a] && !m_is_moved[t.b] && !m_is_moved[t.c])
    {
      shape = UNMOVED;
      return false;
    }
    if (test == Fold_test::NORMALS_AND_EDGES)
      return folds_over_normals(t, h, shape);
    return moved_normal(h).isZero(0) && !face_normal(h, m_mesh).isZero(0);
  }

  // Whether the moves fold the face over the normals of its vertices. The face is FLAT if it cannot fold over an edge with
  // another FLAT face either. For this its three normals are within 60 degrees of each other. Then their sum is within 35.3
  // degrees of the sum of two of them. The normal of the face is within 34.9 degrees of the sum of the three. On both sides of
  // an edge together that is less than 141 degrees. This does not hold over a crease, where the faces have different normals.
  bool folds_over_normals(const Triangle& t, const Halfedge_index h, char& shape) const
  {
    const Vertex &a = state(t.a, h), &b = state(t.b, h), &c = state(t.c, h);
    const Face_quality after(a, b, c);
    if (after.cosine > flat_cosine && !after.is_flat() && !a.is_on_crease && !b.is_on_crease && !c.is_on_crease &&
        (std::min)({a.normal.dot(b.normal), b.normal.dot(c.normal), c.normal.dot(a.normal)}) > flat_cosine_of_normals)
      shape = FLAT;
    if (after.is_good())
      return false;
    const Corners<Mesh> corners(t, h, m_mesh);
    const Face_quality before(corners.a, corners.b, corners.c);
    return is_folded_by(after, before) || is_flattened_by(after, before);
  }

  // whether the moves fold the edge of h; this edge is not on the border
  bool folds_over_edge(const Halfedge_index h) const
  {
    const Halfedge_index g = m_mesh.opposite(h);
    return is_folded_edge(moved_normal(h), moved_normal(g)) && !is_folded_edge(face_normal(h, m_mesh), face_normal(g, m_mesh));
  }

  Vector moved_normal(const Halfedge_index h) const
  {
    const Triangle t(h, m_mesh);
    return face_normal(state(t.a), state(t.b), state(t.c));
  }

  // takes back the moves of the vertices of these faces; returns the vertices that had moved
  std::vector<Vertex_index> revert_vertices(const std::vector<Face_index>& faces)
  {
    std::vector<Vertex_index> result;
    for (const Face_index f : faces)
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
  std::vector<Sides> m_sides;
  std::vector<char> m_is_moved;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_SIMULTANEOUS_MOVES_H
