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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
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

// The faces of the input that are not remeshed, in the unit of the working mesh.
struct Obstacles
{
  std::vector<Indexed_triangle> triangles;
  std::vector<std::size_t> vertex_numbers; // by Vertex_state::input_vertex: their numbers in the triangles
  std::size_t first_free_number = 0;       // of vertices
};

// takes the place of `Mesh_intersections` where nobody asks for them
class No_intersections
{
public:
  bool is_active() const { return false; }
  template <typename ConcurrencyTag, typename StateOf>
  void assign(const StateOf&, Interruption&)
  {
  }
  template <typename Change>
  bool accepts(const Change&) const
  {
    return true;
  }
  void update(Face_index) {}
  template <typename ConcurrencyTag, typename Moves>
  void revert(Moves&, Interruption&, Fold_test)
  {
  }
};

// No operation may let a face intersect another face or an obstacle, unless one of the faces before the operation did so
// already.
template <typename Mesh, typename Kernel = Exact_predicates_inexact_constructions_kernel>
class Mesh_intersections
{
  typedef typename Mesh::Vertex Vertex;

public:
  // does nothing unless `is_active`
  Mesh_intersections(const Mesh& mesh, Obstacles obstacles, const bool is_active)
    : m_mesh(mesh), m_obstacles(std::move(obstacles)), m_is_active(is_active)
  {
  }

  bool is_active() const { return m_is_active; }

  // stores all faces anew, with their vertices where `state_of(vertex)` has them
  template <typename ConcurrencyTag, typename StateOf>
  void assign(const StateOf& state_of, Interruption& interruption)
  {
    if (!m_is_active)
      return;
    std::vector<Indexed_triangle> triangles = m_obstacles.triangles;
    std::vector<char> is_used(triangles.size(), 1);
    triangles.resize(number(face_capacity(m_mesh)));
    is_used.resize(triangles.size(), 0);
    parallel_for<ConcurrencyTag>(
        face_capacity(m_mesh),
        [&](const std::size_t i)
        {
          const Face_index f(static_cast<Face_index::size_type>(i));
          if (m_mesh.is_removed(f))
            return;
          triangles[number(i)] = triangle(f, state_of);
          is_used[number(i)] = 1;
        },
        256, interruption);
    m_guard.assign(std::move(triangles), std::move(is_used));
  }

  bool accepts(const Local_change<Mesh>& change) const
  {
    if (!m_is_active)
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
    if (!m_is_active)
      return;
    if (m_mesh.is_removed(f))
      m_guard.remove(number(f));
    else
      m_guard.replace(number(f), triangle(f, [&](const Vertex_index v) -> const Vertex& { return m_mesh.point(v); }));
  }

  // Takes back moves until no two faces intersect that have not done so before. Where this folds a face, it takes back the
  // moves there, too.
  template <typename ConcurrencyTag>
  void revert(Simultaneous_moves<Mesh>& moves, Interruption& interruption, const Fold_test fold_test)
  {
    if (!m_is_active)
      return;
    const auto state_of = [&](const Vertex_index v) -> const Vertex& { return moves.state(v); };
    assign<ConcurrencyTag>(state_of, interruption);
    std::vector<Face_index> faces = intersecting<ConcurrencyTag>(moves, interruption);
    while (!faces.empty() && !interruption.is_requested())
    {
      const std::vector<Face_index> changed = faces_around(moves.revert(std::move(faces), fold_test));
      for (const Face_index f : changed)
        m_guard.replace(number(f), triangle(f, state_of));
      faces.clear();
      for (const Face_index f : changed)
        add_new_intersections(f, faces);
    }
  }

private:
  // the numbers of the obstacles come before those of the faces
  std::size_t number(const std::size_t f) const { return m_obstacles.triangles.size() + f; }
  bool is_obstacle(const std::size_t number) const { return number < m_obstacles.triangles.size(); }
  Face_index face(const std::size_t number) const
  {
    return Face_index(static_cast<Face_index::size_type>(number - m_obstacles.triangles.size()));
  }

  std::size_t vertex_number(const Vertex_index v, const Vertex& state) const
  {
    return m_obstacles.triangles.empty() || state.input_vertex == Vertex_state::no_vertex
               ? m_obstacles.first_free_number + std::size_t(v)
               : m_obstacles.vertex_numbers[state.input_vertex];
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

  // The numbers of what intersects face f after the moves, but did not do so in the mesh. Only numbers asked for are looked at.
  template <typename IsAskedFor>
  std::vector<std::size_t> new_intersections(const Face_index f, const IsAskedFor& is_asked_for) const
  {
    const auto in_mesh = [&](const Vertex_index v) -> const Vertex& { return m_mesh.point(v); };
    std::vector<std::size_t> result = m_guard.intersecting(number(f), is_asked_for);
    if (result.empty())
      return result;
    const Indexed_triangle before = triangle(f, in_mesh);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [&](const std::size_t g) {
                                  return do_triangles_intersect<Kernel>(before, is_obstacle(g) ? m_obstacles.triangles[g]
                                                                                               : triangle(face(g), in_mesh));
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
  std::vector<Face_index> intersecting(const Simultaneous_moves<Mesh>& moves, Interruption& interruption) const
  {
    const auto is_moved = [&](const Face_index f)
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      return moves.is_moved(t.a) || moves.is_moved(t.b) || moves.is_moved(t.c);
    };
    // if two faces have both moved, only the first one looks at the other
    std::vector<char> is_intersecting(face_capacity(m_mesh), 0);
    parallel_for<ConcurrencyTag>(
        is_intersecting.size(),
        [&](const std::size_t i)
        {
          const Face_index f(static_cast<Face_index::size_type>(i));
          if (m_mesh.is_removed(f) || !is_moved(f))
            return;
          const auto is_other = [&](const std::size_t g) { return g > number(i) || is_obstacle(g) || !is_moved(face(g)); };
          is_intersecting[i] = !new_intersections(f, is_other).empty();
        },
        64, interruption);
    std::vector<Face_index> result;
    for (std::size_t i = 0; i < is_intersecting.size(); ++i)
      if (is_intersecting[i])
        add_new_intersections(Face_index(static_cast<Face_index::size_type>(i)), result);
    return result;
  }

  // the faces around the vertices, each once
  std::vector<Face_index> faces_around(const std::vector<Vertex_index>& vertices) const
  {
    std::vector<Face_index> result;
    for (const Vertex_index v : vertices)
      for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if (!m_mesh.is_border(h))
          result.push_back(m_mesh.face(h));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Mesh& m_mesh;
  const Obstacles m_obstacles;
  const bool m_is_active;
  Intersection_guard<Kernel> m_guard;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_MESH_INTERSECTIONS_H
