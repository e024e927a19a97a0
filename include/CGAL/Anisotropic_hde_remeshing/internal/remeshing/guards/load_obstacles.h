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

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the faces of the caller's mesh that are not remeshed, split into triangles
template <typename TriangleMesh, typename VertexPointMap>
Obstacles load_obstacles(const TriangleMesh& tmesh, const VertexPointMap vpm, const Mesh_origin<TriangleMesh>& origin)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  Obstacles result;
  const auto numbers = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  for (const Vertex v : vertices(tmesh))
    put(numbers, v, result.first_free_number++);
  for (const Vertex v : origin.vertices)
    result.vertex_numbers.push_back(get(numbers, v));
  const auto set_corner = [&](Indexed_triangle& triangle, const std::size_t k, const Halfedge h)
  {
    triangle.vertices[k] = get(numbers, target(h, tmesh));
    triangle.points[k] = finite_vector(value_of(vpm, target(h, tmesh)), "point", triangle.vertices[k]) / origin.unit;
  };
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
      Indexed_triangle triangle;
      set_corner(triangle, 0, first);
      set_corner(triangle, 1, h);
      set_corner(triangle, 2, next(h, tmesh));
      result.triangles.push_back(triangle);
    }
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_LOAD_OBSTACLES_H
