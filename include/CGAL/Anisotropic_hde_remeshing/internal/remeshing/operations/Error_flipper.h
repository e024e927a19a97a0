// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FLIPPER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FLIPPER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Local_change.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Flips edges where that lowers the measured error, the price of shape included.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Error_flipper
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;

  static constexpr int maximum_number_of_passes = 4;
  static constexpr double smallest_gain = 0.03;            // of the cost of both faces
  static constexpr double smallest_cosine = 0.3;           // between a face and its samples
  static constexpr double smallest_cosine_of_faces = -0.2; // between both faces

public:
  Error_flipper(Mesh& mesh, const Guard& guard, Owners& owners, const Shape_price& price, Interruption& interruption)
    : m_mesh(mesh), m_guard(guard), m_owners(owners), m_price(price), m_interruption(interruption)
  {
  }

  std::size_t operator()()
  {
    std::size_t number = 0;
    std::vector<Edge_index> queue(m_mesh.edges().begin(), m_mesh.edges().end());
    std::vector<char> is_queued(edge_capacity(m_mesh), 0);
    for (int pass = 0; pass < maximum_number_of_passes && !queue.empty() && !m_interruption.is_requested(); ++pass)
    {
      const std::vector<Edge_index> flipped = flip(gaining(queue));
      number += flipped.size();
      queue = surroundings(flipped, is_queued);
    }
    return number;
  }

private:
  std::vector<Edge_index> gaining(const std::vector<Edge_index>& edges) const
  {
    std::vector<char> is_gain(edges.size(), 0);
    parallel_for<ConcurrencyTag>(
        edges.size(), [&](const std::size_t i) { is_gain[i] = gains(edges[i]); }, 64, m_interruption);
    std::vector<Edge_index> result;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (is_gain[i])
        result.push_back(edges[i]);
    return result;
  }

  std::vector<Edge_index> flip(const std::vector<Edge_index>& edges)
  {
    std::vector<Edge_index> flipped;
    std::vector<char> is_touched(vertex_capacity(m_mesh), 0);
    std::vector<std::uint32_t> samples;
    for (const Edge_index e : edges)
    {
      const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
      const std::array<Vertex_index, 4> q{m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h)),
                                          m_mesh.target(m_mesh.next(g))};
      if ((is_touched[q[0]] || is_touched[q[1]] || is_touched[q[2]] || is_touched[q[3]] || !m_guard.is_local()) && !gains(e))
        continue;
      samples.clear();
      m_owners.take(m_mesh.face(h), samples);
      m_owners.take(m_mesh.face(g), samples);
      CGAL::Euler::flip_edge(h, m_mesh.graph());
      m_owners.give(samples, std::array<Face_index, 2>{m_mesh.face(h), m_mesh.face(g)});
      m_guard.update_at(h);
      for (const Vertex_index v : q)
        is_touched[v] = 1;
      flipped.push_back(e);
    }
    return flipped;
  }

  std::vector<Edge_index> surroundings(const std::vector<Edge_index>& edges, std::vector<char>& is_queued) const
  {
    std::vector<Edge_index> result;
    for (const Edge_index e : edges)
    {
      const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
      for (const Halfedge_index side : {h, m_mesh.next(h), m_mesh.prev(h), m_mesh.next(g), m_mesh.prev(g)})
      {
        const Edge_index edge = m_mesh.edge(side);
        if (!is_queued[edge])
          result.push_back(edge);
        is_queued[edge] = 1;
      }
    }
    for (const Edge_index e : result)
      is_queued[e] = 0;
    std::sort(result.begin(), result.end());
    return result;
  }

  bool gains(const Edge_index e) const
  {
    if (m_mesh.is_on_curve(e))
      return false;
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    const Vertex_index va = m_mesh.source(h), vb = m_mesh.target(h), vc = m_mesh.target(m_mesh.next(h)),
                       vd = m_mesh.target(m_mesh.next(g));
    const Vector &a = m_mesh.point(va).point, &b = m_mesh.point(vb).point, &c = m_mesh.point(vc).point,
                 &d = m_mesh.point(vd).point;
    const Face_index f = m_mesh.face(h), k = m_mesh.face(g);
    const Space_triangle old_one{a, b, c}, old_other{b, a, d}, one{c, a, d}, other{d, b, c};
    const double before = m_owners.cost(f) + m_owners.cost(k) + m_price(old_one) + m_price(old_other);
    const double price = m_price(one) + m_price(other);
    if (!(price < before) || !(before > 1e-3 * m_price.mean_cost()))
      return false;
    const Vector m = one.normal(), n = other.normal();
    const double length_m = m.norm(), length_n = n.norm();
    if (!(length_m > 0) || !(length_n > 0) || m.dot(n) < smallest_cosine_of_faces * length_m * length_n)
      return false;
    Vector normal = m_owners.normal(f) + m_owners.normal(k);
    if (!(normal.norm() > 0))
      normal = old_one.normal() + old_other.normal();
    normal.normalize();
    if (m.dot(normal) < smallest_cosine * length_m || n.dot(normal) < smallest_cosine * length_n)
      return false;
    const double ratio = (std::max)(one.ratio(), other.ratio());
    if (ratio > m_price.largest_ratio() && ratio > (std::max)(old_one.ratio(), old_other.ratio()))
      return false;
    if (vc == vd || m_mesh.halfedge(vc, vd).is_valid() || m_mesh.degree(va) <= 3 || m_mesh.degree(vb) <= 3)
      return false;
    const double limit = (1 - smallest_gain) * before;
    double after = price;
    for (const Face_index face : {f, k})
      m_owners.for_each(face,
                        [&](const std::uint32_t i)
                        {
                          if (after >= limit)
                            return;
                          const Reference_sample& s = m_owners.sample(i);
                          after += s.area * m_owners.cost((std::min)(one.closest(s.point).squared_distance,
                                                                     other.closest(s.point).squared_distance));
                        });
    const auto visit_samples = [&](const auto& visit)
    {
      m_owners.for_each_around(f, visit);
      m_owners.for_each_around(k, visit);
    };
    std::array<std::uint32_t, Owners::number_of_nodes> nearest;
    for (const Space_triangle* const t : {&one, &other})
      if (after < limit)
        after += m_owners.cost_of_way_back(*t, visit_samples, nearest);
    return after < limit && m_guard.accepts(exchange(h, g));
  }

  // what a flip changes
  Local_change<Mesh> exchange(const Halfedge_index h, const Halfedge_index g) const
  {
    Local_change<Mesh> change(m_mesh);
    change.remove(m_mesh.face(h));
    change.remove(m_mesh.face(g));
    const auto a = change.corner(m_mesh.source(h), h), b = change.corner(m_mesh.target(h), h),
               c = change.corner(m_mesh.target(m_mesh.next(h)), h), d = change.corner(m_mesh.target(m_mesh.next(g)), h);
    change.add(c, a, d);
    change.add(d, b, c);
    return change;
  }

  Mesh& m_mesh;
  const Guard& m_guard;
  Owners& m_owners;
  const Shape_price& m_price;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FLIPPER_H
