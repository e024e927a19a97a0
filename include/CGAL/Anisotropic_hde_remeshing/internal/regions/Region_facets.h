// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_FACETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_FACETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The distance to the plane through the closest point of a region's facets, perpendicular to the interpolated normal there. The
// zero set is the facets. Beyond the boundary of the region it goes on along their tangent planes. A distance to the closest
// point would turn there. As this one does not, its zero set can be intersected with that of the region next to it.
class Region_facets
{
  // the least cosine between the interpolated normal and that of the facet; below it, the interpolated normal is of no use
  static constexpr double least_cosine = 0.2;

public:
  explicit Region_facets(Surface_sample sample) : m_sample(std::move(sample)), m_closest_facet(m_sample.points, m_sample.facets)
  {
  }
  Region_facets(const Region_facets&) = delete;
  Region_facets& operator=(const Region_facets&) = delete;

  // whether all facets are degenerate: then there is no distance
  bool empty() const { return m_closest_facet.empty(); }

  Value_and_gradient operator()(const Vector& p) const
  {
    const Vector normalized = m_sample.normalization(p);
    const Closest_facet::Answer answer = m_closest_facet(normalized);
    const Facet& facet = m_sample.facets[answer.facet];
    const Vector &a = m_sample.points[facet[0]], &b = m_sample.points[facet[1]], &c = m_sample.points[facet[2]];
    const Vector of_facet = (b - a).cross(c - a).normalized();
    Vector normal = Vector::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      normal += answer.barycentric[Eigen::Index(k)] * m_sample.normals[facet[k]];
    normal.normalize();
    if (!(normal.dot(of_facet) > least_cosine))
      normal = of_facet;
    return Value_and_gradient{{normal.dot(normalized - answer.point) / m_sample.normalization.scale}, normal};
  }

  std::size_t memory_bytes() const { return memory_bytes_of(m_sample); }

private:
  const Surface_sample m_sample;
  const Closest_facet m_closest_facet;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_FACETS_H
