// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_HAS_LONG_FACETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_HAS_LONG_FACETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Whether the faces are those of a CAD program: exact facets, as long as the part is, between which nothing is known of the surface.
// Then the facets themselves are the surface. So it is if long faces have a good part of the area; on scans hardly any has.
template <typename FaceRange, typename TriangleMesh, typename VertexPointMap>
bool has_long_facets(const FaceRange& range, const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  static constexpr double longest_ratio = 8;    // of the longest edge to the altitude over it
  static constexpr double largest_share = 0.25; // of the area
  double area = 0, area_of_long = 0;
  for_each_of_range(range,
                    [&](const auto f)
                    {
                      const auto h = halfedge(f, tmesh);
                      const auto point = [&](const auto v) { return to_vector(value_of(vpm, v)); };
                      const Vector a = point(source(h, tmesh)), b = point(target(h, tmesh)),
                                   c = point(target(next(h, tmesh), tmesh));
                      const double twice_the_area = (b - a).cross(c - a).norm(),
                                   longest = (std::max)({(b - a).norm(), (c - b).norm(), (a - c).norm()});
                      area += twice_the_area;
                      if (longest * longest > longest_ratio * twice_the_area)
                        area_of_long += twice_the_area;
                    });
  return area_of_long > largest_share * area;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_HAS_LONG_FACETS_H
