// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_MEASURED_CONTRACTIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_MEASURED_CONTRACTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Quadric.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sampled_ring.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the contraction of an edge: how much more the faces cost after it, and where the vertex goes
struct Measured_contraction
{
  double cost;
  Edge_index edge;
  Halfedge_index halfedge; // to the vertex that stays
  Vector point;

  bool operator<(const Measured_contraction& other) const
  {
    return cost < other.cost || (cost == other.cost && edge < other.edge);
  }
};

// Measures by the samples what contractions cost. The quadrics of the samples tell in which order that is worth while.
template <typename ConcurrencyTag, typename Mesh>
class Measured_contractions
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;

  static constexpr std::size_t largest_degree = 14; // of both ends together

public:
  Measured_contractions(const Mesh& mesh, const Owners& owners, const Shape_price& price)
    : m_mesh(mesh), m_owners(owners), m_price(price), m_origin(first_point(mesh))
  {
  }

  // whether an edge may be contracted
  bool is_candidate(const Edge_index e) const
  {
    const Vertex_index a = m_mesh.vertex(e, 0), b = m_mesh.vertex(e, 1);
    return !(is_bound(a) && is_bound(b)) && m_mesh.degree(a) + m_mesh.degree(b) <= largest_degree &&
           CGAL::Euler::does_satisfy_link_condition(e, m_mesh.graph());
  }

  // edges that may be contracted, the cheapest by the quadrics first, at most `largest_number`
  std::vector<Edge_index> candidates(const std::size_t largest_number)
  {
    m_quadrics_of_faces.resize(face_capacity(m_mesh));
    parallel_for<ConcurrencyTag>(m_quadrics_of_faces.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Face_index f{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(f))
                                     m_quadrics_of_faces[i] = quadric_of_samples(f);
                                 });
    m_quadrics.resize(vertex_capacity(m_mesh));
    parallel_for<ConcurrencyTag>(m_quadrics.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Vertex_index v{std::uint32_t(i)};
                                   if (!m_mesh.is_removed(v))
                                     m_quadrics[i] = quadric(v);
                                 });
    std::vector<std::pair<double, Edge_index>> keys(edge_capacity(m_mesh), {infinity(), Edge_index()});
    parallel_for<ConcurrencyTag>(keys.size(),
                                 [&](const std::size_t i)
                                 {
                                   const Edge_index e{std::uint32_t(i)};
                                   if (m_mesh.is_removed(e) || !is_candidate(e))
                                     return;
                                   const Quadric sum = quadric(e);
                                   keys[i] = {sum(sum.minimum()), e};
                                 });
    keys.erase(std::remove_if(keys.begin(), keys.end(), [](const auto& k) { return !(k.first < infinity()); }), keys.end());
    const std::size_t n = (std::min)(keys.size(), largest_number);
    std::partial_sort(keys.begin(), keys.begin() + std::ptrdiff_t(n), keys.end());
    std::vector<Edge_index> result;
    for (std::size_t i = 0; i < n; ++i)
      result.push_back(keys[i].second);
    return result;
  }

  // Measures edges[first] to edges[last - 1]. Returns those that cost less than `limit` and leave no sample further from its
  // face than a distance.
  std::vector<Measured_contraction> measure(const std::vector<Edge_index>& edges, const std::size_t first,
                                            const std::size_t last, const double limit, const double largest_squared_distance,
                                            Interruption& interruption) const
  {
    std::vector<Measured_contraction> result(last - first);
    parallel_for<ConcurrencyTag>(
        result.size(), [&](const std::size_t i) { result[i] = measure(edges[first + i], limit, largest_squared_distance); }, 16,
        interruption);
    result.erase(std::remove_if(result.begin(), result.end(), [&](const auto& c) { return !(c.cost < limit); }), result.end());
    return result;
  }

private:
  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  bool is_bound(const Vertex_index v) const { return m_mesh.point(v).is_on_curve || m_mesh.point(v).is_fixed; }

  // A third of it belongs to each corner.
  Quadric quadric_of_samples(const Face_index f) const
  {
    Quadric result;
    m_owners.for_each(f,
                      [&](const std::uint32_t i)
                      {
                        const Reference_sample& s = m_owners.sample(i);
                        const double weight = s.area / 3.;
                        result += Quadric::of_plane(s.point - m_origin, s.normal.template cast<double>(), weight);
                        result += Quadric::of_point(s.point - m_origin, 1e-4 * weight);
                      });
    return result;
  }

  Quadric quadric(const Vertex_index v) const
  {
    Quadric result;
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if (!m_mesh.is_border(h))
        result += m_quadrics_of_faces.empty() ? quadric_of_samples(m_mesh.face(h)) : m_quadrics_of_faces[m_mesh.face(h)];
    result += Quadric::of_point(m_mesh.point(v).point - m_origin, 1e-14);
    return result;
  }

  Quadric quadric(const Edge_index e) const
  {
    const Vertex_index a = m_mesh.vertex(e, 0), b = m_mesh.vertex(e, 1);
    Quadric sum = m_quadrics.empty() ? quadric(a) : m_quadrics[a];
    return sum += m_quadrics.empty() ? quadric(b) : m_quadrics[b];
  }

  // the contraction of an edge to the best of the quadric's optimum, its middle and its ends
  Measured_contraction measure(const Edge_index e, const double limit, const double largest_squared_distance) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    const Vertex_index a = m_mesh.source(h), b = m_mesh.target(h);
    const Vector &p = m_mesh.point(a).point, &q = m_mesh.point(b).point;
    Sampled_ring<ConcurrencyTag, Mesh> ring(m_mesh, m_owners, m_price);
    ring.add_edge(h);
    if (!(largest_squared_distance < infinity()))
      ring.leave_samples_out();
    Measured_contraction best{limit, e, h, Vector::Zero()};
    const auto look_at = [&](const Halfedge_index to, const Vector& point)
    {
      const double cost = ring.cost_at(point, ring.cost() + best.cost, largest_squared_distance) - ring.cost();
      if (cost < best.cost)
        best = Measured_contraction{cost, e, to, point};
    };
    if (!is_bound(a) && !is_bound(b))
    {
      const Vector optimum = m_origin + quadric(e).minimum();
      if ((optimum - p).squaredNorm() < 4 * (p - q).squaredNorm())
        look_at(h, optimum);
      look_at(h, (p + q) / 2);
    }
    if (!is_bound(a))
      look_at(h, q);
    if (!is_bound(b))
      look_at(m_mesh.opposite(h), p);
    return best;
  }

  const Mesh& m_mesh;
  const Owners& m_owners;
  const Shape_price& m_price;
  const Vector m_origin;                                // of the quadrics: far from it they would be inexact
  std::vector<Quadric> m_quadrics_of_faces, m_quadrics; // by face and by vertex, if all edges have been looked at
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_MEASURED_CONTRACTIONS_H
