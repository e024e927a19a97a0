// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LOAD_OBSTACLES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LOAD_OBSTACLES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/load_mesh.h>

#include <CGAL/boost/graph/properties.h>

#include <Eigen/Geometry>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The faces of the caller's mesh that are not remeshed, split into triangles, as far as remeshed ones may come to them.
template <typename TriangleMesh, typename VertexPointMap>
Obstacles load_obstacles(const TriangleMesh& tmesh, const VertexPointMap vpm, const Mesh_origin<TriangleMesh>& origin)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  static constexpr double reach = 0.25; // over the diagonal of what is remeshed
  static constexpr std::size_t no_number = std::size_t(-1);
  Obstacles result;
  const auto numbers = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  const auto number = [&](const Vertex v)
  {
    if (get(numbers, v) == no_number)
      put(numbers, v, result.first_free_number++);
    return get(numbers, v);
  };
  const auto point = [&](const Vertex v)
  { return Vector(finite_vector(value_of(vpm, v), "point", std::size_t(get(numbers, v))) / origin.unit); };
  for (const Vertex v : vertices(tmesh))
    put(numbers, v, no_number);
  Eigen::AlignedBox3d box;
  for (const Vertex v : origin.vertices)
  {
    result.vertex_numbers.push_back(number(v));
    box.extend(point(v));
  }
  const Vector margin = Vector::Constant(reach * box.diagonal().norm());
  const Eigen::AlignedBox3d within(box.min() - margin, box.max() + margin);
  std::vector<char> is_remeshed(num_faces(tmesh), 0); // num_faces() may count removed faces, too
  for (const std::size_t position : origin.face_positions)
    is_remeshed[position] = 1;
  std::size_t position = 0;
  for (const typename Graph_traits::face_descriptor f : faces(tmesh))
  {
    if (is_remeshed[position++])
      continue;
    const Halfedge first = halfedge(f, tmesh);
    for (Halfedge h = next(first, tmesh); next(h, tmesh) != first; h = next(h, tmesh))
    {
      const std::array<Vertex, 3> corners = {target(first, tmesh), target(h, tmesh), target(next(h, tmesh), tmesh)};
      Indexed_triangle triangle;
      Eigen::AlignedBox3d box_of_triangle;
      for (std::size_t k = 0; k < 3; ++k)
        box_of_triangle.extend(triangle.points[k] = point(corners[k]));
      if (!box_of_triangle.intersects(within))
        continue;
      for (std::size_t k = 0; k < 3; ++k)
        triangle.vertices[k] = number(corners[k]);
      result.triangles.push_back(triangle);
    }
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LOAD_OBSTACLES_H
