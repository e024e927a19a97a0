// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_EXPECTED_HEIGHTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_EXPECTED_HEIGHTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Indexed_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

struct Expected_heights
{
  double mean;
  std::vector<double> at_vertices;
};

// How high the surface rises over an edge that is as long in the embedding as asked for, by what an edge of the mesh in its
// direction tells. An edge of length s whose normal turns by t stands for a circular arc: its height is s t / 8. Another edge has
// another s and t, both in proportion to its length in the embedding.
template <typename Vertex>
double expected_height(const Vertex& a, const Vertex& b, const double length, const double squared_embedded_length)
{
  static constexpr double largest_turn = 1; // radians; a chord does not stand for a longer arc, nor for a thinner part
  const double turn = std::acos((std::min)((std::max)(a.normal.dot(b.normal), -1.), 1.));
  if (!(squared_embedded_length > 0) || !(turn > 0))
    return 0;
  const double radius = (b.point - a.point).norm() / turn,
               turn_of_other = (std::min)(turn * length / std::sqrt(squared_embedded_length), largest_turn);
  return radius * turn_of_other * turn_of_other / 8;
}

// The heights expected around each vertex of the mesh as it is now, the largest of its edges, and their root mean square over the
// surface. `length` is the one in the embedding that is aimed at.
template <typename ConcurrencyTag, typename Mesh, typename Embedding>
Expected_heights expected_heights(const Mesh& mesh, const Embedding& embedding, const double length)
{
  std::vector<double> heights(edge_capacity(mesh), 0.), areas(edge_capacity(mesh), 0.);
  parallel_for<ConcurrencyTag>(edge_capacity(mesh),
                               [&](const std::size_t i)
                               {
                                 const Edge_index e(static_cast<Edge_index::size_type>(i));
                                 if (mesh.is_removed(e))
                                   return;
                                 const Halfedge_index h = mesh.halfedge(e);
                                 heights[i] = expected_height(mesh.state(mesh.source(h), h), mesh.state(mesh.target(h), h),
                                                              length, squared_length(e, mesh, embedding));
                                 for (const Halfedge_index side : {h, mesh.opposite(h)})
                                   areas[i] += mesh.is_border(side) ? 0. : face_normal(side, mesh).norm();
                               });
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    sum += areas[i] * heights[i] * heights[i];
    area += areas[i];
  }
  Expected_heights result{area > 0 ? std::sqrt(sum / area) : 0., std::vector<double>(vertex_capacity(mesh), 0.)};
  for (const Edge_index e : mesh.edges())
    for (const Vertex_index v : {mesh.vertex(e, 0), mesh.vertex(e, 1)})
      result.at_vertices[v] = (std::max)(result.at_vertices[v], heights[e]);
  return result;
}

// the same for the edges of each triangle and a length in space; numbers of vertices tell which triangles are neighbours
template <typename ConcurrencyTag>
std::vector<double> heights_over_triangles(const std::vector<Indexed_triangle>& triangles, const double length)
{
  struct Vertex
  {
    Vector point, normal;
  };
  std::size_t number_of_vertices = 0;
  for (const Indexed_triangle& t : triangles)
    number_of_vertices = (std::max)({number_of_vertices, t.vertices[0] + 1, t.vertices[1] + 1, t.vertices[2] + 1});
  std::vector<Vertex> vertices(number_of_vertices, Vertex{Vector::Zero(), Vector::Zero()});
  for (const Indexed_triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
    {
      vertices[t.vertices[k]].point = t.points[k];
      vertices[t.vertices[k]].normal += t.normal();
    }
  for (Vertex& v : vertices)
    v.normal.stableNormalize();
  std::vector<double> result(triangles.size());
  parallel_for<ConcurrencyTag>(triangles.size(),
                               [&](const std::size_t i)
                               {
                                 for (std::size_t k = 0; k < 3; ++k)
                                 {
                                   const Vertex &a = vertices[triangles[i].vertices[k]],
                                                &b = vertices[triangles[i].vertices[(k + 1) % 3]];
                                   result[i] =
                                       (std::max)(result[i], expected_height(a, b, length, (b.point - a.point).squaredNorm()));
                                 }
                               });
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_EXPECTED_HEIGHTS_H
