// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_SUBDIVISION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_SUBDIVISION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Splits an edge and the faces at it: what that changes, and how it is done. The new vertex has a state, and on a crease one for
// each region.
template <typename Mesh, typename Guard>
class Edge_subdivision
{
  typedef typename Mesh::Vertex Vertex;
  typedef typename Mesh::Sides Sides;
  typedef Local_change<Mesh> Change;

public:
  Edge_subdivision(Mesh& mesh, const Guard& guard) : m_mesh(mesh), m_guard(guard) {}

  // the new vertex as the face of h sees it
  const Vertex& state(const Halfedge_index h, const Vertex& middle, const Sides& sides) const
  {
    return middle.is_on_crease ? Mesh::side(sides, m_mesh.region(h)) : middle;
  }

  // what the split changes
  Change change(const Halfedge_index h, const Vertex& middle_state, const Sides& sides) const
  {
    Change change(m_mesh, Change_kind::SUBDIVISION);
    for (const Halfedge_index side : {h, m_mesh.opposite(h)})
    {
      if (m_mesh.is_border(side))
        continue;
      const Face_index f = m_mesh.face(side);
      const Triangle t(side, m_mesh);
      const typename Change::Corner a = change.corner(t.a, side), b = change.corner(t.b, side), c = change.corner(t.c, side),
                                    middle{Mesh::null_vertex(), &state(side, middle_state, sides)};
      change.remove(f);
      change.add(a, middle, c, f);
      change.add(middle, b, c, f);
    }
    return change;
  }

  // returns the new vertex
  Vertex_index split(const Halfedge_index to, const Vertex& middle_state, const Sides& sides) const
  {
    const Curve_arc arc = m_mesh.arc(to);
    const double middle = 0.5 * (arc.source + arc.target);
    const Halfedge_index from = CGAL::Euler::split_edge(to, m_mesh.graph());
    m_mesh.point(m_mesh.target(from)) = middle_state;
    m_mesh.sides(m_mesh.target(from)) = sides;
    m_mesh.set_arc(from, Curve_arc{arc.curve, arc.source, middle});
    m_mesh.set_arc(to, Curve_arc{arc.curve, middle, arc.target});
    if (!m_mesh.is_border(from))
      split_face(from, m_mesh.next(m_mesh.next(from)));
    const Halfedge_index back = m_mesh.opposite(from);
    if (!m_mesh.is_border(back))
      split_face(m_mesh.prev(back), m_mesh.next(back));
    m_guard.update_around(m_mesh.target(from));
    return m_mesh.target(from);
  }

private:
  void split_face(const Halfedge_index g, const Halfedge_index h) const
  {
    const std::size_t input_face = m_mesh.input_face(m_mesh.face(g));
    const Halfedge_index between = CGAL::Euler::split_face(g, h, m_mesh.graph());
    m_mesh.set_input_face(m_mesh.face(between), input_face);
    m_mesh.set_input_face(m_mesh.face(m_mesh.opposite(between)), input_face);
  }

  Mesh& m_mesh;
  const Guard& m_guard;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_SUBDIVISION_H
