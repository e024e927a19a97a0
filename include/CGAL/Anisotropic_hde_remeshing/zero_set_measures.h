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
#include <CGAL/Anisotropic_hde_remeshing/internal/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/named_parameters.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

\brief measures how far a triangle mesh is from the zero set of an implicit function.

The points sampled on the faces are spread evenly over the area, without random numbers: a second call gives the same
result, as does another number of threads.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how the function is evaluated
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam Function a model of `ImplicitFunctionWithGradient`, or of `PiecewiseImplicitFunction`, which needs `face_patch_map`
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param f the implicit function
\param np optional named parameters: `vertex_point_map`, `geom_traits` and `number_of_points_on_faces` (the number of
points sampled on the faces, by default 200,000)

\pre `is_triangle_mesh(tmesh)`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
Zero_set_measures measure_distance_to_zero_set(const TriangleMesh& tmesh, const Function& f,
                                               const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const internal::Measured_mesh mesh = internal::read_measured_mesh_of(f, tmesh, np);
  const std::size_t number_of_samples = static_cast<std::size_t>(
      choose_parameter(get_parameter(np, internal_np::number_of_points_on_faces), std::size_t(200000)));
  const auto distance = [&f](const internal::Vector& p, const internal::Region region)
  { return internal::first_order_distance(internal::value_and_gradient_of(internal::piece(f, region), p)); };
  const auto vertex_max = [&](const bool on_boundary)
  {
    const auto distance_of_vertex = [&](const std::size_t v)
    {
      const bool is_meant = static_cast<bool>(mesh.is_on_boundary[v]) == on_boundary;
      return is_meant ? distance(mesh.points[v], mesh.point_regions[v]) : 0;
    };
    return internal::rms_and_max<ConcurrencyTag>(mesh.points.size(), distance_of_vertex).max;
  };

  const internal::Area_sampler sampler(mesh, number_of_samples);
  const internal::Rms_and_max of_faces = internal::rms_and_max<ConcurrencyTag>(
      sampler.size(), [&](const std::size_t i) { return distance(sampler(i), mesh.face_regions[sampler.face(i)]); });
  Zero_set_measures measures;
  measures.interior_vertex_max = vertex_max(false);
  measures.boundary_vertex_max = vertex_max(true);
  measures.face_rms = of_faces.rms;
  measures.face_max = of_faces.max;
  measures.number_of_samples = sampler.size();
  return measures;
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_ZERO_SET_MEASURES_H
