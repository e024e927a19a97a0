// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FIT_REGION_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FIT_REGION_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_plane.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/has_long_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A field misses a facet if one of these is out of bounds: the distance of the zero set from the centroid of the facet, over
// the longest edge of the facet (an arc of 90 degrees has .2), and the cosine between the normals of both.
constexpr double largest_height_of_field = 0.2, least_cosine_of_field = 0.5;

// the share of the area of the facets at whose centroid the zero set is far away or turned
template <typename Field>
double share_of_missed_facets(const Field& field, const Region_mesh& region)
{
  double area = 0, missed = 0;
  for (const auto f : region.faces())
  {
    const auto h = region.halfedge(f);
    const Vector a = to_vector(region.point(region.source(h))), b = to_vector(region.point(region.target(h))),
                 c = to_vector(region.point(region.target(region.next(h)))), normal = (b - a).cross(c - a);
    const double longest = std::sqrt((std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const Vector centroid = (a + b + c) / 3;
    const Value_and_gradient at_centroid = value_and_gradient_of(field, centroid);
    const double slope = at_centroid.gradient.norm();
    const bool is_met = std::abs(at_centroid.value) <= largest_height_of_field * longest * slope &&
                        at_centroid.gradient.dot(normal) >= least_cosine_of_field * slope * normal.norm();
    area += normal.norm();
    missed += is_met ? 0 : normal.norm();
  }
  return area > 0 ? missed / area : 0;
}

// Fits the function of a region: a plane if all points are in one within `tolerance`, else a field, and the distance to the
// facets where these are kept as the long and exact ones of a CAD program, or a field is not to be had. `interruption` is that of the
// region.
template <typename ConcurrencyTag, typename RadialFunction>
Region_function<Rbf_field<RadialFunction, ConcurrencyTag>>
fit_region_function(const Region_mesh& region, const double tolerance, const Region_parameters<RadialFunction>& parameters,
                    Interruption& interruption)
{
  typedef Rbf_field<RadialFunction, ConcurrencyTag> Field;
  static constexpr std::size_t least_number_of_vertices = 10; // of a region with a field
  // the largest share of the area of a region that its field may miss
  static constexpr double largest_share_of_missed_facets = 0.02;
  if (const auto plane = plane_of(region, tolerance))
    return Region_function<Field>(*plane);
  Real_timer timer;
  timer.start();
  const auto sample = [&]
  { return sample_mesh(region, get(vertex_point, region), internal_np::Param_not_found(), interruption); };
  const bool has_exact_facets = parameters.keeps_long_facets && !(parameters.interpolation.noise > 0) &&
                                (parameters.has_mesh_long_facets || has_long_facets(region.faces(), region, region.points()));
  if (region.number_of_vertices() >= least_number_of_vertices && !has_exact_facets)
  {
    try
    {
      const auto field =
          std::make_shared<const Field>(sample(), parameters.interpolation, parameters.function, timer, interruption);
      if (share_of_missed_facets(*field, region) <= largest_share_of_missed_facets)
        return Region_function<Field>(field);
    }
    catch (const std::invalid_argument&) // parameters and points are checked already: no face has an area
    {
    }
  }
  const auto facets = std::make_shared<const Region_facets>(sample());
  return facets->empty() ? Region_function<Field>() : Region_function<Field>(facets);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FIT_REGION_FUNCTION_H
