// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINTS_ON_FACETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINTS_ON_FACETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Adapted_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_sizes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Graded_point_grid.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Points on facets that are large for what is around them, as of CAD programs. An interpolant of the vertices
// alone swells there. Facets are divided in thought by their longest edges, as long as these are too long for the size there. The
// middles of these edges are candidates, the longest for its size first. One is taken if no point is near. Where the normals at
// the vertices belong to one bend, a point is on this bend. On a mesh whose
// triangles are all about alike there is none: its vertices say more than its flat facets.
class Points_on_facets
{
  // A longer edge is divided. The triangles of a remeshed surface have edges up to about twice the altitudes around.
  static constexpr double longest_edge = 2.5;
  // least distance between points: that to the ends of the shortest edge that is divided
  static constexpr double least_gap = 1.2;
  // bounds the time for a facet of any shape
  static constexpr int most_bisections = 16;
  // bounds their number: this many for each vertex
  static constexpr std::size_t most_for_a_vertex = 4;

public:
  struct Point
  {
    double relative_length; // of the edge of which it is the middle, in sizes
    double size;
    std::size_t facet;
    Vector point, normal;
    bool is_on_edge; // of the surface
  };

  // keeps references
  Points_on_facets(const Surface_sample& sample, const Facet_edges& edges, const Adapted_facets& adapted,
                   Interruption& interruption)
    : m_sample(sample), m_edges(edges), m_sizes(sample, m_edges)
  {
    for (std::size_t f = 0; f < sample.facets.size(); ++f)
    {
      interruption.check();
      const Facet& facet = sample.facets[f];
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = Corner{sample.points[facet[k]], Vector::Unit(Eigen::Index(k))};
      if (!m_edges.facet_normal(f).isZero(0) && !adapted.is_adapted(f))
        divide(f, corners, most_bisections);
    }
    std::stable_sort(m_points.begin(), m_points.end(),
                     [](const Point& p, const Point& q) { return p.relative_length > q.relative_length; });
    if (!m_points.empty())
      thin_out(interruption);
  }

  const std::vector<Point>& points() const { return m_points; }

private:
  struct Corner
  {
    Vector point, barycentric;
  };

  void divide(const std::size_t f, const std::array<Corner, 3>& corners, const int bisections)
  {
    // Lengths that rounding makes different are equal: the facets of both sides divide an edge at the same points.
    static constexpr double longer = 1 + 1e-9;
    std::size_t longest = 0;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double length_of_k = (corners[(k + 1) % 3].point - corners[k].point).norm();
      if (!(length_of_k > longer * length))
        continue;
      longest = k;
      length = length_of_k;
    }
    const Corner &a = corners[longest], &b = corners[(longest + 1) % 3], &c = corners[(longest + 2) % 3];
    const Corner middle{0.5 * (a.point + b.point), 0.5 * (a.barycentric + b.barycentric)};
    const double size = m_sizes(f, middle.point, middle.barycentric), relative_length = rounded(length / size);
    if (!(relative_length > longest_edge) || bisections == 0)
      return;
    m_points.push_back(point(f, middle, relative_length, size));
    divide(f, {a, middle, c}, bisections - 1);
    divide(f, {middle, b, c}, bisections - 1);
  }

  // The last bits depend on the unit and the place of the input. Without these bits the points of a symmetric shape are taken in the
  // same order everywhere.
  static double rounded(const double relative_length)
  {
    return std::ldexp(std::nearbyint(std::ldexp(relative_length, 20)), -20);
  }

  // How far the surface rises above a facet, by cubic curves over its edges that have the normals at the vertices. It is zero if
  // these normals are no two samples of one bend: if they turn much, or not alike at both ends of an edge. So they are on meshes
  // that are adapted to a shape, of which the vertices are off the surface.
  Vector rise(const std::size_t f, const Vector& barycentric) const
  {
    static constexpr double largest_turn = 0.5; // in radians, from the normal of the facet
    static constexpr double largest_difference = 0.25, negligible_slope = 0.05;
    const Facet& facet = m_sample.facets[f];
    Vector result = Vector::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = facet[k], j = facet[(k + 1) % 3];
      const Vector &m = m_sample.normals[i], &n = m_sample.normals[j], way = m_sample.points[j] - m_sample.points[i];
      const double a = way.dot(m), b = way.dot(n), sum = std::abs(a) + std::abs(b);
      if (m.isZero(0) || angle_between(m, m_edges.facet_normal(f)) > largest_turn ||
          (std::abs(a + b) > largest_difference * sum && sum > negligible_slope * way.norm()))
        return Vector::Zero();
      const double u = barycentric[Eigen::Index(k)], v = barycentric[Eigen::Index((k + 1) % 3)];
      if (u > 0 && v > 0)
        result += u * v / (u + v) * (v * b * n - u * a * m);
    }
    return result;
  }

  // Its normal is that of the facet; on an edge, the mean of those of both sides.
  Point point(const std::size_t f, const Corner& c, const double relative_length, const double size) const
  {
    Point result{relative_length, size, f, c.point + rise(f, c.barycentric), m_edges.facet_normal(f), false};
    for (std::size_t k = 0; k < 3; ++k)
      if (c.barycentric[Eigen::Index(k)] == 0)
      {
        const std::size_t edge = m_edges.edge(f, (k + 1) % 3);
        result.normal = m_edges.edge_normal(edge);
        result.is_on_edge = m_edges.is_sharp(edge);
      }
    return result;
  }

  // Takes the points one by one, unless one is near on the same side: the other side of a thin plate is another surface.
  void thin_out(Interruption& interruption)
  {
    Graded_point_grid grid;
    std::vector<const Vector*> normals;
    for (std::size_t i = 0; i < m_sample.size(); ++i)
      if (std::isfinite(m_sizes(i)))
      {
        grid.insert(m_sample.points[i], m_sizes(i));
        normals.push_back(&m_sample.normals[i]);
      }
    std::vector<Point> taken;
    taken.reserve(m_points.size());
    for (const Point& p : m_points)
    {
      interruption.check();
      if (taken.size() == most_for_a_vertex * m_sample.size())
        break;
      if (grid.has_near(p.point, least_gap * p.size, p.size,
                        [&](const std::size_t i) { return normals[i]->dot(p.normal) >= 0; }))
        continue;
      grid.insert(p.point, p.size);
      taken.push_back(p);
      normals.push_back(&taken.back().normal); // it stays there: the memory is reserved
    }
    m_points.swap(taken);
  }

  const Surface_sample& m_sample;
  const Facet_edges& m_edges;
  const Facet_sizes m_sizes;
  std::vector<Point> m_points;
};

// The spacings of the last points of the sample, and of those whose facets they are on: the mean distance to the nearest points, as
// many as a vertex has neighbours.
template <typename ConcurrencyTag>
void update_spacings(Surface_sample& sample, std::vector<std::size_t> changed, Interruption& interruption)
{
  static constexpr unsigned int number_of_neighbors = 6;
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  const Point_search search(sample.points);
  parallel_for<ConcurrencyTag>(
      changed.size(),
      [&](const std::size_t k)
      {
        const std::size_t i = changed[k];
        double sum = 0, count = 0;
        for (const auto& neighbor : search.nearest(sample.points[i], number_of_neighbors + 1))
          if (neighbor.second != i)
          {
            sum += std::sqrt(neighbor.first);
            ++count;
          }
        if (count > 0)
          sample.spacings[i] = sample.spacings[i] > 0 ? (std::min)(sample.spacings[i], sum / count) : sum / count;
      },
      256, interruption);
  interruption.check();
}

// marks the vertices on sharp edges
inline void mark_edges(Surface_sample& sample, const Facet_edges& edges)
{
  for (std::size_t e = 0; e < edges.edges().size(); ++e)
    if (edges.is_sharp(e))
    {
      sample.is_on_edge.resize(sample.size(), 0);
      sample.is_on_edge[edges.edges()[e].first] = sample.is_on_edge[edges.edges()[e].second] = 1;
    }
}

// Adapted facets are on the surface in the mean. So the surface passes near four points of each: three at which a quadratic
// polynomial has its mean over the facet, and the centre. The normal is that of the facet, and one point with it is enough.
inline void add_points_on_adapted_facets(Surface_sample& sample, const Facet_edges& edges, const Adapted_facets& adapted,
                                         std::vector<std::size_t>& changed)
{
  const std::size_t number_of_vertices = sample.size() - sample.number_of_points_on_facets;
  const auto add = [&](const Vector& point, const Vector& normal)
  {
    changed.push_back(sample.size());
    sample.add_point_on_facet(point, normal, false, Datum::APPROXIMATE);
  };
  for (std::size_t f = 0; f < sample.facets.size(); ++f)
    if (adapted.is_adapted(f))
    {
      const Facet& facet = sample.facets[f];
      const Vector centre = (sample.points[facet[0]] + sample.points[facet[1]] + sample.points[facet[2]]) / 3;
      add(centre, edges.facet_normal(f));
      for (const std::size_t i : facet)
        add(0.5 * (centre + sample.points[i]), Vector::Zero());
      changed.insert(changed.end(), facet.begin(), facet.end());
    }
  for (std::size_t i = 0; i < number_of_vertices; ++i)
    if (adapted.is_replaced(i))
      sample.data[i] = Datum::NONE;
}

// Adds them to the sample, behind its vertices. If these are kept, no facet counts as adapted.
template <typename ConcurrencyTag>
void add_points_on_facets(Surface_sample& sample, const Facet_edges& edges, const bool keeps_vertices,
                          Interruption& interruption)
{
  const Adapted_facets adapted = keeps_vertices ? Adapted_facets(sample) : Adapted_facets(sample, edges);
  const Points_on_facets points_on_facets(sample, edges, adapted, interruption);
  std::vector<std::size_t> changed;
  for (const Points_on_facets::Point& p : points_on_facets.points())
  {
    changed.insert(changed.end(), sample.facets[p.facet].begin(), sample.facets[p.facet].end());
    changed.push_back(sample.size());
    sample.add_point_on_facet(p.point, p.normal, p.is_on_edge);
  }
  add_points_on_adapted_facets(sample, edges, adapted, changed);
  if (!changed.empty())
    update_spacings<ConcurrencyTag>(sample, changed, interruption);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINTS_ON_FACETS_H
