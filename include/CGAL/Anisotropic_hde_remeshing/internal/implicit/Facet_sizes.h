// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_SIZES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_SIZES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Altitudes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// How long an edge may be at any place of the facets for the vertices to determine the surface there. It begins with the
// altitudes at the vertices. Sizes grow gradually, from vertex to vertex and inside of facets, so that what is small is felt
// around. Where the surface bends, the radius of the bend bounds the growth inside of a facet.
class Facet_sizes
{
  // the growth over a length, from vertex to vertex and inside of a facet
  static constexpr double growth = 0.5, inner_growth = 0.25;
  // largest size inside of a facet, over the radius
  static constexpr double share_of_radius = 0.3;

public:
  Facet_sizes(const Surface_sample& sample, const Facet_edges& edges)
    : m_sample(sample), m_sizes(Altitudes(sample).sizes()), m_radii(sample.facets.size())
  {
    measure_radii(edges);
    grade(edges);
  }

  // infinite if no facet around has an area
  double operator()(const std::size_t vertex) const { return m_sizes[vertex]; }

  // at a point of a facet, by its barycentric coordinates
  double operator()(const std::size_t f, const Vector& p, const Vector& barycentric) const
  {
    const Facet& facet = m_sample.facets[f];
    double mean = 0, grown = (std::numeric_limits<double>::infinity)();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double size = m_sizes[facet[k]], weight = barycentric[Eigen::Index(k)];
      mean += weight > 0 ? weight * size : 0.;
      grown = (std::min)(grown, size + inner_growth * (p - m_sample.points[facet[k]]).norm());
    }
    return (std::min)(grown, (std::max)(mean, share_of_radius * m_radii[f]));
  }

  // of the bend at a facet: its altitude over the turn, the least at its edges; infinite if it is flat there
  double radius(const std::size_t f) const { return m_radii[f]; }

private:
  double length(const std::size_t i, const std::size_t j) const { return (m_sample.points[i] - m_sample.points[j]).norm(); }

  void measure_radii(const Facet_edges& edges)
  {
    for (std::size_t f = 0; f < m_sample.facets.size(); ++f)
    {
      const Facet& facet = m_sample.facets[f];
      const Vector& p = m_sample.points[facet[0]];
      const double area = (m_sample.points[facet[1]] - p).cross(m_sample.points[facet[2]] - p).norm();
      double bend = 0;
      for (std::size_t k = 0; k < 3; ++k)
        bend = (std::max)(bend, 2 * angle_between(edges.facet_normal(f), edges.edge_normal(edges.edge(f, k))) *
                                    length(facet[k], facet[(k + 1) % 3]));
      m_radii[f] = bend > 0 ? area / bend : (std::numeric_limits<double>::infinity)();
    }
  }

  // by the algorithm of Dijkstra, from the vertices next to which one is too large
  void grade(const Facet_edges& edges)
  {
    std::vector<std::size_t> first(m_sample.size() + 1, 0), neighbors(2 * edges.edges().size());
    for (const Facet_edges::Edge& e : edges.edges())
      for (const std::size_t i : {e.first, e.second})
        ++first[i + 1];
    for (std::size_t i = 0; i < m_sample.size(); ++i)
      first[i + 1] += first[i];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    typedef std::pair<double, std::size_t> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto grow = [&](const std::size_t from, const std::size_t to)
    {
      const double size = m_sizes[from] + growth * length(from, to);
      if (!(size < m_sizes[to]))
        return;
      m_sizes[to] = size;
      queue.push(Entry(size, to));
    };
    for (const Facet_edges::Edge& e : edges.edges())
    {
      neighbors[next[e.first]++] = e.second;
      neighbors[next[e.second]++] = e.first;
      grow(e.first, e.second);
      grow(e.second, e.first);
    }
    while (!queue.empty())
    {
      const Entry entry = queue.top();
      queue.pop();
      if (entry.first == m_sizes[entry.second])
        for (std::size_t k = first[entry.second]; k < first[entry.second + 1]; ++k)
          grow(entry.second, neighbors[k]);
    }
  }

  const Surface_sample& m_sample;
  std::vector<double> m_sizes; // by vertex
  std::vector<double> m_radii; // by facet: the least altitude over the turn at its edge
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_SIZES_H
