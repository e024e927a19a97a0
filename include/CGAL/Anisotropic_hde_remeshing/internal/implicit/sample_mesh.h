// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The normal of a vertex is the mean of its faces' unit normals, weighted by the angles of the faces at the vertex, which
// does not depend on how the surface is triangulated; its spacing is the mean length of its edges.
template <typename TriangleMesh, typename VertexPointMap>
void normal_and_spacing(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const Vector& p,
                        const TriangleMesh& tmesh, const VertexPointMap vpm, Vector& normal, double& spacing)
{
  normal.setZero();
  spacing = 0;
  std::size_t degree = 0;
  for (const auto h : halfedges_around_target(v, tmesh))
  {
    const Vector out = to_vector(get(vpm, source(h, tmesh))) - p;
    spacing += out.norm();
    ++degree;
    if (is_border(h, tmesh))
      continue;
    const Vector along = to_vector(get(vpm, target(next(h, tmesh), tmesh))) - p;
    const Vector area = along.cross(out);
    if (area.norm() > 0)
      normal += area.normalized() * std::atan2(area.norm(), along.dot(out));
  }
  spacing /= double((std::max)(degree, std::size_t(1)));
  if (normal.norm() > 0)
    normal.normalize();
}

// `VertexNormalMap` may be internal_np::Param_not_found: then the normals are computed. The normals of the caller are
// normalised; a zero one is kept, and means that the vertex has no off-surface point.
template <typename TriangleMesh, typename VertexPointMap, typename VertexNormalMap>
Surface_sample sample_mesh(const TriangleMesh& tmesh, const VertexPointMap vpm, const VertexNormalMap vnm)
{
  Surface_sample sample;
  const auto new_index = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  std::size_t index = 0;
  for (const auto v : vertices(tmesh))
  {
    const std::size_t this_index = index++;
    if (halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      ++sample.number_of_isolated_vertices;
      continue;
    }
    const Vector p = finite_vector(get(vpm, v), "point", this_index);
    Vector normal;
    double spacing;
    normal_and_spacing(v, p, tmesh, vpm, normal, spacing);
    if constexpr (!std::is_same<VertexNormalMap, internal_np::Param_not_found>::value)
      normal = unit_normal(get(vnm, v), this_index);
    put(new_index, v, sample.size());
    sample.points.push_back(p);
    sample.normals.push_back(normal);
    sample.spacings.push_back(spacing);
  }
  for (const auto f : faces(tmesh))
  {
    // polygons as fans
    const auto first = halfedge(f, tmesh);
    for (auto h = next(first, tmesh); target(h, tmesh) != source(first, tmesh); h = next(h, tmesh))
      sample.facets.push_back({get(new_index, source(first, tmesh)), get(new_index, source(h, tmesh)),
                               get(new_index, target(h, tmesh))});
  }
  merge_duplicate_points(sample);
  return sample;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_MESH_H
