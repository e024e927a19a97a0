// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_LOCAL_CHANGE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_LOCAL_CHANGE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

enum class Change_kind
{
  REPLACEMENT, // other faces take the place of the old ones
  SUBDIVISION  // the new faces cover the old ones
};

// What an operation would do: the faces that it removes, and the faces that it puts in their place. The guard judges the
// operation by this alone, before it is done.
template <typename Mesh>
class Local_change
{
public:
  typedef typename Mesh::Vertex Vertex;

  struct Corner
  {
    Vertex_index vertex; // none if it does not exist yet
    const Vertex* state; // as the face sees it; must outlive this object
  };
  struct New_face
  {
    std::array<Corner, 3> corners;
    Face_index old_face; // the face that it replaces alone; none if the new faces replace all old ones together
  };
  typedef boost::container::small_vector<Face_index, 16> Old_faces;
  typedef boost::container::small_vector<New_face, 16> New_faces;

  explicit Local_change(const Mesh& mesh, const Change_kind kind = Change_kind::REPLACEMENT) : m_mesh(mesh), m_kind(kind) {}

  void remove(const Face_index f) { m_old_faces.push_back(f); }
  void add(const Corner& a, const Corner& b, const Corner& c, const Face_index old_face = Mesh::null_face())
  {
    m_new_faces.push_back(New_face{{a, b, c}, old_face});
  }

  // a vertex as it is, as the face of h sees it
  Corner corner(const Vertex_index v, const Halfedge_index h) const { return Corner{v, &m_mesh.state(v, h)}; }

  Change_kind kind() const { return m_kind; }
  const Old_faces& old_faces() const { return m_old_faces; }
  const New_faces& new_faces() const { return m_new_faces; }

  bool removes(const Face_index f) const { return std::find(m_old_faces.begin(), m_old_faces.end(), f) != m_old_faces.end(); }

private:
  const Mesh& m_mesh;
  const Change_kind m_kind;
  Old_faces m_old_faces;
  New_faces m_new_faces;
};

// what the move of a vertex to a new state changes; the state must outlive it
template <typename Mesh>
Local_change<Mesh> change_of_move(const Mesh& mesh, const Vertex_index v, const typename Mesh::Vertex& moved)
{
  Local_change<Mesh> change(mesh);
  for (const Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    if (mesh.is_border(h))
      continue;
    const Triangle t(h, mesh);
    change.remove(mesh.face(h));
    change.add(change.corner(t.a, h), typename Local_change<Mesh>::Corner{v, &moved}, change.corner(t.c, h), mesh.face(h));
  }
  return change;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_LOCAL_CHANGE_H
