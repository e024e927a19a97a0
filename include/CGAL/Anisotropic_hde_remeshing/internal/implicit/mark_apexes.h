// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_MARK_APEXES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_MARK_APEXES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/is_apex.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <boost/math/constants/constants.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The angle defects of the vertices. They are 0 where they say nothing: at the boundary, and where more than two facets meet.
inline std::vector<double> angle_defects(const Surface_sample& sample, const Facet_edges& edges)
{
  std::vector<double> result(sample.size(), 2 * boost::math::constants::pi<double>());
  std::vector<std::size_t> number_of_facets(edges.edges().size(), 0);
  for (std::size_t f = 0; f < sample.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Facet& facet = sample.facets[f];
      const Vector& p = sample.points[facet[k]];
      result[facet[k]] -= angle_between(sample.points[facet[(k + 1) % 3]] - p, sample.points[facet[(k + 2) % 3]] - p);
      ++number_of_facets[edges.edge(f, k)];
    }
  for (std::size_t e = 0; e < edges.edges().size(); ++e)
    if (number_of_facets[e] != 2)
      result[edges.edges()[e].first] = result[edges.edges()[e].second] = 0;
  return result;
}

// Marks the tips of cones and spikes. The normal there would be that of a blunt tip.
inline void mark_apexes(Surface_sample& sample, const Facet_edges& edges)
{
  const std::vector<double> defects = angle_defects(sample, edges);
  std::vector<char> is_tip(sample.size(), 1);
  for (const Facet_edges::Edge& e : edges.edges())
  {
    if (!is_apex(defects[e.first], defects[e.second]))
      is_tip[e.first] = 0;
    if (!is_apex(defects[e.second], defects[e.first]))
      is_tip[e.second] = 0;
  }
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (is_tip[i] != 0 && is_apex(defects[i], 0))
    {
      sample.is_on_edge.resize(sample.size(), 0);
      sample.is_on_edge[i] = 1;
    }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_MARK_APEXES_H
