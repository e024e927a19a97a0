// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_EXCHANGER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_EXCHANGER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Quadric.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/Curve_network.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_contraction.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_subdivision.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Exchanges vertices: a contraction where the least is lost for a split where the most is gained, as long as that pays. So
// vertices move to where they are needed, and their number stays.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Edge_exchanger
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;
  typedef typename Mesh::Vertex Vertex;

  static constexpr std::size_t largest_degree = 14; // of both ends together
  static constexpr double smallest_cosine = 0.3;
  static constexpr double gain_of_split = 0.6;       // of the cost of both faces
  static constexpr double smallest_profit = 1.3;     // of a split, over what the contraction costs
  static constexpr double longest_neighbor = 1.3;    // over the length of an edge that is split
  static constexpr double share_measured = 3;        // contractions that are measured, over those wanted
  static constexpr std::size_t enough_samples = 100; // to measure a contraction

  struct Contraction
  {
    double cost;
    Edge_index edge;
    Halfedge_index halfedge;
    Vector point;
  };
  struct Split
  {
    double gain;
    Edge_index edge;
  };

public:
  Edge_exchanger(Mesh& mesh, const Curve_network& curves, const Guard& guard, const Input_surface& input, Owners& owners,
                 const Shape_price& price, Interruption& interruption)
    : m_mesh(mesh),
      m_contraction(mesh, curves, guard),
      m_subdivision(mesh, guard),
      m_guard(guard),
      m_input(input),
      m_owners(owners),
      m_price(price),
      m_interruption(interruption)
  {
  }

  // exchanges at most `largest_number` vertices; returns how many
  std::size_t operator()(const std::size_t largest_number)
  {
    const std::vector<Contraction> contractions = cheap_contractions(largest_number);
    if (m_interruption.is_requested())
      return 0; // not all have been measured
    const std::vector<Split> splits = rich_splits();
    std::vector<char> is_touched(vertex_capacity(m_mesh), 0);
    std::vector<std::pair<Contraction, Edge_index>> pairs;
    std::size_t next = 0;
    for (const Contraction& c : contractions)
    {
      if (pairs.size() == largest_number)
        break;
      if (is_any_touched(c.halfedge, is_touched))
        continue;
      std::vector<Vertex_index> ring = ring_of(c.halfedge);
      for (const Vertex_index v : ring)
        is_touched[v] = 1;
      while (next < splits.size() && is_quad_touched(splits[next].edge, is_touched))
        ++next;
      if (next == splits.size() || splits[next].gain < smallest_profit * c.cost)
        break;
      touch_quad(splits[next].edge, is_touched);
      pairs.emplace_back(c, splits[next].edge);
      ++next;
    }
    std::size_t number = 0;
    for (const auto& pair : pairs)
    {
      if (m_interruption.poll())
        break;
      const Halfedge_index h = pair.first.halfedge, g = m_mesh.halfedge(pair.second);
      const Vertex kept = kept_state(pair.first), middle = middle_of(g);
      if (CGAL::Euler::does_satisfy_link_condition(pair.first.edge, m_mesh.graph()) &&
          m_guard.accepts(m_contraction.change(h, kept)) && m_guard.accepts(m_subdivision.change(g, middle, {})))
      {
        contract(h, kept);
        split(g, middle);
        ++number;
      }
    }
    return number;
  }

private:
  bool is_bound(const Vertex_index v) const { return m_mesh.point(v).is_on_curve || m_mesh.point(v).is_fixed; }

  std::vector<Vertex_index> ring_of(const Halfedge_index h) const
  {
    std::vector<Vertex_index> result{m_mesh.source(h), m_mesh.target(h)};
    for (const Halfedge_index end : {h, m_mesh.opposite(h)})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
        result.push_back(m_mesh.source(in));
    return result;
  }

  bool is_any_touched(const Halfedge_index h, const std::vector<char>& is_touched) const
  {
    for (const Vertex_index v : ring_of(h))
      if (is_touched[v])
        return true;
    return false;
  }

  std::array<Vertex_index, 4> quad(const Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h)), m_mesh.target(m_mesh.next(g))};
  }

  bool is_quad_touched(const Edge_index e, const std::vector<char>& is_touched) const
  {
    for (const Vertex_index v : quad(e))
      if (is_touched[v])
        return true;
    return false;
  }

  void touch_quad(const Edge_index e, std::vector<char>& is_touched) const
  {
    for (const Vertex_index v : quad(e))
      is_touched[v] = 1;
  }

  // The quadrics of the samples tell which contractions are worth measuring.
  std::vector<Contraction> cheap_contractions(const std::size_t largest_number) const
  {
    std::vector<Quadric> quadrics(vertex_capacity(m_mesh));
    parallel_for<ConcurrencyTag>(quadrics.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Vertex_index v{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(v))
                                     quadrics[i] = quadric(v);
                                 });
    std::vector<std::pair<double, Edge_index>> keys(edge_capacity(m_mesh), {infinity(), Edge_index()});
    parallel_for<ConcurrencyTag>(keys.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Edge_index e{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(e) && is_candidate(e))
                                   {
                                     Quadric sum = quadrics[m_mesh.vertex(e, 0)];
                                     sum += quadrics[m_mesh.vertex(e, 1)];
                                     keys[i] = {sum(sum.minimum()), e};
                                   }
                                 });
    keys.erase(std::remove_if(keys.begin(), keys.end(), [](const auto& k) { return !(k.first < infinity()); }), keys.end());
    const std::size_t n = (std::min)(keys.size(), std::size_t(share_measured * double(largest_number)));
    std::nth_element(keys.begin(), keys.begin() + std::ptrdiff_t(n), keys.end());
    keys.resize(n);
    std::vector<Contraction> result(n);
    parallel_for<ConcurrencyTag>(
        n,
        [&](const std::size_t i)
        {
          Quadric sum = quadrics[m_mesh.vertex(keys[i].second, 0)];
          sum += quadrics[m_mesh.vertex(keys[i].second, 1)];
          result[i] = measure(keys[i].second, sum.minimum());
        },
        16, m_interruption);
    result.erase(std::remove_if(result.begin(), result.end(), [](const auto& c) { return !(c.cost < infinity()); }),
                 result.end());
    std::sort(result.begin(), result.end(),
              [](const Contraction& c, const Contraction& d)
              { return c.cost < d.cost || (c.cost == d.cost && c.edge < d.edge); });
    return result;
  }

  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  bool is_candidate(const Edge_index e) const
  {
    const Vertex_index a = m_mesh.vertex(e, 0), b = m_mesh.vertex(e, 1);
    return !(is_bound(a) && is_bound(b)) && m_mesh.degree(a) + m_mesh.degree(b) <= largest_degree &&
           CGAL::Euler::does_satisfy_link_condition(e, m_mesh.graph());
  }

  Quadric quadric(const Vertex_index v) const
  {
    Quadric result;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(h))
        m_owners.for_each(m_mesh.face(h),
                          [&](const std::uint32_t i)
                          {
                            const Reference_sample& s = m_owners.sample(i);
                            const double weight = s.area / 3.;
                            result += Quadric::of_plane(s.point, s.normal.template cast<double>(), weight);
                            result += Quadric::of_point(s.point, 1e-4 * weight);
                          });
    result += Quadric::of_point(m_mesh.point(v).point, 1e-14);
    return result;
  }

  // the contraction of an edge to the best of its ends, its middle and the optimum of the quadric
  Contraction measure(const Edge_index e, const Vector& optimum) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    const Vertex_index a = m_mesh.source(h), b = m_mesh.target(h);
    Contraction best{infinity(), e, h, Vector::Zero()};
    std::vector<std::array<Vector, 3>> corners; // of the faces that stay; the moving one comes first
    std::vector<Face_index> faces;
    double before = 0;
    for (const Halfedge_index end : {h, m_mesh.opposite(h)})
    {
      const Vertex_index other = m_mesh.source(end);
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
      {
        if (m_mesh.is_border(in))
          continue;
        const Triangle t(in, m_mesh);
        const bool has_both = t.a == other || t.c == other;
        if (has_both && end != h)
          continue;
        faces.push_back(m_mesh.face(in));
        before += m_owners.cost(m_mesh.face(in)) + m_price(m_owners.triangle(m_mesh.face(in)));
        if (!has_both)
          corners.push_back({m_mesh.point(t.b).point, m_mesh.point(t.c).point, m_mesh.point(t.a).point});
      }
    }
    const std::size_t stride = stride_of(faces);
    const auto look_at = [&](const Halfedge_index to, const Vector& point)
    {
      const double cost = cost_at(point, corners, faces, stride, before + best.cost) - before;
      if (cost < best.cost)
        best = Contraction{cost, e, to, point};
    };
    if (!is_bound(a))
      look_at(h, m_mesh.point(b).point);
    if (!is_bound(b))
      look_at(m_mesh.opposite(h), m_mesh.point(a).point);
    if (!is_bound(a) && !is_bound(b))
    {
      look_at(h, (m_mesh.point(a).point + m_mesh.point(b).point) / 2);
      if ((optimum - m_mesh.point(a).point).squaredNorm() < 4 * (m_mesh.point(a).point - m_mesh.point(b).point).squaredNorm())
        look_at(h, optimum);
    }
    return best;
  }

  // Each so many samples are enough to measure by.
  std::size_t stride_of(const std::vector<Face_index>& faces) const
  {
    std::size_t number = 0;
    for (const Face_index f : faces)
      m_owners.for_each(f, [&](std::uint32_t) { ++number; });
    return (std::max)(number / enough_samples, std::size_t(1));
  }

  // the costs of the faces if their first corner is at a point; infinite if that must not be, or if it is more than `limit`
  double cost_at(const Vector& point, const std::vector<std::array<Vector, 3>>& corners, const std::vector<Face_index>& faces,
                 const std::size_t stride, const double limit) const
  {
    double cost = 0;
    std::array<std::uint32_t, Owners::number_of_nodes> nearest;
    for (const auto& c : corners)
    {
      const Space_triangle before{c[0], c[1], c[2]}, after{point, c[1], c[2]};
      const Vector m = before.normal(), n = after.normal();
      if (!(n.norm() > 0) || n.dot(m) < smallest_cosine * n.norm() * m.norm())
        return infinity();
      const double ratio = after.ratio();
      if (ratio > m_price.largest_ratio() && ratio > before.ratio())
        return infinity();
      cost += m_price(after) + m_owners.cost_of_way_back(
                                   after,
                                   [&](const auto& visit)
                                   {
                                     std::size_t number = 0;
                                     for (const Face_index f : faces)
                                       m_owners.for_each(f,
                                                         [&](const std::uint32_t i)
                                                         {
                                                           if (number++ % stride == 0)
                                                             visit(i);
                                                         });
                                   },
                                   nearest);
      if (!(cost < limit))
        return infinity();
    }
    std::size_t number = 0;
    const auto add_sample = [&](const std::uint32_t i)
    {
      if (number++ % stride != 0 || !(cost < limit))
        return;
      const Reference_sample& s = m_owners.sample(i);
      double least = infinity();
      for (const auto& c : corners)
        least = (std::min)(least, closest_on_triangle(s.point, point, c[1], c[2]).squared_distance);
      cost += double(stride) * s.area * m_owners.cost(least);
    };
    for (const Face_index f : faces)
      m_owners.for_each(f, add_sample);
    if (!(cost < limit))
      return infinity();
    return cost;
  }

  // edges that are about the longest of their faces, by what a split gains
  std::vector<Split> rich_splits() const
  {
    std::vector<Split> result;
    for (const Edge_index e : m_mesh.edges())
    {
      if (m_mesh.is_border(e) || m_mesh.is_on_curve(e))
        continue;
      const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
      const double length = squared_length(h);
      const double longest = (std::max)({squared_length(m_mesh.next(h)), squared_length(m_mesh.prev(h)),
                                         squared_length(m_mesh.next(g)), squared_length(m_mesh.prev(g))});
      if (longest > longest_neighbor * longest_neighbor * length)
        continue;
      result.push_back(Split{gain_of_split * (m_owners.cost(m_mesh.face(h)) + m_owners.cost(m_mesh.face(g))), e});
    }
    std::sort(result.begin(), result.end(),
              [](const Split& s, const Split& t) { return s.gain > t.gain || (s.gain == t.gain && s.edge < t.edge); });
    return result;
  }

  double squared_length(const Halfedge_index h) const
  {
    return (m_mesh.point(m_mesh.source(h)).point - m_mesh.point(m_mesh.target(h)).point).squaredNorm();
  }

  // of the target of a contraction
  Vertex kept_state(const Contraction& c) const
  {
    const Vertex_index a = m_mesh.source(c.halfedge), b = m_mesh.target(c.halfedge);
    Vertex state = m_mesh.point(b);
    if (is_bound(b))
      return state;
    state.point = c.point;
    const Vector normal = m_mesh.state(a, c.halfedge).normal + state.normal;
    if (normal.norm() > 0)
      state.normal = normal.normalized();
    return state;
  }

  void contract(const Halfedge_index h, const Vertex& kept)
  {
    std::vector<std::uint32_t> samples;
    for (const Halfedge_index end : {h, m_mesh.opposite(h)})
      for (const Halfedge_index in : m_mesh.halfedges_around_target(end))
        if (!m_mesh.is_border(in))
          m_owners.take(m_mesh.face(in), samples);
    const Vertex_index v = m_contraction.contract(h, kept);
    std::vector<Face_index> faces;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(in))
        faces.push_back(m_mesh.face(in));
    m_owners.give(samples, faces);
  }

  // puts the middle of an edge on the input
  Vertex middle_of(const Halfedge_index h) const
  {
    Vertex state;
    const Vector middle = (m_mesh.point(m_mesh.source(h)).point + m_mesh.point(m_mesh.target(h)).point) / 2;
    state.point = m_input.empty() ? middle : m_input.closest(middle).point;
    const Vector normal = m_mesh.state(m_mesh.source(h), h).normal + m_mesh.state(m_mesh.target(h), h).normal;
    if (normal.norm() > 0)
      state.normal = normal.normalized();
    return state;
  }

  void split(const Halfedge_index h, const Vertex& middle)
  {
    std::vector<std::uint32_t> samples;
    m_owners.take(m_mesh.face(h), samples);
    m_owners.take(m_mesh.face(m_mesh.opposite(h)), samples);
    const Vertex_index v = m_subdivision.split(h, middle, {});
    m_owners.resize();
    std::vector<Face_index> faces;
    for (const Halfedge_index in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      faces.push_back(m_mesh.face(in));
    m_owners.give(samples, faces);
  }

  Mesh& m_mesh;
  const Edge_contraction<Mesh, Guard> m_contraction;
  const Edge_subdivision<Mesh, Guard> m_subdivision;
  const Guard& m_guard;
  const Input_surface& m_input;
  Owners& m_owners;
  const Shape_price& m_price;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_EXCHANGER_H
