// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_SAMPLED_OPERATIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_SAMPLED_OPERATIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_contraction.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_subdivision.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Measured_contractions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Contracts and splits edges of a mesh with samples: the samples go over to the faces that follow. Also which vertices that
// concerns, so that several operations can be chosen before the first one is done.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Sampled_operations
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;
  typedef typename Mesh::Vertex Vertex;

public:
  Sampled_operations(Mesh& mesh, const Curve_network& curves, const Guard& guard, Owners& owners)
    : m_mesh(mesh), m_contraction(mesh, curves, guard), m_subdivision(mesh, guard), m_guard(guard), m_owners(owners)
  {
  }

  // begins a new set of operations that are independent of each other
  void begin() { m_is_touched.assign(vertex_capacity(m_mesh), 0); }

  // whether an operation has any vertex of a face
  bool has_taken(const Face_index f) const
  {
    const Triangle t(m_mesh.halfedge(f), m_mesh);
    return m_is_touched[t.a] || m_is_touched[t.b] || m_is_touched[t.c];
  }

  // takes the vertices around an edge, if no operation has any of them
  bool take_ring(const Halfedge_index h)
  {
    std::vector<Vertex_index> ring{m_mesh.source(h), m_mesh.target(h)};
    for (const Halfedge_index end : {h, m_mesh.opposite(h)})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
        ring.push_back(m_mesh.source(in));
    return take(ring);
  }

  // takes a vertex and those around it, if no operation has any of them
  bool take_ring(const Vertex_index v)
  {
    std::vector<Vertex_index> ring{v};
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      ring.push_back(m_mesh.source(in));
    return take(ring);
  }

  // takes the vertices of both faces at an edge inside the mesh, if no operation has any of them
  bool take_quad(const Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    return take(std::array<Vertex_index, 4>{m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h)),
                                            m_mesh.target(m_mesh.next(g))});
  }

  // whether the guard and the curves allow it
  bool accepts(const Measured_contraction& c) const
  {
    return m_contraction.is_removable(c.halfedge) && CGAL::Euler::does_satisfy_link_condition(c.edge, m_mesh.graph()) &&
           m_guard.accepts(m_contraction.change(c.halfedge, kept_state(c)));
  }
  bool accepts_split(const Halfedge_index h, const Vector& point) const
  {
    return m_guard.accepts(m_subdivision.change(h, new_state(h, point), {}));
  }

  bool accepts_move(const Vertex_index v, const Vector& point) const
  {
    Vertex state = m_mesh.point(v);
    state.point = point;
    return m_guard.accepts(change_of_move(m_mesh, v, state));
  }

  void contract(const Measured_contraction& c)
  {
    std::vector<std::uint32_t> samples;
    for (const Halfedge_index end : {c.halfedge, m_mesh.opposite(c.halfedge)})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
        if (!m_mesh.is_border(in))
          m_owners.take(m_mesh.face(in), samples);
    const Vertex_index v = m_contraction.contract(c.halfedge, kept_state(c));
    give_around(v, samples);
  }

  void move(const Vertex_index v, const Vector& point)
  {
    std::vector<std::uint32_t> samples;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(in))
        m_owners.take(m_mesh.face(in), samples);
    m_mesh.point(v).point = point;
    m_guard.update_around(v);
    give_around(v, samples);
  }

  // the edge must have two faces
  void split(const Halfedge_index h, const Vector& point)
  {
    std::vector<std::uint32_t> samples;
    m_owners.take(m_mesh.face(h), samples);
    m_owners.take(m_mesh.face(m_mesh.opposite(h)), samples);
    const Vertex_index v = m_subdivision.split(h, new_state(h, point), {});
    m_is_touched.resize(vertex_capacity(m_mesh), 1);
    m_owners.resize();
    give_around(v, samples);
  }

private:
  template <typename Vertices>
  bool take(const Vertices& vertices)
  {
    for (const Vertex_index v : vertices)
      if (m_is_touched[v])
        return false;
    for (const Vertex_index v : vertices)
      m_is_touched[v] = 1;
    return true;
  }

  void give_around(const Vertex_index v, const std::vector<std::uint32_t>& samples)
  {
    std::vector<Face_index> faces;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(in))
        faces.push_back(m_mesh.face(in));
    m_owners.give(samples, faces);
  }

  // of the target of a contraction
  Vertex kept_state(const Measured_contraction& c) const
  {
    const Vertex_index a = m_mesh.source(c.halfedge), b = m_mesh.target(c.halfedge);
    Vertex state = m_mesh.point(b);
    if (state.is_on_curve || state.is_fixed)
      return state;
    state.point = c.point;
    const Vector normal = m_mesh.state(a, c.halfedge).normal + state.normal;
    if (normal.norm() > 0)
      state.normal = normal.normalized();
    return state;
  }

  Vertex new_state(const Halfedge_index h, const Vector& point) const
  {
    Vertex state;
    state.point = point;
    const Vector normal = m_mesh.state(m_mesh.source(h), h).normal + m_mesh.state(m_mesh.target(h), h).normal;
    if (normal.norm() > 0)
      state.normal = normal.normalized();
    return state;
  }

  Mesh& m_mesh;
  const Edge_contraction<Mesh, Guard> m_contraction;
  const Edge_subdivision<Mesh, Guard> m_subdivision;
  const Guard& m_guard;
  Owners& m_owners;
  std::vector<char> m_is_touched; // by vertex
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_SAMPLED_OPERATIONS_H
