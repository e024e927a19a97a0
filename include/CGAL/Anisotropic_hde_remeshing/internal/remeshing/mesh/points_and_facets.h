// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_POINTS_AND_FACETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_POINTS_AND_FACETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the points of a mesh without removed elements
template <typename Mesh>
std::vector<Vector> points_of(const Mesh& mesh)
{
  std::vector<Vector> result;
  result.reserve(mesh.number_of_vertices());
  for (const Vertex_index v : mesh.vertices())
    result.push_back(mesh.point(v).point);
  return result;
}

// the faces of the mesh by their vertices, rotated so that the smallest comes first
template <typename Mesh>
std::vector<Facet> facets_of(const Mesh& mesh)
{
  std::vector<Facet> result;
  result.reserve(mesh.number_of_faces());
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    Facet facet{std::size_t(t.a), std::size_t(t.b), std::size_t(t.c)};
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    result.push_back(facet);
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_POINTS_AND_FACETS_H
