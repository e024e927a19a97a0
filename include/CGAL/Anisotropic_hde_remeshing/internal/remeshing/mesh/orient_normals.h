// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_ORIENT_NORMALS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_ORIENT_NORMALS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// By region: -1 if most of the area of its faces looks against the gradients at their vertices, 1 otherwise. A normal of the
// input looks the way of the faces: it tells nothing and does not count.
template <typename Mesh>
std::vector<double> orientations(const Mesh& mesh, const std::size_t number_of_regions)
{
  std::vector<double> result(number_of_regions, 0.);
  for (const Face_index f : mesh.faces())
  {
    const Corners<Mesh> t(mesh.halfedge(f), mesh);
    const Vector area = (t.b.point - t.a.point).cross(t.c.point - t.a.point);
    for (const auto* vertex : {&t.a, &t.b, &t.c})
      if (!vertex->is_on_input)
        result[mesh.region(mesh.halfedge(f))] += area.dot(vertex->normal);
  }
  for (double& sum : result)
    sum = sum < 0 ? -1 : 1;
  return result;
}

// turns the normals over in the regions with orientation -1
template <typename Mesh>
void orient_normals(Mesh& mesh, const std::vector<double>& orientations)
{
  for (const Vertex_index v : mesh.vertices())
  {
    if (!mesh.point(v).is_on_input)
      mesh.point(v).normal *= orientations[mesh.region(mesh.halfedge(v))];
    if (!mesh.point(v).is_on_crease)
      continue;
    for (auto& side : mesh.sides(v))
      side.vertex.normal *= orientations[side.region];
    mesh.point(v) = mesh.sides(v).front().vertex;
  }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_ORIENT_NORMALS_H
