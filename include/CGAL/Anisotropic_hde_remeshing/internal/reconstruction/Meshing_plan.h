// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_MESHING_PLAN_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_MESHING_PLAN_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/mesh_zero_set.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Whether the mesh is to be remeshed: any parameter of the remeshing is given.
template <typename NamedParameters>
constexpr bool asks_for_remeshing =
    is_error_given<NamedParameters> ||
    !is_none_given<NamedParameters, internal_np::number_of_target_faces_t, internal_np::target_edge_length_t,
                   internal_np::relative_target_edge_length_t, internal_np::sigma_t, internal_np::relative_sigma_t,
                   internal_np::embedding_t, internal_np::sizing_field_t, internal_np::fit_to_surface_t,
                   internal_np::aspect_ratio_bound_t, internal_np::remeshing_scheme_t, internal_np::number_of_iterations_t>;

// the criteria that are given; 0 for those that are not
template <typename NamedParameters>
Facet_criteria given_facet_criteria(const NamedParameters& np)
{
  using parameters::get_parameter;
  Facet_criteria result;
  if constexpr (is_given<NamedParameters, internal_np::facet_angle_t>)
    result.angle = checked_between("facet_angle", CGAL::to_double(get_parameter(np, internal_np::facet_angle)), 0, 30);
  if constexpr (is_given<NamedParameters, internal_np::facet_size_t>)
    result.size = checked_positive("facet_size", CGAL::to_double(get_parameter(np, internal_np::facet_size)));
  if constexpr (is_given<NamedParameters, internal_np::facet_distance_t>)
    result.distance = checked_positive("facet_distance", CGAL::to_double(get_parameter(np, internal_np::facet_distance)));
  return result;
}

// Facets of the spacing of the points have as many vertices as there are points. Where fewer are asked for, the remeshing divides
// larger ones; but details shall not be lost before.
template <typename NamedParameters>
double default_facet_size(const NamedParameters& np, const double spacing, const double area)
{
  static constexpr double largest_size = 4; // spacings
  if constexpr (is_given<NamedParameters, internal_np::number_of_target_faces_t>)
  {
    const double number = CGAL::to_double(parameters::get_parameter(np, internal_np::number_of_target_faces));
    const double edge = std::sqrt(4 / std::sqrt(3.) * area / number);
    return (std::max)(spacing, (std::min)(edge, largest_size * spacing));
  }
  else
    return spacing;
}

// The surface mesher as it is used here: what it is told, and what it may take.
struct Meshing_plan
{
  Facet_criteria criteria;
  std::size_t largest_number_of_evaluations = 0;
};

// The area of the surface, roughly. What closes holes is in the bounding sphere.
inline double area_to_mesh(const Rbf_diagnostics& diagnostics, const double squared_radius)
{
  return diagnostics.area + (diagnostics.number_of_holes > 0 ? 4 * CGAL_PI * squared_radius : 0.);
}

// The mesher puts no vertex nearer to another one than the radius of the smallest ball that a facet may have. The data cannot tell
// bends that are sharper than their spacing: there a ball of this radius r has a sagitta of r^2 / (2 * spacing). So many vertices
// have place on the area, and each takes so many evaluations.
inline double largest_number_of_vertices(const Facet_criteria& criteria, const double spacing, const double area)
{
  static constexpr double vertices_on_square = 1.155; // discs in a hexagonal lattice
  const double squared_distance = (std::min)(criteria.size * criteria.size, 2 * criteria.distance * spacing);
  return vertices_on_square * area / squared_distance;
}

template <typename NamedParameters>
Meshing_plan meshing_plan(const NamedParameters& np, const Rbf_diagnostics& diagnostics, const double squared_radius)
{
  static constexpr double relative_distance = 0.1; // of the size
  static constexpr double evaluations_of_vertex = 50, evaluations_at_least = 1e5;
  const double spacing = diagnostics.median_spacing, area = area_to_mesh(diagnostics, squared_radius);
  Meshing_plan plan{given_facet_criteria(np), 0};
  if (!(plan.criteria.size > 0))
    plan.criteria.size = default_facet_size(np, spacing, diagnostics.area);
  if (!(plan.criteria.distance > 0))
    plan.criteria.distance = relative_distance * plan.criteria.size;
  const double number = largest_number_of_vertices(plan.criteria, spacing, area);
  if (!(2 * number <= double(largest_number_of_faces)))
  {
    const bool is_size = plan.criteria.size * plan.criteria.size < 2 * plan.criteria.distance * spacing;
    throw_invalid_argument(is_size ? "facet_size" : "facet_distance", is_size ? plan.criteria.size : plan.criteria.distance,
                           "so large that the mesh gets at most " + text_of_number(largest_number_of_faces) + " faces");
  }
  plan.largest_number_of_evaluations = std::size_t(evaluations_at_least + evaluations_of_vertex * number);
  return plan;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_MESHING_PLAN_H
