// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_ZERO_SET_MEASURES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_ZERO_SET_MEASURES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Zero_set_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// If no way leads from a vertex to the zero set, its distance is at most that of a neighbour plus the way to this neighbour.
inline void bound_by_neighbors(const Measured_mesh& mesh, std::vector<double>& of_vertices)
{
  bool has_changed = true;
  const auto bound = [&](const std::size_t v, const std::size_t neighbor)
  {
    if (std::isfinite(of_vertices[v]) || !std::isfinite(of_vertices[neighbor]))
      return;
    of_vertices[v] = (mesh.points[v] - mesh.points[neighbor]).norm() + of_vertices[neighbor];
    has_changed = true;
  };
  while (has_changed)
  {
    has_changed = false;
    for (const std::pair<std::size_t, std::size_t>& edge : mesh.edges)
    {
      bound(edge.first, edge.second);
      bound(edge.second, edge.first);
    }
  }
}

// the distance of the i-th point; `of_vertices` has the distances of the vertices
template <typename Function>
double distance_of_sample(const Area_sampler& sampler, const std::size_t i, const Measured_mesh& mesh,
                          const std::vector<double>& of_vertices, const Function& f, const double size)
{
  const std::size_t face = sampler.face(i);
  const Vector p = sampler(i);
  const auto bound = [&](const std::size_t v) { return (p - mesh.points[v]).norm() + of_vertices[v]; };
  std::size_t nearest = mesh.faces[face][0];
  for (const std::size_t v : mesh.faces[face])
    if (bound(v) < bound(nearest))
      nearest = v;
  return zero_set_distance(piece(f, mesh.face_regions[face]), size)(p, mesh.points[nearest], of_vertices[nearest]);
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

\brief measures how far a triangle mesh is from the zero set of an implicit function.

Newton's method leads from a point to the zero set, along the gradient. Steps along the tangent planes lead on to the nearest
point of the zero set around. The distance to that point is measured. It is not less than the true distance, and the same up
to a ten-thousandth wherever the nearest point of the zero set is found. If no point of the zero set is found, the distance is
bounded by that of a neighbouring vertex: the distance to this vertex plus its distance to the zero set. It is infinite if no
vertex around has found the zero set.

The sampled points are spread evenly over the area, without random numbers. So a second call and another number of threads give
the same result.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how the function is evaluated
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam Function a model of `ImplicitFunctionWithGradient`, or of `PiecewiseImplicitFunction`, which needs `face_patch_map`
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param f the implicit function
\param np optional named parameters: `vertex_point_map`, `geom_traits` and `number_of_points_on_faces` (the number of
points sampled on the faces, by default 200,000)

\throw std::invalid_argument if `number_of_points_on_faces` is less than 1
\throw std::invalid_argument if a face of `tmesh` is not a triangle, or a coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
Zero_set_measures measure_distance_to_zero_set(const TriangleMesh& tmesh, const Function& f,
                                               const NamedParameters& np = parameters::default_values())
{
  if constexpr (!internal::accepts_measurement<TriangleMesh, Function, NamedParameters>())
    return Zero_set_measures();
  else
  {
    const internal::Measured_mesh mesh = internal::read_measured_mesh_of(f, tmesh, np);
    const std::size_t number_of_samples = internal::number_of_samples_parameter(np);
    const double size = mesh.diagonal();
    std::vector<double> of_vertices(mesh.points.size());
    internal::parallel_for<ConcurrencyTag>(of_vertices.size(),
                                           [&](const std::size_t v)
                                           {
                                             const auto& piece = internal::piece(f, mesh.point_regions[v]);
                                             of_vertices[v] = internal::zero_set_distance(piece, size)(mesh.points[v]);
                                           });
    internal::bound_by_neighbors(mesh, of_vertices);
    const internal::Area_sampler sampler(mesh, number_of_samples);
    const internal::Rms_and_max of_faces =
        internal::rms_and_max<ConcurrencyTag>(sampler.size(), [&](const std::size_t i)
                                              { return internal::distance_of_sample(sampler, i, mesh, of_vertices, f, size); });
    Zero_set_measures measures;
    for (std::size_t v = 0; v < of_vertices.size(); ++v)
    {
      double& largest = mesh.is_on_boundary[v] ? measures.boundary_vertex_max : measures.interior_vertex_max;
      largest = (std::max)(largest, of_vertices[v]);
    }
    measures.face_rms = of_faces.rms;
    measures.face_max = of_faces.max;
    measures.number_of_samples = sampler.size();
    return measures;
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_ZERO_SET_MEASURES_H
