// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_LOSS_COARSENER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_LOSS_COARSENER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Quadric.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_contraction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Contracts edges in the order of what is lost by it, until the mesh has a number of faces or too much would be lost. Quadrics add
// up what has been lost before. A vertex inside the surface goes where the loss is least. A small part of the quadrics is the
// squared distance to the vertices that it stands for: it spreads the vertices where the surface is flat, and keeps the matrices
// regular. Where facets are long and exact, what loses nothing comes first: a vertex along a facet goes to another one there. On the
// way, the faces may be needles and caps.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Loss_coarsener
{
  typedef typename Mesh::Vertex Vertex;

  static constexpr double weight_of_points = 1e-6;
  static constexpr double weight_of_curves = 1;         // of the planes that stand on curves
  static constexpr double largest_ratio = 100;          // of the longest edge to the altitude
  static constexpr double growth_without_loss = 16;     // of this ratio, along long facets
  static constexpr double growth_with_loss = 2;         // of the median ratio of long facets, if that is more than this ratio
  static constexpr double least_median_ratio = 8;       // of the faces, for facets that are long as a rule
  static constexpr double ratio_of_rounding = 1 + 1e-6; // a needle is no worse than another one if it is as long
  static constexpr double smallest_cosine = 0.2;        // of the turn of a face
  static constexpr double distance_without_loss = 1e-7; // of the size of the mesh: the rounding of files in single precision
  static constexpr double order_of_what_loses_nothing = 1e-12; // costs of what loses nothing are less than all others by this
  static constexpr std::size_t largest_degree = 64;

  struct Candidate
  {
    double cost;
    std::uint32_t edge, version;
    bool operator<(const Candidate& other) const // the least comes first in std::priority_queue
    {
      return cost > other.cost || (cost == other.cost && edge > other.edge);
    }
  };

public:
  Loss_coarsener(Mesh& mesh, const Curve_network& curves, Guard& guard, const bool has_long_facets, Interruption& interruption)
    : m_mesh(mesh),
      m_contraction(mesh, curves, guard),
      m_guard(guard),
      m_has_long_facets(has_long_facets),
      m_interruption(interruption)
  {
  }

  // Nowhere may the mean of the squared distances become larger. Returns, for each vertex before, the vertex that stands for it
  // after.
  std::vector<Vertex_index> operator()(const std::size_t number_of_faces,
                                       const double largest_mean_square = (std::numeric_limits<double>::infinity)())
  {
    init();
    std::size_t n = m_mesh.number_of_faces();
    while (n > number_of_faces && !m_heap.empty() && !m_interruption.poll())
    {
      const Candidate c = m_heap.top();
      m_heap.pop();
      const Edge_index e(c.edge);
      if (c.version != m_versions[e] || m_mesh.is_removed(e))
        continue;
      if (c.cost > largest_mean_square * (m_areas[m_mesh.vertex(e, 0)] + m_areas[m_mesh.vertex(e, 1)]))
        continue;
      Halfedge_index h;
      Vector point;
      if (!place(e, h, point) || !CGAL::Euler::does_satisfy_link_condition(e, m_mesh.graph()) || !is_accepted(h, point))
        continue; // it comes again if something changes there
      const Vertex kept = kept_state(h, point);
      m_guard.allow_caps(loses_nothing(e, point));
      if (!m_guard.accepts(m_contraction.change(h, kept)))
        continue;
      n -= m_mesh.is_border(e) ? 1 : 2;
      ++m_number_of_collapses;
      contract(h, kept);
    }
    m_guard.allow_caps(false);
    std::vector<Vertex_index> result(m_parents.size());
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = root(Vertex_index(std::uint32_t(v)));
    return result;
  }

  std::size_t number_of_collapses() const { return m_number_of_collapses; }

private:
  void init()
  {
    m_quadrics.assign(vertex_capacity(m_mesh), Quadric());
    m_origin = first_point(m_mesh);
    if (m_has_long_facets)
      init_exact_part();
    m_normals.assign(vertex_capacity(m_mesh), Vector::Zero());
    m_areas.assign(vertex_capacity(m_mesh), 0.);
    m_versions.assign(edge_capacity(m_mesh), 0);
    m_parents.resize(vertex_capacity(m_mesh));
    for (std::size_t v = 0; v < m_parents.size(); ++v)
      m_parents[v] = Vertex_index(std::uint32_t(v));
    parallel_for<ConcurrencyTag>(m_quadrics.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Vertex_index v{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(v))
                                     init(v);
                                 });
    std::vector<double> costs(edge_capacity(m_mesh), 0.);
    parallel_for<ConcurrencyTag>(costs.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Edge_index e{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(e))
                                     costs[i] = cost(e);
                                 });
    std::vector<Candidate> candidates;
    for (const Edge_index e : m_mesh.edges())
      if (std::isfinite(costs[e]))
        candidates.push_back(Candidate{costs[e], std::uint32_t(e), 0});
    m_heap = std::priority_queue<Candidate>(std::less<Candidate>(), std::move(candidates));
  }

  void init(const Vertex_index v)
  {
    const Vector& p = m_mesh.point(v).point;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      if (!m_mesh.is_border(h))
      {
        const Vector n =
            (m_mesh.point(m_mesh.target(m_mesh.next(h))).point - p).cross(m_mesh.point(m_mesh.source(h)).point - p) / 2;
        const double third = n.norm() / 3;
        if (third > 0)
        {
          const Quadric of_plane = Quadric::of_plane(p - m_origin, n / (3 * third), third);
          m_quadrics[v] += of_plane;
          if (m_has_long_facets)
            m_exact_quadrics[v] += of_plane;
          m_quadrics[v] += Quadric::of_point(p - m_origin, weight_of_points * third);
        }
        m_normals[v] += n / 3;
        m_areas[v] += third;
      }
      if (m_mesh.is_on_curve(m_mesh.edge(h)))
        add_curve(h, v);
    }
    m_quadrics[v] += Quadric::of_point(p - m_origin, 1e-14);
  }

  // the planes through an edge of a curve that are perpendicular to its faces
  void add_curve(const Halfedge_index h, const Vertex_index v)
  {
    const Vector& p = m_mesh.point(v).point;
    const Vector edge = m_mesh.point(m_mesh.source(h)).point - p;
    for (const Halfedge_index side : {h, m_mesh.opposite(h)})
    {
      if (m_mesh.is_border(side))
        continue;
      const Vector across = face_normal(side, m_mesh).cross(edge);
      if (!(across.norm() > 0))
        continue;
      const Quadric of_plane = Quadric::of_plane(p - m_origin, across.normalized(), weight_of_curves * edge.squaredNorm() / 2);
      m_quadrics[v] += of_plane;
      if (m_has_long_facets)
        m_exact_quadrics[v] += of_plane;
    }
  }

  void init_exact_part()
  {
    m_exact_quadrics.assign(vertex_capacity(m_mesh), Quadric());
    Vector least = m_origin, most = m_origin;
    for (const Vertex_index v : m_mesh.vertices())
    {
      least = least.cwiseMin(m_mesh.point(v).point);
      most = most.cwiseMax(m_mesh.point(v).point);
    }
    const double distance = distance_without_loss * (most - least).norm();
    m_square_without_loss = distance * distance;
    const double ratio = median_ratio();
    m_has_long_facets = ratio > least_median_ratio;
    m_largest_ratio_without_loss = (std::max)(largest_ratio, growth_without_loss * ratio);
    if (m_has_long_facets)
      m_largest_ratio = (std::max)(largest_ratio, growth_with_loss * ratio);
  }

  // half of the area is in faces that are as long as this, or longer
  double median_ratio() const
  {
    std::vector<std::pair<double, double>> ratios_and_areas;
    double area = 0;
    for (const Face_index f : m_mesh.faces())
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      const Space_triangle triangle{m_mesh.point(t.a).point, m_mesh.point(t.b).point, m_mesh.point(t.c).point};
      ratios_and_areas.emplace_back(triangle.ratio(), triangle.normal().norm());
      area += ratios_and_areas.back().second;
    }
    std::sort(ratios_and_areas.begin(), ratios_and_areas.end());
    double below = 0;
    for (const auto& [ratio, of_face] : ratios_and_areas)
    {
      below += of_face;
      if (below >= area / 2)
        return ratio;
    }
    return 0;
  }

  // whether the facets are long and exact, and the contraction of an edge to a point keeps them
  bool loses_nothing(const Edge_index e, const Vector& point) const
  {
    if (!m_has_long_facets)
      return false;
    const Vertex_index a = m_mesh.vertex(e, 0), b = m_mesh.vertex(e, 1);
    Quadric sum = m_exact_quadrics[a];
    sum += m_exact_quadrics[b];
    return sum(point - m_origin) <= m_square_without_loss * (m_areas[a] + m_areas[b]);
  }

  // The loss by contracting an edge; infinite if curves do not allow it.
  double cost(const Edge_index e) const
  {
    Halfedge_index h;
    Vector point;
    if (!place(e, h, point))
      return (std::numeric_limits<double>::infinity)();
    Quadric sum = m_quadrics[m_mesh.source(h)];
    sum += m_quadrics[m_mesh.target(h)];
    return (loses_nothing(e, point) ? order_of_what_loses_nothing : 1) * sum(point - m_origin);
  }

  // the halfedge to contract, and where its target goes
  bool place(const Edge_index e, Halfedge_index& h, Vector& point) const
  {
    h = m_mesh.halfedge(e);
    const Halfedge_index g = m_mesh.opposite(h);
    Quadric sum = m_quadrics[m_mesh.source(h)];
    sum += m_quadrics[m_mesh.target(h)];
    const Vertex &a = m_mesh.point(m_mesh.source(h)), &b = m_mesh.point(m_mesh.target(h));
    if (!is_bound(a) && !is_bound(b))
    {
      const double at_a = sum(a.point - m_origin), at_b = sum(b.point - m_origin);
      point = at_a < at_b ? a.point : b.point;
      if (loses_nothing(e, point))
        return true;
      point = m_origin + sum.minimum();
      const double squared_length = (a.point - b.point).squaredNorm();
      if (!((point - a.point).squaredNorm() < 4 * squared_length))
        point = (a.point + b.point) / 2;
      return true;
    }
    const bool to_b = (is_bound(b) || !is_bound(a)) && m_contraction.is_removable(h),
               to_a = (is_bound(a) || !is_bound(b)) && m_contraction.is_removable(g);
    if (!to_a && !to_b)
      return false;
    if (!to_b || (to_a && sum(a.point - m_origin) < sum(b.point - m_origin)))
      h = g;
    point = m_mesh.point(m_mesh.target(h)).point;
    return true;
  }

  static bool is_bound(const Vertex& v) { return v.is_on_curve || v.is_fixed; }

  // no face may turn over or become a needle
  bool is_accepted(const Halfedge_index h, const Vector& point) const
  {
    if (m_mesh.degree(m_mesh.source(h)) + m_mesh.degree(m_mesh.target(h)) > largest_degree)
      return false;
    const double largest = loses_nothing(m_mesh.edge(h), point) ? m_largest_ratio_without_loss : m_largest_ratio;
    for (const Halfedge_index end : {h, m_mesh.opposite(h)})
    {
      const Vertex_index other = m_mesh.source(end);
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
      {
        if (m_mesh.is_border(in))
          continue;
        const Triangle t(in, m_mesh);
        if (t.a == other || t.c == other)
          continue;
        const Space_triangle before{m_mesh.point(t.a).point, m_mesh.point(t.b).point, m_mesh.point(t.c).point};
        const Space_triangle after{before.a, point, before.c};
        const Vector m = before.normal(), n = after.normal();
        if (!(n.dot(m) >= smallest_cosine * n.norm() * m.norm()) || !(n.norm() > 0))
          return false;
        const double ratio = after.ratio();
        if (ratio > largest && ratio > ratio_of_rounding * before.ratio())
          return false;
      }
    }
    return true;
  }

  Vertex kept_state(const Halfedge_index h, const Vector& point) const
  {
    Vertex state = m_mesh.point(m_mesh.target(h));
    if (is_bound(state))
      return state;
    state.point = point;
    const Vector normal = m_normals[m_mesh.source(h)] + m_normals[m_mesh.target(h)];
    if (normal.norm() > 0)
      state.normal = normal.normalized();
    return state;
  }

  void contract(const Halfedge_index h, const Vertex& kept)
  {
    const Vertex_index a = m_mesh.source(h), b = m_mesh.target(h);
    Quadric sum = m_quadrics[a], exact_sum;
    sum += m_quadrics[b];
    if (m_has_long_facets)
    {
      exact_sum = m_exact_quadrics[a];
      exact_sum += m_exact_quadrics[b];
    }
    const Vector normal = m_normals[a] + m_normals[b];
    const double area = m_areas[a] + m_areas[b];
    const Vertex_index v = m_contraction.contract(h, kept);
    m_parents[v == a ? b : a] = v;
    m_quadrics[v] = sum;
    if (m_has_long_facets)
      m_exact_quadrics[v] = exact_sum;
    m_normals[v] = normal;
    m_areas[v] = area;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      const Edge_index e = m_mesh.edge(in);
      const std::uint32_t version = ++m_versions[e];
      const double c = cost(e);
      if (std::isfinite(c))
        m_heap.push(Candidate{c, std::uint32_t(e), version});
    }
  }

  Vertex_index root(Vertex_index v)
  {
    while (m_parents[v] != v)
    {
      m_parents[v] = m_parents[m_parents[v]];
      v = m_parents[v];
    }
    return v;
  }

  Mesh& m_mesh;
  const Edge_contraction<Mesh, Guard> m_contraction;
  Guard& m_guard;
  bool m_has_long_facets;
  Interruption& m_interruption;
  std::vector<Quadric> m_quadrics, m_exact_quadrics; // the latter without points, if there are long facets
  double m_square_without_loss = 0;                  // of the mean distance
  double m_largest_ratio = largest_ratio, m_largest_ratio_without_loss = largest_ratio;
  Vector m_origin;               // of the quadrics: far from it they would be inexact
  std::vector<Vector> m_normals; // of the area that a vertex stands for
  std::vector<double> m_areas;
  std::vector<std::uint32_t> m_versions; // of edges
  std::vector<Vertex_index> m_parents;
  std::priority_queue<Candidate> m_heap;
  std::size_t m_number_of_collapses = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_LOSS_COARSENER_H
