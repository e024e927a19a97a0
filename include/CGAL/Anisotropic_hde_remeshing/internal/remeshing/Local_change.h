// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_LOCAL_CHANGE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_LOCAL_CHANGE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What an operation would do: the faces that it removes, and those that it puts in their place. The guards look at it before
// it is done.
template <typename Mesh>
class Local_change
{
public:
  typedef typename Mesh::Vertex Vertex;

  struct Corner
  {
    Vertex_index vertex; // none if it does not exist yet
    const Vertex* state; // which must outlive this object
  };
  typedef std::array<Corner, 3> New_face;
  typedef boost::container::small_vector<Face_index, 16> Old_faces;
  typedef boost::container::small_vector<New_face, 16> New_faces;

  explicit Local_change(const Mesh& mesh) : m_mesh(mesh) {}

  void remove(const Face_index f) { m_old_faces.push_back(f); }
  void add(const Corner& a, const Corner& b, const Corner& c) { m_new_faces.push_back(New_face{a, b, c}); }

  // a vertex as it is
  Corner corner(const Vertex_index v) const { return Corner{v, &m_mesh.point(v)}; }

  const Old_faces& old_faces() const { return m_old_faces; }
  const New_faces& new_faces() const { return m_new_faces; }

  bool removes(const Face_index f) const { return std::find(m_old_faces.begin(), m_old_faces.end(), f) != m_old_faces.end(); }

private:
  const Mesh& m_mesh;
  Old_faces m_old_faces;
  New_faces m_new_faces;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_LOCAL_CHANGE_H
