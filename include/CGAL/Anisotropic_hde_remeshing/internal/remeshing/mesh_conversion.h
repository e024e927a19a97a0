// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_CONVERSION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_CONVERSION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Copies the mesh of the caller, without its isolated vertices, whose number it returns. Throws if it is not a triangle
// mesh with finite coordinates and at least one face.
template <typename TriangleMesh, typename VertexPointMap>
std::size_t load_mesh(const TriangleMesh& tmesh, const VertexPointMap vpm, Working_mesh& mesh)
{
  typedef dynamic_vertex_property_t<Vertex_index> Index_property;
  typename boost::property_map<TriangleMesh, Index_property>::const_type index = get(Index_property(), tmesh);
  std::size_t number_of_isolated_vertices = 0, position = 0;
  for (const auto v : vertices(tmesh))
  {
    const std::size_t this_position = position++;
    if (halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      ++number_of_isolated_vertices;
      continue;
    }
    Vertex_state state;
    state.point = finite_vector(get(vpm, v), "point", this_position);
    put(index, v, mesh.add_vertex(state));
  }
  position = 0;
  for (const auto f : faces(tmesh))
  {
    const auto h = halfedge(f, tmesh);
    if (next(next(next(h, tmesh), tmesh), tmesh) != h)
      throw std::invalid_argument("face " + std::to_string(position) + " is not a triangle");
    const Face_index added = mesh.add_face(get(index, source(h, tmesh)), get(index, target(h, tmesh)),
                                           get(index, target(next(h, tmesh), tmesh)));
    if (added == Working_mesh::null_face())
      throw std::invalid_argument("face " + std::to_string(position) + " is on a non-manifold edge or vertex");
    ++position;
  }
  if (mesh.number_of_faces() == 0)
    throw std::invalid_argument("the mesh has no faces");
  return number_of_isolated_vertices;
}

template <typename TriangleMesh>
void remove_all_elements_of(TriangleMesh& tmesh)
{
  CGAL::clear(tmesh);
}

// keeps the property maps of the caller, among them perhaps the one of the points
template <typename Point>
void remove_all_elements_of(Surface_mesh<Point>& tmesh)
{
  tmesh.clear_without_removing_property_maps();
}

// replaces the elements of the caller's mesh
template <typename TriangleMesh, typename VertexPointMap>
void store_mesh(const Working_mesh& mesh, TriangleMesh& tmesh, const VertexPointMap vpm)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  remove_all_elements_of(tmesh);
  std::vector<typename Graph_traits::vertex_descriptor> descriptors(vertex_capacity(mesh));
  for (const Vertex_index v : mesh.vertices())
  {
    const Vector& p = mesh.point(v).point;
    descriptors[v] = add_vertex(tmesh);
    put(vpm, descriptors[v], Point(p[0], p[1], p[2]));
  }
  std::vector<typename Graph_traits::vertex_descriptor> corners(3);
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    corners[0] = descriptors[t.a];
    corners[1] = descriptors[t.b];
    corners[2] = descriptors[t.c];
    CGAL::Euler::add_face(corners, tmesh);
  }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_CONVERSION_H
