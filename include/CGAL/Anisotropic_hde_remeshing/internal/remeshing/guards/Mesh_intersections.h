// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_MESH_INTERSECTIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_MESH_INTERSECTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Intersection_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Near_sheets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Triangle_groups.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/expected_heights.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The faces of the input that are not remeshed, in the unit of the working mesh, and how vertices are numbered with them.
struct Obstacles
{
  std::vector<Indexed_triangle> triangles;
  std::vector<std::size_t> vertex_numbers; // by Vertex_state::input_vertex: their numbers in the triangles
  std::size_t first_free_number = 0;       // of vertices
};

// No operation may let faces intersect other faces or obstacles more often than before. Only faces of other sheets nearby are looked
// at: elsewhere the guards against folds are enough. Whether they were is found out by counts from time to time. Where they were not,
// what was done since the last count is done again, and looks at faces there, too, or at all faces.
template <typename Mesh>
class Mesh_intersections
{
  typedef typename Mesh::Vertex Vertex;

  static constexpr int largest_number_of_attempts = 3; // from one count to the next: at last all faces are looked at
  static constexpr int largest_number_of_restarts = 2; // from the input; after the last one all faces are looked at throughout

public:
  // does nothing unless `is_active`
  Mesh_intersections(const Mesh& mesh, Obstacles obstacles, const bool is_active)
    : m_mesh(mesh), m_obstacles(std::move(obstacles)), m_is_active(is_active)
  {
  }

  bool is_active() const { return m_is_active; }

  // Counts the pairs of the mesh as it is, and finds where sheets of it are near for a mesh with edges of the length. The distance
  // is that of the faces from the mesh as it is now. If it is 0, it follows from the length. Without this call all places count.
  template <typename ConcurrencyTag>
  void find_near_sheets(const double length, const double distance, Interruption& interruption)
  {
    if (!m_is_active || interruption.is_requested())
      return;
    if (m_number_of_restarts == 0)
    {
      const std::vector<Indexed_triangle> triangles = all_triangles<ConcurrencyTag>();
      const Triangle_groups<ConcurrencyTag> groups(triangles);
      const auto pairs = groups.intersecting_pairs(interruption);
      m_number_of_pairs = m_number_of_pairs_before = pairs.size();
      m_sheets = Near_sheets(triangles, groups,
                             distance > 0 ? std::vector<double>(triangles.size(), distance)
                                          : heights_over_triangles<ConcurrencyTag>(triangles, length),
                             length);
      add_sheets(pairs, triangles);
    }
    update_all<ConcurrencyTag>();
  }

  // Counts the pairs of the mesh as it is now. If there are more than at the last count, sheets are near there from now on.
  template <typename ConcurrencyTag>
  void count_pairs()
  {
    if (!m_is_active)
      return;
    Interruption never;
    const std::vector<Indexed_triangle> triangles = all_triangles<ConcurrencyTag>();
    const auto pairs = Triangle_groups<ConcurrencyTag>(triangles).intersecting_pairs(never);
    if (std::exchange(m_number_of_pairs, pairs.size()) < pairs.size())
      add_sheets(pairs, triangles);
  }

  // whether more pairs intersect than before, by the last count
  bool has_more_pairs() const { return m_number_of_pairs > m_number_of_pairs_before; }

  // Calls `remesh()`, and counts. As long as there are more pairs than at the last count, it calls `take_back()`, which makes the mesh as
  // it was, and `remesh()` again: then sheets are near where the pairs were, and in the last attempt everywhere, and faces around a
  // common vertex are looked at, too. Where `remesh()` does nothing because it is interrupted, it is the last attempt.
  template <typename ConcurrencyTag, typename Remesh, typename TakeBack>
  void keep_pairs(const Remesh& remesh, const TakeBack& take_back, const Interruption& interruption)
  {
    const std::size_t last_number = m_number_of_pairs;
    const int last_attempt = has_more_pairs() ? 1 : largest_number_of_attempts;
    for (int attempt = 1;; ++attempt)
    {
      remesh();
      count_pairs<ConcurrencyTag>();
      if (m_number_of_pairs <= last_number || attempt == last_attempt)
        break;
      m_is_everywhere = attempt + 1 == last_attempt || interruption.is_requested();
      take_back();
      m_number_of_pairs = last_number;
      update_all<ConcurrencyTag>();
    }
    const bool is_everywhere = m_number_of_restarts == largest_number_of_restarts;
    if (std::exchange(m_is_everywhere, is_everywhere) != is_everywhere)
      update_all<ConcurrencyTag>();
  }

  // whether it is worth to begin again from the input, as more pairs intersect than before
  bool is_to_restart() const { return has_more_pairs() && m_number_of_restarts < largest_number_of_restarts; }

  // To be called then. After the last restart all faces are looked at throughout.
  void restart()
  {
    m_is_everywhere = ++m_number_of_restarts == largest_number_of_restarts;
    m_number_of_pairs = m_number_of_pairs_before;
  }

  std::size_t number_of_pairs_before() const { return m_number_of_pairs_before; }
  std::size_t number_of_pairs() const { return m_number_of_pairs; }

  // whether another sheet is near anywhere
  bool has_near_sheets() const { return m_is_active && (m_is_everywhere || !m_sheets.empty()); }

  // whether another sheet is near one of the faces at the ends of the edge
  bool is_near_sheet(const Edge_index e) const
  {
    if (!has_near_sheets())
      return false;
    for (const Halfedge_index h : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(h))
        if (!m_mesh.is_border(in) && is_near_sheet(m_mesh.face(in)))
          return true;
    return false;
  }

  // stores all faces anew
  template <typename ConcurrencyTag>
  void update_all()
  {
    if (!m_is_active)
      return;
    m_is_near.assign(face_capacity(m_mesh), 0);
    if (has_near_sheets())
      parallel_for<ConcurrencyTag>(m_is_near.size(),
                                   [&](const std::size_t i)
                                   {
                                     const Face_index f(static_cast<Face_index::size_type>(i));
                                     m_is_near[i] = !m_mesh.is_removed(f) && is_near_sheet(triangle(f, in_mesh()));
                                   });
    store(in_mesh());
  }

  bool accepts(const Local_change<Mesh>& change) const
  {
    if (!m_is_active || std::none_of(change.old_faces().begin(), change.old_faces().end(),
                                     [&](const Face_index f) { return is_near_sheet(f); }))
      return true;
    boost::container::small_vector<std::size_t, 16> old_faces;
    for (const Face_index f : change.old_faces())
      old_faces.push_back(number(f));
    boost::container::small_vector<Indexed_triangle, 16> triangles;
    for (const auto& face : change.new_faces())
    {
      Indexed_triangle t;
      for (std::size_t k = 0; k < 3; ++k)
      {
        t.vertices[k] = vertex_number(face.corners[k].vertex, *face.corners[k].state);
        t.points[k] = face.corners[k].state->point;
      }
      triangles.push_back(t);
    }
    return m_guard.accepts(old_faces, triangles);
  }

  // to be called after the mesh has changed at face f
  void update(const Face_index f)
  {
    if (!has_near_sheets())
      return;
    m_is_near.resize((std::max)(m_is_near.size(), std::size_t(f) + 1), 0);
    const bool was_near = m_is_near[f];
    const Indexed_triangle t = m_mesh.is_removed(f) ? Indexed_triangle() : triangle(f, in_mesh());
    m_is_near[f] = !m_mesh.is_removed(f) && is_near_sheet(t);
    if (m_is_near[f])
      m_guard.replace(number(f), t);
    else if (was_near)
      m_guard.remove(number(f));
  }

  // Takes back moves until no two faces intersect that have not done so before. Where this folds a face, it takes back the
  // moves there, too.
  template <typename ConcurrencyTag>
  void revert(Simultaneous_moves<Mesh>& moves, Interruption& interruption, const Fold_test fold_test)
  {
    if (!has_near_sheets())
      return;
    const auto state_of = [&](const Vertex_index v) -> const Vertex& { return moves.state(v); };
    const std::vector<Face_index> near = store(state_of);
    std::vector<Face_index> faces = intersecting<ConcurrencyTag>(near, moves, interruption);
    while (!faces.empty() && !interruption.is_requested())
    {
      const std::vector<Face_index> changed = near_faces_around(moves.revert(std::move(faces), fold_test));
      for (const Face_index f : changed)
        m_guard.replace(number(f), triangle(f, state_of));
      faces.clear();
      for (const Face_index f : changed)
        add_new_intersections(f, faces);
    }
  }

private:
  // makes the places of the pairs some where sheets are near
  void add_sheets(const std::vector<std::pair<std::size_t, std::size_t>>& pairs, const std::vector<Indexed_triangle>& triangles)
  {
    for (const auto& pair : pairs)
      for (const std::size_t i : {pair.first, pair.second})
        m_sheets.add(triangles[i]);
  }

  // the numbers of the obstacles come before those of the faces
  std::size_t number(const std::size_t f) const { return m_obstacles.triangles.size() + f; }
  bool is_obstacle(const std::size_t number) const { return number < m_obstacles.triangles.size(); }
  Face_index face(const std::size_t number) const
  {
    return Face_index(static_cast<Face_index::size_type>(number - m_obstacles.triangles.size()));
  }

  bool is_near_sheet(const Indexed_triangle& t) const { return m_is_everywhere || m_sheets.contains(t); }
  bool is_near_sheet(const Face_index f) const { return std::size_t(f) < m_is_near.size() && m_is_near[f]; }

  std::size_t vertex_number(const Vertex_index v, const Vertex& state) const
  {
    return m_obstacles.triangles.empty() || state.input_vertex == Vertex_state::no_vertex
               ? m_obstacles.first_free_number + std::size_t(v)
               : m_obstacles.vertex_numbers[state.input_vertex];
  }

  auto in_mesh() const
  {
    return [this](const Vertex_index v) -> const Vertex& { return m_mesh.point(v); };
  }

  template <typename StateOf>
  Indexed_triangle triangle(const Face_index f, const StateOf& state_of) const
  {
    Indexed_triangle result;
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    std::size_t k = 0;
    for (const Vertex_index v : {t.a, t.b, t.c})
    {
      result.vertices[k] = vertex_number(v, m_mesh.point(v));
      result.points[k++] = state_of(v).point;
    }
    return result;
  }

  // the obstacles, and the faces of the mesh
  template <typename ConcurrencyTag>
  std::vector<Indexed_triangle> all_triangles() const
  {
    std::vector<Indexed_triangle> result = m_obstacles.triangles;
    const std::vector<Face_index> faces(m_mesh.faces().begin(), m_mesh.faces().end());
    result.resize(result.size() + faces.size());
    parallel_for<ConcurrencyTag>(faces.size(), [&](const std::size_t i) { result[number(i)] = triangle(faces[i], in_mesh()); });
    return result;
  }

  // Stores the faces near to other sheets, with their vertices where `state_of(vertex)` has them, and the obstacles. Returns these
  // faces.
  template <typename StateOf>
  std::vector<Face_index> store(const StateOf& state_of)
  {
    std::vector<Face_index> near;
    std::vector<Intersection_guard::Numbered_triangle> triangles;
    for (std::size_t i = 0; i < m_obstacles.triangles.size() && has_near_sheets(); ++i)
      if (is_near_sheet(m_obstacles.triangles[i]))
        triangles.emplace_back(i, m_obstacles.triangles[i]);
    for (std::size_t i = 0; i < m_is_near.size(); ++i)
    {
      const Face_index f(static_cast<Face_index::size_type>(i));
      if (!m_is_near[i] || m_mesh.is_removed(f))
        continue;
      near.push_back(f);
      triangles.emplace_back(number(i), triangle(f, state_of));
    }
    m_guard.look_at_neighbors(m_is_everywhere);
    m_guard.assign(triangles);
    return near;
  }

  // The numbers of what intersects face f after the moves, but did not do so in the mesh. Only numbers asked for are looked at.
  template <typename IsAskedFor>
  std::vector<std::size_t> new_intersections(const Face_index f, const IsAskedFor& is_asked_for) const
  {
    std::vector<std::size_t> result = m_guard.intersecting(number(f), is_asked_for);
    if (result.empty())
      return result;
    const Indexed_triangle before = triangle(f, in_mesh());
    result.erase(std::remove_if(result.begin(), result.end(),
                                [&](const std::size_t g) {
                                  return do_triangles_intersect(before, is_obstacle(g) ? m_obstacles.triangles[g]
                                                                                       : triangle(face(g), in_mesh()));
                                }),
                 result.end());
    return result;
  }

  // adds the new intersections of face f, and the face itself for each of them
  void add_new_intersections(const Face_index f, std::vector<Face_index>& faces) const
  {
    for (const std::size_t g : new_intersections(f, [](std::size_t) { return true; }))
    {
      faces.push_back(f);
      if (!is_obstacle(g))
        faces.push_back(face(g));
    }
  }

  // the faces that newly intersect others, and these others
  template <typename ConcurrencyTag>
  std::vector<Face_index> intersecting(const std::vector<Face_index>& near, const Simultaneous_moves<Mesh>& moves,
                                       Interruption& interruption) const
  {
    const auto is_moved = [&](const Face_index f)
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      return moves.is_moved(t.a) || moves.is_moved(t.b) || moves.is_moved(t.c);
    };
    // if two faces have both moved, only the first one looks at the other
    std::vector<char> is_intersecting(near.size(), 0);
    parallel_for<ConcurrencyTag>(
        near.size(),
        [&](const std::size_t i)
        {
          const Face_index f = near[i];
          if (!is_moved(f))
            return;
          const auto is_other = [&](const std::size_t g) { return g > number(f) || is_obstacle(g) || !is_moved(face(g)); };
          is_intersecting[i] = !new_intersections(f, is_other).empty();
        },
        64, interruption);
    std::vector<Face_index> result;
    for (std::size_t i = 0; i < near.size(); ++i)
      if (is_intersecting[i])
        add_new_intersections(near[i], result);
    return result;
  }

  // the faces around the vertices to which another sheet is near, each once
  std::vector<Face_index> near_faces_around(const std::vector<Vertex_index>& vertices) const
  {
    std::vector<Face_index> result;
    for (const Vertex_index v : vertices)
      for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if (!m_mesh.is_border(h) && is_near_sheet(m_mesh.face(h)))
          result.push_back(m_mesh.face(h));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Mesh& m_mesh;
  const Obstacles m_obstacles;
  const bool m_is_active;
  Near_sheets m_sheets;
  bool m_is_everywhere = false;
  std::vector<char> m_is_near; // by face; the guard has these faces
  Intersection_guard m_guard;
  std::size_t m_number_of_pairs_before = 0, m_number_of_pairs = 0;
  int m_number_of_restarts = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_MESH_INTERSECTIONS_H
