// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Signed_distance.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hde_remesh {

Signed_distance::Signed_distance(const Mesh& mesh)
  : m_mesh(mesh), m_normals(mesh.num_faces(), Vector_3(0, 0, 0)), m_tree(mesh.faces().begin(), mesh.faces().end(), mesh)
{
  for (const Mesh::Face_index f : mesh.faces())
    m_normals[f] = CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh);
  m_tree.accelerate_distance_queries(); // now, not when a thread asks first
}

// At an edge or a vertex, the face that is found is one of several that are as near. Then the sum of their normals tells the side,
// at a vertex weighted by the angles of the faces there (Baerentzen and Aanaes, 2005).
Vector_3 Signed_distance::normal_at(const Point_3& q, const Mesh::Face_index face) const
{
  static constexpr double negligible = 1e-9; // of the longest side: rounding of the nearest point
  const Mesh::Halfedge_index h = m_mesh.halfedge(face);
  const std::array<Mesh::Halfedge_index, 3> sides = {h, m_mesh.next(h), m_mesh.prev(h)};
  double longest = 0;
  for (const Mesh::Halfedge_index side : sides)
    longest = (std::max)(longest, CGAL::squared_distance(m_mesh.point(m_mesh.source(side)), m_mesh.point(m_mesh.target(side))));
  const double near = negligible * negligible * longest;
  for (const Mesh::Halfedge_index side : sides)
    if (CGAL::squared_distance(q, m_mesh.point(m_mesh.target(side))) <= near)
    {
      Vector_3 sum(0, 0, 0);
      for (const Mesh::Halfedge_index g : m_mesh.halfedges_around_target(side))
        if (!m_mesh.is_border(g))
        {
          const Point_3 &v = m_mesh.point(m_mesh.target(g)), &a = m_mesh.point(m_mesh.source(g)),
                        &b = m_mesh.point(m_mesh.target(m_mesh.next(g)));
          sum += CGAL::approximate_angle(a, v, b) * m_normals[m_mesh.face(g)];
        }
      return sum;
    }
  for (const Mesh::Halfedge_index side : sides)
    if (!m_mesh.is_border(m_mesh.opposite(side)) &&
        CGAL::squared_distance(q, Kernel::Segment_3(m_mesh.point(m_mesh.source(side)), m_mesh.point(m_mesh.target(side)))) <=
            near)
      return m_normals[face] + m_normals[m_mesh.face(m_mesh.opposite(side))];
  return m_normals[face];
}

double Signed_distance::operator()(const Point_3& p) const
{
  const auto [q, face] = m_tree.closest_point_and_primitive(p);
  const double distance = std::sqrt(CGAL::squared_distance(p, q));
  return (p - q) * normal_at(q, face) < 0 ? -distance : distance;
}

std::vector<double> signed_distances(const Mesh& mesh, const Mesh& other)
{
  const Signed_distance distance(other);
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  std::vector<double> result(faces.size());
  CGAL::Anisotropic_hde_remeshing::internal::parallel_for<CGAL::Parallel_if_available_tag>(
      faces.size(),
      [&](const std::size_t i)
      {
        const Mesh::Halfedge_index h = mesh.halfedge(faces[i]);
        result[i] = distance(
            CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))));
      });
  return result;
}

} // namespace hde_remesh
