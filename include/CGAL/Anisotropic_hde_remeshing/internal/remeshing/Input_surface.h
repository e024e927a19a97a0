// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_SURFACE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_SURFACE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The facets of the input with their vertex normals: where a projection ends if the function leads nowhere.
class Input_surface
{
public:
  explicit Input_surface(const Working_mesh& mesh)
  {
    for (const Vertex_index v : mesh.vertices())
      m_points.push_back(mesh.point(v).point);
    m_normals.assign(m_points.size(), Vector::Zero());
    for (const Face_index f : mesh.faces())
    {
      const Triangle t(mesh.halfedge(f), mesh);
      m_faces.push_back({t.a, t.b, t.c});
      // weighted by area, as the sum of the cross products is
      const Vector area = (m_points[t.b] - m_points[t.a]).cross(m_points[t.c] - m_points[t.a]);
      for (const std::size_t v : m_faces.back())
        m_normals[v] += area;
    }
    for (Vector& normal : m_normals)
      if (normal.norm() > 0)
        normal.normalize();
  }

  // moves `state` to the closest point of the facets and gives it the normal interpolated there
  void project(Vertex_state& state) const
  {
    if (m_closest_facet.empty())
      return;
    const Closest_facet::Answer closest = m_closest_facet(state.point);
    state.point = closest.point;
    const Facet& facet = m_faces[closest.facet];
    Vector normal = Vector::Zero();
    for (int k = 0; k < 3; ++k)
      normal += closest.barycentric[k] * m_normals[facet[k]];
    if (normal.norm() > 0)
      state.normal = normal.normalized();
  }

private:
  std::vector<Vector> m_points;
  std::vector<Vector> m_normals;
  std::vector<Facet> m_faces;
  Closest_facet m_closest_facet{m_points, m_faces};
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_SURFACE_H
