// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_FIRST_HALFEDGES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_FIRST_HALFEDGES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// for each face the halfedge whose source comes first in the order of the vertices of the mesh
template <typename Mesh>
std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> first_halfedges(const Mesh& mesh)
{
  const auto position = get(dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t next_position = 0;
  for (const auto v : vertices(mesh))
    put(position, v, next_position++);
  std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> result;
  for (const auto f : faces(mesh))
  {
    auto first = halfedge(f, mesh);
    for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      if (get(position, source(h, mesh)) < get(position, source(first, mesh)))
        first = h;
    result.push_back(first);
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_FIRST_HALFEDGES_H
