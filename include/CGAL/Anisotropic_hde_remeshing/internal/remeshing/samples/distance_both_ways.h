// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_DISTANCE_BOTH_WAYS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_DISTANCE_BOTH_WAYS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The root mean square and the largest of the distances of a mesh to some facets, at points spread over its area and at its vertices.
template <typename ConcurrencyTag>
Rms_and_max distance_to_facets(const Measured_mesh& mesh, const Closest_facet& facets)
{
  static constexpr std::size_t points_per_face = 10, least_number_of_points = 5000;
  const auto distance = [&](const Vector& p) { return (p - facets(p).point).norm(); };
  const Area_sampler sampler(mesh, (std::max)(points_per_face * mesh.faces.size(), least_number_of_points));
  Rms_and_max result = rms_and_max<ConcurrencyTag>(sampler.size(), [&](const std::size_t i) { return distance(sampler(i)); });
  const Rms_and_max of_vertices =
      rms_and_max<ConcurrencyTag>(mesh.points.size(), [&](const std::size_t v) { return distance(mesh.points[v]); });
  result.max = (std::max)(result.max, of_vertices.max);
  return result;
}

// the same both ways between a mesh and the input
template <typename ConcurrencyTag, typename Mesh>
Rms_and_max distance_both_ways(const Mesh& mesh, const Input_surface& input)
{
  Measured_mesh of_mesh, of_input;
  std::vector<std::size_t> index(vertex_capacity(mesh), 0);
  for (const Vertex_index v : mesh.vertices())
  {
    index[v] = of_mesh.points.size();
    of_mesh.points.push_back(mesh.point(v).point);
  }
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    of_mesh.faces.push_back({index[t.a], index[t.b], index[t.c]});
  }
  of_input.points = input.points();
  of_input.faces = input.facets();
  const Closest_facet closest(of_mesh.points, of_mesh.faces);
  if (closest.empty() || input.empty())
    return Rms_and_max();
  const Rms_and_max there = distance_to_facets<ConcurrencyTag>(of_mesh, input.closest_facet()),
                    back = distance_to_facets<ConcurrencyTag>(of_input, closest);
  Rms_and_max result;
  result.rms = std::sqrt((there.rms * there.rms + back.rms * back.rms) / 2);
  result.max = (std::max)(there.max, back.max);
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_DISTANCE_BOTH_WAYS_H
