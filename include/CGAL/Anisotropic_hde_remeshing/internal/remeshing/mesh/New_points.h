// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_NEW_POINTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_NEW_POINTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Converts vertices of the working mesh to points of the caller's mesh. A point of an exact kernel asks for memory, so such
// points are made in advance.
template <typename Point, typename Mesh>
class New_points
{
  static constexpr bool are_made_in_advance = !std::is_trivially_copyable<Point>::value;

public:
  // `unit` of the working mesh
  New_points(const Mesh& mesh, const double unit, const std::vector<Vertex_index>& vertices)
    : m_mesh(mesh), m_unit(unit), m_vertices(vertices)
  {
    if constexpr (are_made_in_advance)
    {
      m_points.reserve(vertices.size());
      for (std::size_t i = 0; i < vertices.size(); ++i)
        m_points.push_back(point(i));
    }
  }

  Point operator[](const std::size_t i) const
  {
    if constexpr (are_made_in_advance)
      return m_points[i];
    else
      return point(i);
  }

private:
  Point point(const std::size_t i) const
  {
    const Vector p = m_unit * m_mesh.point(m_vertices[i]).point;
    return Point(p[0], p[1], p[2]);
  }

  const Mesh& m_mesh;
  const double m_unit;
  const std::vector<Vertex_index>& m_vertices;
  std::vector<Point> m_points;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_NEW_POINTS_H
