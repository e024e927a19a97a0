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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What is asked of every operation. The guard judges by the change alone. No face may be folded or flattened, and none may fold
// over an edge. If it is asked for, no face may be too far from the surface, or intersect another one.
template <typename Mesh, typename Function, typename Intersections>
class Operation_guard
{
  typedef Local_change<Mesh> Change;

public:
  Operation_guard(const Mesh& mesh, const Function& function, Intersections& intersections)
    : m_mesh(mesh), m_faces(mesh), m_folds(mesh), m_deviation(function), m_intersections(intersections)
  {
  }

  void set_largest_distance(const double distance) { m_deviation.set_largest_distance(distance); }

  // whether `accepts()` depends only on what is next to the change
  bool is_local() const { return !m_intersections.is_active(); }

  bool accepts(const Change& change) const
  {
    return m_faces.accepts(change) && m_folds.accepts(change) && m_intersections.accepts(change) && accepts_distance(change);
  }

  // The update functions are called after an operation: for the faces of a change, on both sides of an edge, or around a
  // vertex.
  void update(const Change& change) const
  {
    for (const Face_index f : change.old_faces())
      m_intersections.update(f);
  }

  void update_at(const Halfedge_index h) const
  {
    for (const Halfedge_index side : {h, m_mesh.opposite(h)})
      if (!m_mesh.is_border(side))
        m_intersections.update(m_mesh.face(side));
  }

  void update_around(const Vertex_index v) const
  {
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(h))
        m_intersections.update(m_mesh.face(h));
  }

  // is called after faces have got other numbers
  template <typename ConcurrencyTag>
  void update_all(Interruption& interruption) const
  {
    m_intersections.template assign<ConcurrencyTag>(
        [&](const Vertex_index v) -> const typename Mesh::Vertex& { return m_mesh.point(v); }, interruption);
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
  const Face_guard<Mesh> m_faces;
  const Fold_guard<Mesh> m_folds;
  Deviation_guard<Function> m_deviation;
  Intersections& m_intersections; // kept up to date by the operations
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_OPERATION_GUARD_H
