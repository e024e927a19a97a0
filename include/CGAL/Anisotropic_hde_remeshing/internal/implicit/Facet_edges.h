// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_EDGES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_EDGES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The edges of the facets of a sample, each once, and the normals there. Edge k of a facet leads from its k-th vertex to the next.
class Facet_edges
{
public:
  typedef std::pair<std::size_t, std::size_t> Edge; // two vertices, the smaller index first

  explicit Facet_edges(const Surface_sample& sample) : m_facet_normals(sample.facets.size()), m_edges_of(sample.facets.size())
  {
    std::vector<std::tuple<Edge, std::size_t, std::size_t>> sides; // the edge, the facet, and the number of the edge in it
    sides.reserve(3 * sample.facets.size());
    for (std::size_t f = 0; f < sample.facets.size(); ++f)
    {
      const Facet& facet = sample.facets[f];
      const Vector& p = sample.points[facet[0]];
      const Vector area = (sample.points[facet[1]] - p).cross(sample.points[facet[2]] - p);
      m_facet_normals[f] = area.norm() > 0 ? Vector(area.normalized()) : Vector(Vector::Zero());
      for (std::size_t k = 0; k < 3; ++k)
        sides.emplace_back(std::minmax(facet[k], facet[(k + 1) % 3]), f, k);
    }
    std::sort(sides.begin(), sides.end());
    for (const auto& [edge, f, k] : sides)
    {
      if (m_edges.empty() || m_edges.back() != edge)
      {
        m_edges.push_back(edge);
        m_sums.push_back(Vector::Zero());
        m_is_sharp.push_back(0);
      }
      else if (!m_facet_normals[f].isZero(0) && !m_sums.back().isZero(0))
        m_is_sharp.back() = angle_between(m_sums.back(), m_facet_normals[f]) > least_turn_of_edge;
      m_sums.back() += m_facet_normals[f];
      m_edges_of[f][k] = m_edges.size() - 1;
    }
  }

  const std::vector<Edge>& edges() const { return m_edges; }

  // the index of edge `k` of facet `f`
  std::size_t edge(const std::size_t f, const std::size_t k) const { return m_edges_of[f][k]; }

  // Whether the surface has an edge there: a smooth one would have to bend as sharply as its facets are wide.
  bool is_sharp(const std::size_t edge) const { return m_is_sharp[edge] != 0; }

  // zero if the facet is degenerate
  const Vector& facet_normal(const std::size_t f) const { return m_facet_normals[f]; }

  // the mean of those of the facets there; zero if these cancel
  Vector edge_normal(const std::size_t edge) const
  {
    static constexpr double cancelled = 1e-6;
    return m_sums[edge].norm() > cancelled ? Vector(m_sums[edge].normalized()) : Vector(Vector::Zero());
  }

private:
  // Radians. The tubes of seven sides and more are smooth.
  static constexpr double least_turn_of_edge = 1;

  std::vector<Vector> m_facet_normals;
  std::vector<std::array<std::size_t, 3>> m_edges_of;
  std::vector<Edge> m_edges;
  std::vector<Vector> m_sums;   // by edge, of the normals of its facets
  std::vector<char> m_is_sharp; // by edge
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_EDGES_H
