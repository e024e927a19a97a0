// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_PLACEMENT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_PLACEMENT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Puts vertices on curves. A vertex is put on the polyline. On a crease between two regions it is put where their surfaces
// meet, if they meet near the polyline. On a border that is to be projected it is put on the surface, if this is near the polyline.
template <typename Embedding, typename Projection>
class Curve_placement
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  typedef typename Mesh::Vertex Vertex;
  typedef typename Mesh::Sides Sides;

public:
  Curve_placement(const Embedding& embedding, const Projection& projection, const Curve_network& curves)
    : m_embedding(embedding), m_projection(projection), m_curves(curves)
  {
  }

  // `sides` are those of the regions on both sides of the curve; empty if there is only one region, `region`
  Vector point(const int curve, const double arc_length, const Region region, const Sides& sides) const
  {
    Vector result = m_curves.point(curve, arc_length);
    if (sides.size() == 2)
      m_projection.project_on_crease(result, sides[0].region, sides[1].region, m_curves.reach(curve, arc_length));
    else if (m_curves.is_projected(curve))
      for (const Border_way& way : m_curves.border_ways(curve, arc_length))
        if (m_projection.project_across(result, region, way.one, way.other, way.reach))
          break;
    return result;
  }

  // whether the vertex belongs on the surface, as one of a border
  bool is_on_projected_border(const Vertex_index v, const Mesh& mesh) const
  {
    if (!m_curves.projects_borders() || !mesh.point(v).is_on_curve)
      return false;
    return mesh.point(v).is_fixed ? m_curves.border_corner(mesh.point(v).input_vertex) != nullptr : mesh.is_border(v);
  }

  // where such a vertex belongs
  Vector point_on_border(const Vertex_index v, const Region region, const Mesh& mesh) const
  {
    if (mesh.point(v).is_fixed)
    {
      const Curve_network::Border_corner& corner = *m_curves.border_corner(mesh.point(v).input_vertex);
      Vector result = corner.point;
      const Vector none = Vector::Zero();
      if (!m_projection.project_across(result, region, corner.way.one, corner.way.other, corner.way.reach))
        m_projection.project_across(result, region, none, none, corner.way.reach);
      return result;
    }
    Halfedge_index in = mesh.halfedge(v);
    while (!mesh.is_border(in))
      in = mesh.prev(mesh.opposite(in));
    return point(mesh.arc(in).curve, mesh.arc(in).target, region, Sides());
  }

  // Updates the normals and what the embedding keeps at the point of `state`. Without sides the point is in `region`.
  void update(Vertex& state, const Region region, Sides& sides) const
  {
    update(state, region, sides, [&](Vertex& vertex, Region) { m_embedding.place(vertex); });
  }

  // the same, with `place(vertex, region)` to update what the embedding keeps
  template <typename Place>
  void update(Vertex& state, const Region region, Sides& sides, const Place& place) const
  {
    if (sides.empty())
    {
      m_projection.update_normal(state, region);
      place(state, region);
      return;
    }
    for (Crease_side<Vertex>& side : sides)
    {
      side.vertex.point = state.point;
      m_projection.update_normal(side.vertex, side.region);
      place(side.vertex, side.region);
    }
    state = sides.front().vertex;
  }

private:
  const Embedding& m_embedding;
  const Projection& m_projection;
  const Curve_network& m_curves;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_PLACEMENT_H
