// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_OPERATION_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_OPERATION_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Deviation_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Face_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Fold_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Landmark_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <boost/container/small_vector.hpp>

#include <memory>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What is asked of every operation. The guard judges by the change alone. No face may be folded or flattened, and none may fold
// over an edge. If it is asked for, no face may be too far from the surface, or intersect another one, and no landmark may be left
// behind.
template <typename Mesh, typename Function>
class Operation_guard
{
  typedef Local_change<Mesh> Change;

public:
  Operation_guard(const Mesh& mesh, const Function& function, Mesh_intersections<Mesh>& intersections)
    : m_mesh(mesh), m_faces(mesh), m_folds(mesh), m_deviation(function), m_intersections(intersections)
  {
  }

  void set_largest_distance(const double distance) { m_deviation.set_largest_distance(distance); }

  // whether flat faces are allowed that are no slivers
  void allow_caps(const bool is_allowed) { m_faces.allow_caps(is_allowed); }

  // whether `accepts()` depends only on what is next to an operation at the edge
  bool is_local(const Edge_index e) const { return !m_intersections.is_near_sheet(e); }

  // whether `update(change)` looks at the change
  bool needs_changes() const { return m_intersections.is_active() || m_landmarks; }

  // what the tests of intersections know
  Mesh_intersections<Mesh>& intersections() const { return m_intersections; }

  // From now on the vertices of the mesh are landmarks. Their distances are bounded by the heights. `diagonal` is that of the mesh.
  void keep_landmarks(const Expected_heights& heights, const double diagonal)
  {
    m_landmarks = std::make_unique<Landmark_guard<Mesh>>(m_mesh, heights, diagonal);
  }

  // what the guard knows of the mesh as it is, to return to this mesh
  struct State
  {
    double largest_distance;
    std::shared_ptr<const Landmark_guard<Mesh>> landmarks;
  };
  State state() const
  {
    return State{m_deviation.largest_distance(),
                 m_landmarks ? std::make_shared<const Landmark_guard<Mesh>>(*m_landmarks) : nullptr};
  }
  void return_to(const State& state)
  {
    m_deviation.set_largest_distance(state.largest_distance);
    m_landmarks = state.landmarks ? std::make_unique<Landmark_guard<Mesh>>(*state.landmarks) : nullptr;
  }

  // scales the heights
  void scale_landmarks(const double factor)
  {
    if (m_landmarks)
      m_landmarks->scale(factor);
  }

  // allows landmarks to be as far as contractions in a regular mesh leave them
  void expect_regular_mesh(const bool is_expected)
  {
    if (m_landmarks)
      m_landmarks->expect_regular_mesh(is_expected);
  }

  bool accepts(const Change& change) const
  {
    return m_faces.accepts(change) && m_folds.accepts(change) && accepts_distance(change) &&
           (!m_landmarks || m_landmarks->accepts(change)) && m_intersections.accepts(change); // the last one takes longest
  }

  // The update functions are called after an operation: for the faces of a change, on both sides of an edge, or around a
  // vertex.
  void update(const Change& change) const { update_faces(change.old_faces()); }

  void update_at(const Halfedge_index h) const
  {
    if (!needs_changes())
      return;
    Faces faces;
    for (const Halfedge_index side : {h, m_mesh.opposite(h)})
      if (!m_mesh.is_border(side))
        faces.push_back(m_mesh.face(side));
    update_faces(faces);
  }

  void update_around(const Vertex_index v) const
  {
    if (!needs_changes())
      return;
    Faces faces;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(h))
        faces.push_back(m_mesh.face(h));
    update_faces(faces);
  }

  // is called after faces have got other numbers
  template <typename ConcurrencyTag>
  void update_all() const
  {
    m_intersections.template update_all<ConcurrencyTag>();
  }

  // is called before it; `new_faces` has the new numbers by the old ones
  void renumber_landmarks(const std::vector<Face_index>& new_faces) const
  {
    if (m_landmarks)
      m_landmarks->renumber(new_faces);
  }

  // is called after all vertices may have moved
  template <typename ConcurrencyTag>
  void update_landmarks() const
  {
    if (m_landmarks)
      m_landmarks->template walk<ConcurrencyTag>();
  }

  // takes back moves that leave landmarks behind; to be called before `revert()`, and for moves that may as well not be done
  template <typename ConcurrencyTag>
  void revert_losses(Simultaneous_moves<Mesh>& moves, Interruption& interruption) const
  {
    if (m_landmarks)
      m_landmarks->template revert<ConcurrencyTag>(moves, interruption);
  }

  // takes back the moves that the guard does not accept; the others are to be done
  template <typename ConcurrencyTag>
  void revert(Simultaneous_moves<Mesh>& moves, Interruption& interruption) const
  {
    moves.template revert_folds<ConcurrencyTag>(interruption);
    m_intersections.template revert<ConcurrencyTag>(moves, interruption, Fold_test::NORMALS_AND_EDGES);
  }

  // the same while the vertices have no normals yet
  template <typename ConcurrencyTag>
  void revert_first(Simultaneous_moves<Mesh>& moves, Interruption& interruption) const
  {
    moves.template revert_folds<ConcurrencyTag>(interruption, Fold_test::EDGES);
    m_intersections.template revert<ConcurrencyTag>(moves, interruption, Fold_test::EDGES);
  }

private:
  typedef boost::container::small_vector<Face_index, 16> Faces;

  void update_faces(const Faces& faces) const
  {
    for (const Face_index f : faces)
      m_intersections.update(f);
    if (m_landmarks)
      m_landmarks->update(faces);
  }

  // a subdivision cuts nothing off
  bool accepts_distance(const Change& change) const
  {
    if (!m_deviation.is_active() || change.kind() == Change_kind::SUBDIVISION)
      return true;
    // all faces are in one region, or the new ones touch its curve and are accepted
    const Region region = m_mesh.region(m_mesh.halfedge(change.old_faces().front()));
    for (const auto& face : change.new_faces())
      if (!m_deviation.accepts(*face.corners[0].state, *face.corners[1].state, *face.corners[2].state, region))
        return false;
    return true;
  }

  const Mesh& m_mesh;
  Face_guard<Mesh> m_faces;
  const Fold_guard<Mesh> m_folds;
  Deviation_guard<Function> m_deviation;
  std::unique_ptr<Landmark_guard<Mesh>> m_landmarks; // none if nobody keeps them
  Mesh_intersections<Mesh>& m_intersections;         // kept up to date by the operations
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_OPERATION_GUARD_H
