// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_CHECK_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_CHECK_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Points_on_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Whether the zero set stays near the facets, at the middles of all edges and at the centres of all facets. There it may be as far
// off as an arc with the normals at the vertices rises above its chord, and a share of the spacing more, times a factor. Places
// have numbers: the edges first, then the facets.
class Facet_check
{
  static constexpr double factor = 2, share_of_spacing = 0.1;
  // An arc is no longer than that, in spacings: longer edges have other points near. It is no steeper at its ends than that, as a
  // sine: normals that are turned more are those of an edge of the surface, and explain nothing.
  static constexpr double longest_arc = 2, steepest = 0.3;

public:
  struct Place
  {
    Vector point, normal;
    double bound;    // on the distance to the zero set
    bool is_on_edge; // of the surface
  };

  // keeps a reference to the edges. The bounds are those of the spacings that the sample has now.
  Facet_check(const Surface_sample& sample, const Facet_edges& edges)
    : m_points(sample.points),
      m_normals(sample.normals),
      m_spacings(sample.spacings),
      m_is_on_edge(sample.is_on_edge),
      m_facets(sample.facets),
      m_edges(edges)
  {
  }

  std::size_t size() const { return m_edges.edges().size() + m_facets.size(); }

  // `bound` is 0 where there is no place: at a degenerate facet or edge
  Place place(const std::size_t number) const
  {
    if (number < m_edges.edges().size())
      return place_of_edge(number);
    return place_of_facet(number - m_edges.edges().size());
  }

  // The places to become points, out of those that have failed: the middles of edges, and the centres of facets of which no edge
  // has failed. `failed` is sorted.
  std::vector<std::size_t> to_refine(const std::vector<std::size_t>& failed) const
  {
    std::vector<std::size_t> result;
    const auto has_failed = [&](const std::size_t number) { return std::binary_search(failed.begin(), failed.end(), number); };
    for (const std::size_t number : failed)
    {
      const std::size_t f = number - m_edges.edges().size();
      if (number < m_edges.edges().size() ||
          !(has_failed(m_edges.edge(f, 0)) || has_failed(m_edges.edge(f, 1)) || has_failed(m_edges.edge(f, 2))))
        result.push_back(number);
    }
    return result;
  }

  // the vertices around a place
  std::vector<std::size_t> vertices(const std::size_t number) const
  {
    if (number < m_edges.edges().size())
      return {m_edges.edges()[number].first, m_edges.edges()[number].second};
    const Facet& facet = m_facets[number - m_edges.edges().size()];
    return {facet[0], facet[1], facet[2]};
  }

private:
  double rise(const std::size_t edge) const
  {
    const auto [i, j] = m_edges.edges()[edge];
    const Vector way = m_points[j] - m_points[i];
    const double length = way.norm(), arc = (std::min)(length, longest_arc * 0.5 * (m_spacings[i] + m_spacings[j]));
    const auto slope = [&](const std::size_t v)
    {
      const bool is_on_edge = !m_is_on_edge.empty() && m_is_on_edge[v] != 0;
      return is_on_edge ? 0. : (std::min)(std::abs(way.dot(m_normals[v])) / length, steepest);
    };
    return length > 0 ? arc * (slope(i) + slope(j)) / 8 : 0.;
  }

  Place place_of_edge(const std::size_t edge) const
  {
    const auto [i, j] = m_edges.edges()[edge];
    const double spacing = 0.5 * (m_spacings[i] + m_spacings[j]);
    const Vector normal = m_edges.edge_normal(edge);
    return Place{0.5 * (m_points[i] + m_points[j]), normal,
                 normal.isZero(0) || i == j ? 0. : factor * (rise(edge) + share_of_spacing * spacing), m_edges.is_sharp(edge)};
  }

  Place place_of_facet(const std::size_t f) const
  {
    // a quadratic over a triangle has this share of the rises of its edges at the centre
    static constexpr double share_of_rises = 4. / 9;
    const Facet& facet = m_facets[f];
    Place result{Vector::Zero(), m_edges.facet_normal(f), 0, false};
    double spacing = 0, rises = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.point += m_points[facet[k]] / 3;
      spacing += m_spacings[facet[k]] / 3;
      rises += rise(m_edges.edge(f, k));
    }
    if (!result.normal.isZero(0))
      result.bound = factor * (share_of_rises * rises + share_of_spacing * spacing);
    return result;
  }

  const std::vector<Vector> m_points, m_normals;
  const std::vector<double> m_spacings;
  const std::vector<char> m_is_on_edge;
  const std::vector<Facet> m_facets;
  const Facet_edges& m_edges;
};

// adds the places with these numbers to the sample as points on facets
template <typename ConcurrencyTag>
void add_places(const Facet_check& check, const std::vector<std::size_t>& numbers, Surface_sample& sample,
                Interruption& interruption)
{
  std::vector<std::size_t> changed;
  for (const std::size_t number : numbers)
  {
    const Facet_check::Place place = check.place(number);
    const std::vector<std::size_t> around = check.vertices(number);
    changed.insert(changed.end(), around.begin(), around.end());
    changed.push_back(sample.size());
    sample.add_point_on_facet(place.point, place.normal, place.is_on_edge);
  }
  update_spacings<ConcurrencyTag>(sample, changed, interruption);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_CHECK_H
