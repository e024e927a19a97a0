// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_NEW_ELEMENTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_NEW_ELEMENTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// elements without connectivity
template <typename TriangleMesh>
struct New_elements
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> edges;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> faces;
};

template <typename TriangleMesh>
void remove_elements(const New_elements<TriangleMesh>& elements, TriangleMesh& tmesh)
{
  for (const auto f : elements.faces)
    remove_face(f, tmesh);
  for (const auto e : elements.edges)
    remove_edge(e, tmesh);
  for (const auto v : elements.vertices)
    remove_vertex(v, tmesh);
}

template <typename TriangleMesh>
void reserve_elements(std::size_t, std::size_t, std::size_t, TriangleMesh&)
{
}

// A Surface_mesh that runs out of memory while it adds an element is left with property maps of different sizes. So all memory
// is reserved first.
template <typename Point>
void reserve_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                      const std::size_t number_of_faces, Surface_mesh<Point>& tmesh)
{
  typedef typename Surface_mesh<Point>::size_type size_type;
  check_number_of_halfedges(2 * (std::size_t(tmesh.num_edges()) + number_of_edges));
  tmesh.reserve(size_type(tmesh.num_vertices() + number_of_vertices), size_type(tmesh.num_edges() + number_of_edges),
                size_type(tmesh.num_faces() + number_of_faces));
}

// adds all of them, or none if adding one throws
template <typename TriangleMesh>
New_elements<TriangleMesh> add_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                                        const std::size_t number_of_faces, TriangleMesh& tmesh)
{
  New_elements<TriangleMesh> result;
  result.vertices.reserve(number_of_vertices);
  result.edges.reserve(number_of_edges);
  result.faces.reserve(number_of_faces);
  reserve_elements(number_of_vertices, number_of_edges, number_of_faces, tmesh);
  try
  {
    while (result.vertices.size() < number_of_vertices)
      result.vertices.push_back(add_vertex(tmesh));
    while (result.edges.size() < number_of_edges)
      result.edges.push_back(add_edge(tmesh));
    while (result.faces.size() < number_of_faces)
      result.faces.push_back(add_face(tmesh));
  }
  catch (...)
  {
    remove_elements(result, tmesh);
    throw;
  }
  return result;
}

// Replaces all elements of the mesh by new ones, numbered from 0 on. That is many times faster than to add the new ones and to
// remove the old ones. The property maps of the mesh stay. The map of the points may be one of them.
template <typename Point>
New_elements<Surface_mesh<Point>> replace_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                                                   const std::size_t number_of_faces, Surface_mesh<Point>& tmesh)
{
  typedef Surface_mesh<Point> Mesh;
  typedef typename Mesh::size_type size_type;
  check_number_of_halfedges(2 * number_of_edges);
  New_elements<Mesh> result;
  result.vertices.reserve(number_of_vertices);
  result.edges.reserve(number_of_edges);
  result.faces.reserve(number_of_faces);
  if (tmesh.has_garbage())
    tmesh.collect_garbage();
  // after the next line nothing asks for memory
  tmesh.reserve(size_type(number_of_vertices), size_type(number_of_edges), size_type(number_of_faces));
  tmesh.resize(0, 0, 0);
  tmesh.resize(size_type(number_of_vertices), size_type(number_of_edges), size_type(number_of_faces));
  result.vertices.assign(tmesh.vertices().begin(), tmesh.vertices().end());
  result.edges.assign(tmesh.edges().begin(), tmesh.edges().end());
  result.faces.assign(tmesh.faces().begin(), tmesh.faces().end());
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_NEW_ELEMENTS_H
