// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ADAPTED_FACETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ADAPTED_FACETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Altitudes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Which facets say more than their vertices. Simplification adapts a mesh to a shape: it puts vertices off the surface, so that
// facets are on it in the mean. Remeshing, subdivision and scanning put vertices on the surface, and facets are below it. Two
// things tell such meshes apart. Facets of an adapted mesh are uneven: long edges meet low altitudes. And its vertices are no
// samples of one smooth surface: normals at both ends of an edge turn from it by different angles. An uneven mesh of a smooth
// surface, as an icosphere that is stretched, has the first, an even mesh of a rough surface the second. Both are shares of
// what is around a vertex, as single vertices look alike in all meshes.
class Adapted_facets
{
  // Longest edge over the size of a vertex. Of the vertices of meshes by isotropic remeshing up to 2% are beyond it, or 8% of very
  // coarse ones, of quadric simplification and of Lindstrom and Turk's at least 85%.
  static constexpr double even_length = 2.5;
  // least share of such vertices around
  static constexpr double least_uneven_share = 0.5;
  // Slopes of an edge against the normals at its ends that differ by more than this share of them are no arc's.
  static constexpr double largest_difference = 0.25;
  // slopes of flat edges are noise
  static constexpr double negligible_slope = 0.02;
  // Least share of edges around that are no arcs: .55 to .8 in adapted meshes, at most .2 in stretched icospheres.
  static constexpr double least_rough_share = 0.25;
  // How often the mean over the neighbours is taken: some ten rings of vertices count. An adapted mesh has smooth spots of a
  // few rings, at which vertices are off the surface all the same.
  static constexpr int rounds_of_means = 30;

public:
  // none
  explicit Adapted_facets(const Surface_sample& sample) : m_is_adapted(sample.facets.size(), 0), m_is_replaced(sample.size(), 0)
  {
  }

  Adapted_facets(const Surface_sample& sample, const Facet_edges& edges) : m_is_adapted(sample.facets.size(), 0)
  {
    const std::vector<char> is_adapted = adapted_vertices(sample, edges);
    m_is_replaced = is_adapted;
    std::vector<std::size_t> number_of_facets(edges.edges().size(), 0);
    for (std::size_t f = 0; f < sample.facets.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        ++number_of_facets[edges.edge(f, k)];
    for (std::size_t f = 0; f < sample.facets.size(); ++f)
    {
      const Facet& facet = sample.facets[f];
      const int number = is_adapted[facet[0]] + is_adapted[facet[1]] + is_adapted[facet[2]];
      // Where more than two facets meet they may be the same several times, and so would be their points.
      bool is_manifold = true;
      for (std::size_t k = 0; k < 3; ++k)
        is_manifold = is_manifold && number_of_facets[edges.edge(f, k)] <= 2;
      m_is_adapted[f] = number >= 2 && is_manifold && !edges.facet_normal(f).isZero(0);
      if (m_is_adapted[f] == 0)
        for (const std::size_t i : facet)
          m_is_replaced[i] = 0;
    }
    // The rim of the surface is where its vertices are.
    for (std::size_t e = 0; e < edges.edges().size(); ++e)
      if (number_of_facets[e] == 1)
        m_is_replaced[edges.edges()[e].first] = m_is_replaced[edges.edges()[e].second] = 0;
  }

  bool is_adapted(const std::size_t facet) const { return m_is_adapted[facet] != 0; }

  // whether all facets at a vertex are adapted, so that points on them stand for the vertex
  bool is_replaced(const std::size_t vertex) const { return m_is_replaced[vertex] != 0; }

private:
  // a share of what is around each vertex
  struct Shares
  {
    std::vector<double> parts, wholes;

    explicit Shares(const std::size_t n) : parts(n, 0), wholes(n, 0) {}

    double operator()(const std::size_t i) const { return wholes[i] > 0 ? parts[i] / wholes[i] : 0; }
  };

  static std::vector<char> adapted_vertices(const Surface_sample& sample, const Facet_edges& edges)
  {
    Shares uneven = uneven_shares(sample), rough = rough_shares(sample, edges);
    for (int round = 0; round < rounds_of_means; ++round)
      for (std::vector<double>* values : {&uneven.parts, &uneven.wholes, &rough.parts, &rough.wholes})
        take_means(*values, edges);
    std::vector<char> result(sample.size(), 0);
    for (std::size_t i = 0; i < sample.size(); ++i)
      result[i] = uneven(i) > least_uneven_share && rough(i) > least_rough_share;
    return result;
  }

  static Shares uneven_shares(const Surface_sample& sample)
  {
    const Altitudes altitudes(sample);
    Shares result(sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i)
      if (altitudes.size(i) < (std::numeric_limits<double>::infinity)())
      {
        result.wholes[i] = 1;
        result.parts[i] = altitudes.longest_edge(i) > even_length * altitudes.size(i) ? 1 : 0;
      }
    return result;
  }

  static Shares rough_shares(const Surface_sample& sample, const Facet_edges& edges)
  {
    Shares result(sample.size());
    for (const auto& [i, j] : edges.edges())
    {
      if (!sample.has_side(i) || !sample.has_side(j))
        continue;
      const Vector way = sample.points[j] - sample.points[i];
      const double a = way.dot(sample.normals[i]), b = way.dot(sample.normals[j]), sum = std::abs(a) + std::abs(b);
      if (!(sum > negligible_slope * way.norm()))
        continue;
      const double part = std::abs(a + b) > largest_difference * sum ? 1 : 0;
      for (const std::size_t v : {i, j})
      {
        result.parts[v] += part;
        ++result.wholes[v];
      }
    }
    return result;
  }

  // of a vertex and its neighbours
  static void take_means(std::vector<double>& values, const Facet_edges& edges)
  {
    std::vector<double> sums = values, numbers(values.size(), 1);
    for (const auto& [i, j] : edges.edges())
    {
      sums[i] += values[j];
      sums[j] += values[i];
      ++numbers[i];
      ++numbers[j];
    }
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = sums[i] / numbers[i];
  }

  std::vector<char> m_is_adapted;  // by facet
  std::vector<char> m_is_replaced; // by vertex
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ADAPTED_FACETS_H
