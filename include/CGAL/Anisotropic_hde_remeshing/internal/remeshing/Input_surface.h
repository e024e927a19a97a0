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

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The facets of the input with their vertex normals: where a projection ends if the function leads nowhere. The search tree
// is built at the first query, which most runs never make.
class Input_surface
{
  typedef Simple_cartesian<double> Kernel;
  typedef std::vector<Kernel::Triangle_3> Triangles;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef AABB_triangle_primitive_3<Kernel, Triangles::const_iterator> Primitive;
  typedef AABB_tree<AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef AABB_triangle_primitive<Kernel, Triangles::const_iterator> Primitive;
  typedef AABB_tree<AABB_traits<Kernel, Primitive>> Tree;
#endif

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
    std::call_once(m_is_built, [this] { build(); });
    const Kernel::Point_3 query(state.point[0], state.point[1], state.point[2]);
    const auto found = m_tree->closest_point_and_primitive(query);
    const std::array<std::size_t, 3>& face = m_faces[std::size_t(found.second - m_triangles.cbegin())];
    state.point = Vector(found.first.x(), found.first.y(), found.first.z());
    const Vector &a = m_points[face[0]], &b = m_points[face[1]], &c = m_points[face[2]];
    const Vector weights((b - state.point).cross(c - state.point).norm(), (c - state.point).cross(a - state.point).norm(),
                         (a - state.point).cross(b - state.point).norm());
    const Vector normal = weights[0] * m_normals[face[0]] + weights[1] * m_normals[face[1]] + weights[2] * m_normals[face[2]];
    if (normal.norm() > 0)
      state.normal = normal.normalized();
  }

private:
  void build() const
  {
    for (const auto& face : m_faces)
      m_triangles.emplace_back(to_point(m_points[face[0]]), to_point(m_points[face[1]]), to_point(m_points[face[2]]));
    m_tree = std::make_unique<Tree>(m_triangles.cbegin(), m_triangles.cend());
    m_tree->build();
    m_tree->accelerate_distance_queries();
  }

  static Kernel::Point_3 to_point(const Vector& p) { return Kernel::Point_3(p[0], p[1], p[2]); }

  std::vector<Vector> m_points;
  std::vector<Vector> m_normals;
  std::vector<std::array<std::size_t, 3>> m_faces;
  mutable std::once_flag m_is_built;
  mutable Triangles m_triangles;
  mutable std::unique_ptr<Tree> m_tree;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_SURFACE_H
