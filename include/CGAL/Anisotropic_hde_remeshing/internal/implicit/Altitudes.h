// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ALTITUDES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ALTITUDES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The size of a vertex is between the least and the mean altitude of its facets: the least of them alone would follow every bad
// triangle.
class Altitudes
{
  // over the longest edge; flatter facets say nothing
  static constexpr double least_altitude = 1e-3;

public:
  explicit Altitudes(const Surface_sample& sample)
    : m_sizes(sample.size(), (std::numeric_limits<double>::infinity)()), m_longest_edges(sample.size(), 0)
  {
    std::vector<double> sums(sample.size(), 0), weights(sample.size(), 0);
    for (const Facet& facet : sample.facets)
    {
      const Vector &p = sample.points[facet[0]], &q = sample.points[facet[1]], &r = sample.points[facet[2]];
      const double area = (q - p).cross(r - p).norm();
      const double longest = (std::max)({(q - p).norm(), (r - q).norm(), (p - r).norm()});
      const double altitude = longest > 0 ? area / longest : 0.;
      if (!(altitude > least_altitude * longest))
        continue;
      for (const std::size_t i : facet)
      {
        m_longest_edges[i] = (std::max)(m_longest_edges[i], longest);
        m_sizes[i] = (std::min)(m_sizes[i], altitude);
        sums[i] += area * altitude;
        weights[i] += area;
      }
    }
    for (std::size_t i = 0; i < m_sizes.size(); ++i)
      if (weights[i] > 0)
        m_sizes[i] = std::sqrt(m_sizes[i] * sums[i] / weights[i]);
  }

  // infinite if no facet around has an area
  double size(const std::size_t vertex) const { return m_sizes[vertex]; }

  const std::vector<double>& sizes() const { return m_sizes; }

  // of the facets at the vertex
  double longest_edge(const std::size_t vertex) const { return m_longest_edges[vertex]; }

private:
  std::vector<double> m_sizes, m_longest_edges; // by vertex
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ALTITUDES_H
