// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_INPUT_SURFACE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_INPUT_SURFACE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The facets of the input with their vertex normals. A projection ends on them if the function leads nowhere. Shares of the
// diagonal refer to the box about the whole input, of which these may be a part.
class Input_surface
{
public:
  Input_surface(std::vector<Vector> points, std::vector<Facet> facets, const double diagonal)
    : m_points(std::move(points)), m_facets(std::move(facets)), m_normals(m_points.size(), Vector::Zero()), m_diagonal(diagonal)
  {
    for (const Facet& facet : m_facets)
    {
      // the length of a cross product weights the normal by the area
      const Vector area = (m_points[facet[1]] - m_points[facet[0]]).cross(m_points[facet[2]] - m_points[facet[0]]);
      for (const std::size_t v : facet)
        m_normals[v] += area;
    }
    for (Vector& normal : m_normals)
      normal.stableNormalize();
  }
  Input_surface(const Input_surface&) = delete;
  Input_surface& operator=(const Input_surface&) = delete;

  // whether all facets are degenerate, so that there is no closest one
  bool empty() const { return m_closest_facet.empty(); }

  double diagonal() const { return m_diagonal; }
  const std::vector<Vector>& points() const { return m_points; }
  const std::vector<Facet>& facets() const { return m_facets; }

  const Closest_facet& closest_facet() const { return m_closest_facet; }

  // requires that it is not empty
  Closest_facet::Answer closest(const Vector& p) const { return m_closest_facet(p); }

  // the longest side of the closest facet; 0 if there is none
  double size_of_closest_facet(const Vector& p) const
  {
    if (m_closest_facet.empty())
      return 0;
    const Facet& facet = m_facets[m_closest_facet(p).facet];
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = (std::max)(longest, (m_points[facet[std::size_t(k)]] - m_points[facet[std::size_t((k + 1) % 3)]]).norm());
    return longest;
  }

  // moves `state` to the closest point of the facets and gives it the normal interpolated there
  void project(Vertex_state& state) const
  {
    if (m_closest_facet.empty())
      return;
    const Closest_facet::Answer closest = m_closest_facet(state.point);
    state.point = closest.point;
    const Facet& facet = m_facets[closest.facet];
    Vector normal = Vector::Zero();
    for (int k = 0; k < 3; ++k)
      normal += closest.barycentric[k] * m_normals[facet[k]];
    if (normal.norm() > 0)
      state.normal = normal.normalized();
  }

private:
  std::vector<Vector> m_points;
  std::vector<Facet> m_facets;
  std::vector<Vector> m_normals;
  double m_diagonal;
  Closest_facet m_closest_facet{m_points, m_facets};
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_INPUT_SURFACE_H
