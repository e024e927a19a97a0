// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_FIX_APEXES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_FIX_APEXES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/is_apex.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <boost/math/constants/constants.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What the angles of the faces around a vertex leave out of a full turn. It is 0 where it says nothing: on curves and at the
// boundary.
template <typename Mesh>
double angle_defect(const Vertex_index v, const Mesh& mesh)
{
  double defect = 2 * boost::math::constants::pi<double>();
  if (mesh.point(v).is_on_curve || mesh.point(v).is_on_crease)
    return 0;
  for (const Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    if (mesh.is_border(h))
      return 0;
    const Triangle t(h, mesh);
    defect -= angle_between(mesh.point(t.a).point - mesh.point(t.b).point, mesh.point(t.c).point - mesh.point(t.b).point);
  }
  return defect;
}

// the tips of cones and spikes, which operations by lengths would take off, and where they are
template <typename Mesh>
std::vector<std::pair<Vertex_index, Vector>> apexes(const Mesh& mesh)
{
  std::vector<std::pair<Vertex_index, Vector>> result;
  for (const Vertex_index v : mesh.vertices())
  {
    const double defect = angle_defect(v, mesh);
    bool is_tip = is_apex(defect, 0);
    if (is_tip)
      for (const Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
        is_tip = is_tip && is_apex(defect, angle_defect(mesh.source(h), mesh));
    if (is_tip)
      result.emplace_back(v, mesh.point(v).point);
  }
  return result;
}

// Fixes those that the projection to the surface has left where they were, to a distance.
template <typename Mesh>
void fix_apexes(const std::vector<std::pair<Vertex_index, Vector>>& apexes, const double distance, Mesh& mesh)
{
  for (const auto& [v, point] : apexes)
    if ((mesh.point(v).point - point).norm() <= distance)
    {
      mesh.point(v).point = point;
      mesh.point(v).is_fixed = true;
    }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_FIX_APEXES_H
