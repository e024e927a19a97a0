// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_FEATURE_CURVES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_FEATURE_CURVES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_function.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

template <typename Mesh>
Feature_curves feature_curves(const Mesh& mesh)
{
  Feature_curves result;
  std::vector<int> curves;
  for (const Edge_index e : mesh.edges())
  {
    if (!mesh.is_on_curve(e))
      continue;
    const int curve = mesh.arc(mesh.halfedge(e)).curve;
    if (curve >= 0)
      curves.push_back(curve);
    result.length += (mesh.point(mesh.vertex(e, 0)).point - mesh.point(mesh.vertex(e, 1)).point).norm();
  }
  std::sort(curves.begin(), curves.end());
  result.number_of_curves = std::size_t(std::unique(curves.begin(), curves.end()) - curves.begin());
  for (const Vertex_index v : mesh.vertices())
    result.number_of_corners += mesh.point(v).is_on_curve && mesh.point(v).is_fixed ? 1 : 0;
  return result;
}

// whether there are edges between regions that are to be sharp, other than the boundary
template <typename Mesh>
bool has_creases(const Mesh& mesh, const bool is_piecewise)
{
  if (is_piecewise)
    for (const Edge_index e : mesh.edges())
      if (mesh.is_on_curve(e) && !mesh.is_border(e))
        return true;
  return false;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_FEATURE_CURVES_H
