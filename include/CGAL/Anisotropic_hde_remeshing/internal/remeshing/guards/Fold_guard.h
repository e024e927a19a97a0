// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_FOLD_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_FOLD_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/folded_edge.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Counts the edges over which two faces lie on each other. The normals of the vertices tell how faces should lie. They do not
// tell it at sharp edges, nor where two sheets of the surface are closer to each other than the vertices are. There two faces
// may lie on each other although both look the way of their vertices.
template <typename Mesh>
class Fold_guard
{
  typedef Local_change<Mesh> Change;
  typedef typename Change::New_face New_face;

public:
  explicit Fold_guard(const Mesh& mesh) : m_mesh(mesh) {}

  // whether there would be no more folded edges than before
  bool accepts(const Change& change) const
  {
    const std::size_t after = folds_after(change);
    return after == 0 || after <= folds_before(change);
  }

private:
  // the folds over the sides of the faces that the change removes
  std::size_t folds_before(const Change& change) const
  {
    std::size_t number_of_folds = 0;
    for_each_side(change,
                  [&](const Halfedge_index h, const bool is_inner)
                  {
                    const Halfedge_index g = m_mesh.opposite(h);
                    if (!is_inner || h < g) // an inner side belongs to two faces
                      number_of_folds += is_folded_edge(face_normal(h, m_mesh), face_normal(g, m_mesh));
                  });
    return number_of_folds;
  }

  // the folds over the sides of the faces that the change adds, towards each other and towards the faces beyond
  std::size_t folds_after(const Change& change) const
  {
    boost::container::small_vector<Vector, 16> normals;
    for (const New_face& face : change.new_faces())
      normals.push_back(face_normal(*face.corners[0].state, *face.corners[1].state, *face.corners[2].state));
    std::size_t number_of_folds = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        number_of_folds += is_folded_edge(normals[i], normals[k]) && share_edge(change.new_faces()[i], change.new_faces()[k]);
    for_each_side(change,
                  [&](const Halfedge_index h, const bool is_inner)
                  {
                    if (is_inner)
                      return;
                    const Vector beyond = face_normal(m_mesh.opposite(h), m_mesh);
                    for (std::size_t i = 0; i < normals.size(); ++i)
                      number_of_folds += is_folded_edge(normals[i], beyond) && has_side(change.new_faces()[i], h);
                  });
    return number_of_folds;
  }

  // Calls `visit(h, is_inner)` for the sides of the old faces that are not on the border. An inner side has old faces on both
  // sides.
  template <typename Visit>
  void for_each_side(const Change& change, const Visit& visit) const
  {
    for (const Face_index f : change.old_faces())
      for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
      {
        const Halfedge_index g = m_mesh.opposite(h);
        if (!m_mesh.is_border(g))
          visit(h, change.removes(m_mesh.face(g)));
      }
  }

  bool has_side(const New_face& face, const Halfedge_index h) const
  {
    return has_side(face, m_mesh.source(h), m_mesh.target(h));
  }

  static bool has_side(const New_face& face, const Vertex_index source, const Vertex_index target)
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (face.corners[k].vertex == source && face.corners[(k + 1) % 3].vertex == target)
        return true;
    return false;
  }

  static bool share_edge(const New_face& face, const New_face& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (has_side(other, face.corners[(k + 1) % 3].vertex, face.corners[k].vertex))
        return true;
    return false;
  }

  const Mesh& m_mesh;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_FOLD_GUARD_H
