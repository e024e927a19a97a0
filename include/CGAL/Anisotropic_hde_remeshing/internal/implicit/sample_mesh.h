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
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The normal of a vertex is the mean of the unit normals of its faces, weighted by the angles of the faces at the vertex. It
// does not depend on how the surface is triangulated. (PMP's compute_vertex_normal() is the most visible direction, another one.)
// The spacing of a vertex is the mean length of its edges. `point_of` gives
// the normalised point of a vertex.
template <typename TriangleMesh, typename PointOf>
void normal_and_spacing(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tmesh,
                        const PointOf& point_of, Vector& normal, double& spacing)
{
  const Vector& p = point_of(v); // the reference keeps a temporary alive
  normal.setZero();
  spacing = 0;
  std::size_t degree = 0;
  for (const auto h : halfedges_around_target(v, tmesh))
  {
    const Vector out = point_of(source(h, tmesh)) - p;
    spacing += out.norm();
    ++degree;
    if (is_border(h, tmesh))
      continue;
    const Vector along = point_of(target(next(h, tmesh), tmesh)) - p;
    const Vector area = along.cross(out);
    if (area.norm() > 0)
      normal += area.normalized() * std::atan2(area.norm(), along.dot(out));
  }
  spacing /= double((std::max)(degree, std::size_t(1)));
  if (normal.norm() > 0)
    normal.normalize();
}

// the facets of a mesh; polygons are divided into fans
template <typename TriangleMesh, typename IndexOf>
std::vector<Facet> facets_of(const TriangleMesh& tmesh, const IndexOf& index_of)
{
  std::vector<Facet> result;
  result.reserve(num_faces(tmesh));
  for (const auto f : faces(tmesh))
  {
    const auto first = halfedge(f, tmesh);
    for (auto h = next(first, tmesh); target(h, tmesh) != source(first, tmesh); h = next(h, tmesh))
      result.push_back({index_of(source(first, tmesh)), index_of(source(h, tmesh)), index_of(target(h, tmesh))});
  }
  return result;
}

// `VertexNormalMap` may be internal_np::Param_not_found: then the normals are computed. The normals of the caller are
// normalised. A zero one is kept. It means that the vertex has no off-surface point.
template <typename TriangleMesh, typename VertexPointMap, typename VertexNormalMap>
Surface_sample sample_mesh(const TriangleMesh& tmesh, const VertexPointMap vpm, const VertexNormalMap vnm,
                           Interruption& interruption)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
  Surface_sample sample;
  const auto new_index = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  std::vector<Vertex> used;
  std::vector<std::size_t> index_in_mesh; // of the used ones, for messages
  std::size_t index = 0;
  for (const Vertex v : vertices(tmesh))
  {
    interruption.check();
    const std::size_t this_index = index++;
    if (halfedge(v, tmesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      ++sample.number_of_isolated_vertices;
      continue;
    }
    put(new_index, v, sample.size());
    sample.points.push_back(finite_vector(value_of(vpm, v), "point", this_index));
    used.push_back(v);
    index_in_mesh.push_back(this_index);
  }
  sample.normalization = normalize(sample.points);

  sample.normals.resize(used.size());
  sample.spacings.resize(used.size());
  const auto point_of = [&](const Vertex v) -> const Vector& { return sample.points[get(new_index, v)]; };
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    interruption.check();
    normal_and_spacing(used[i], tmesh, point_of, sample.normals[i], sample.spacings[i]);
    if constexpr (!std::is_same<VertexNormalMap, internal_np::Param_not_found>::value)
      sample.normals[i] = unit_normal(value_of(vnm, used[i]), index_in_mesh[i]);
  }
  sample.facets = facets_of(tmesh, [&](const Vertex v) { return get(new_index, v); });
  merge_duplicate_points(sample);
  return sample;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_MESH_H
