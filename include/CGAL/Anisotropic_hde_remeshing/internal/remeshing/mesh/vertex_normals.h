// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_VERTEX_NORMALS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_VERTEX_NORMALS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Gives each vertex the normal of the faces around it, weighted by their areas. On a crease every side of a vertex gets the
// normal of the faces of its region.
template <typename ConcurrencyTag, typename Mesh>
void set_vertex_normals(Mesh& mesh)
{
  const auto set = [&](const Vertex_index v, const auto& counts, typename Mesh::Vertex& vertex)
  {
    Vector sum = Vector::Zero();
    for (const Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if (!mesh.is_border(h) && counts(h))
      {
        const Triangle t(h, mesh);
        sum += (mesh.point(t.c).point - mesh.point(v).point).cross(mesh.point(t.a).point - mesh.point(v).point);
      }
    const double length = sum.norm();
    if (length > 0)
      vertex.normal = sum / length;
  };
  parallel_for<ConcurrencyTag>(vertex_capacity(mesh),
                               [&](const std::size_t i)
                               {
                                 const Vertex_index v(static_cast<Vertex_index::size_type>(i));
                                 if (mesh.is_removed(v))
                                   return;
                                 for (auto& side : mesh.sides(v))
                                   set(
                                       v, [&](const Halfedge_index h) { return mesh.region(h) == side.region; }, side.vertex);
                                 if (mesh.point(v).is_on_crease)
                                   mesh.point(v) = mesh.sides(v).front().vertex;
                                 else
                                   set(
                                       v, [](Halfedge_index) { return true; }, mesh.point(v));
                               });
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_VERTEX_NORMALS_H
