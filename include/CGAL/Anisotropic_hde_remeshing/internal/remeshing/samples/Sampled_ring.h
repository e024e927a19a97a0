// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SAMPLED_RING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SAMPLED_RING_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Reference_samples.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The faces around a vertex, or around both ends of an edge that becomes one, with their samples: what they cost if the vertex
// is at some point.
template <typename ConcurrencyTag, typename Mesh>
class Sampled_ring
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;

  static constexpr double smallest_cosine = 0.3;     // of the turn of a face
  static constexpr std::size_t enough_samples = 100; // to measure by; each so many are left out if there are more

public:
  Sampled_ring(const Mesh& mesh, const Owners& owners, const Shape_price& price)
    : m_mesh(mesh), m_owners(owners), m_price(price)
  {
  }

  // the ring of the edge of h
  void add_edge(const Halfedge_index h)
  {
    add_end(h, m_mesh.source(h), true);
    add_end(m_mesh.opposite(h), m_mesh.target(h), false);
  }

  // both faces at the edge of h, which the vertex divides
  void add_quad(const Halfedge_index h)
  {
    const Vector middle = internal::middle(h, m_mesh);
    for (const Halfedge_index g : {h, m_mesh.opposite(h)})
    {
      add_samples(m_mesh.face(g));
      for (const Halfedge_index side : {m_mesh.next(g), m_mesh.prev(g)})
        m_corners.push_back({middle, m_mesh.point(m_mesh.source(side)).point, m_mesh.point(m_mesh.target(side)).point});
    }
  }

  // the ring of a vertex
  void add_vertex(const Vertex_index v) { add_end(m_mesh.halfedge(v), Mesh::null_vertex(), true); }

  void leave_samples_out()
  {
    const std::size_t stride = (std::max)(m_samples.size() / enough_samples, std::size_t(1));
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_samples.size(); i += stride)
      m_samples[n++] = m_samples[i];
    m_samples.resize(n);
    m_weight = double(stride);
  }

  // of the faces as they are
  double cost() const { return m_cost; }

  // The cost with the vertex at a point. It is infinite if a face turned too far or became a needle, if a sample or a node of a
  // face were further than a distance, or if it is more than `limit`.
  double cost_at(const Vector& point, const double limit, const double largest_squared_distance) const
  {
    double cost = price_at(point);
    for (const std::uint32_t i : m_samples)
    {
      if (!(cost < limit))
        return infinity();
      const Reference_sample& s = m_owners.sample(i);
      const double least = squared_distance_at(point, s.point);
      if (least > largest_squared_distance)
        return infinity();
      cost += m_weight * s.area * m_owners.cost(least);
    }
    typename Owners::Nearest_samples nearest;
    for (const auto& c : m_corners)
    {
      if (!(cost < limit))
        return infinity();
      cost += m_owners.cost_of_way_back(Space_triangle{point, c[1], c[2]}, visit_samples(), nearest, largest_squared_distance);
    }
    return cost;
  }

  // whether no face turns too far or becomes a needle with the vertex at a point
  bool allows(const Vector& point) const { return price_at(point) < infinity(); }

  const std::vector<std::uint32_t>& samples() const { return m_samples; }

  // the faces with the vertex, the first corner, at a point
  template <typename Visit>
  void for_each_face(const Vector& point, const Visit& visit) const
  {
    for (const auto& c : m_corners)
      visit(Space_triangle{point, c[1], c[2]});
  }

  // of a point from the faces with the vertex at another one
  double squared_distance_at(const Vector& point, const Vector& p) const
  {
    double least = infinity();
    for (const auto& c : m_corners)
      least = (std::min)(least, closest_on_triangle(p, point, c[1], c[2]).squared_distance);
    return least;
  }

private:
  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  auto visit_samples() const
  {
    return [this](const auto& visit)
    {
      for (const std::uint32_t i : m_samples)
        visit(i);
    };
  }

  void add_samples(const Face_index f)
  {
    m_cost += m_owners.cost(f) + m_price(m_owners.triangle(f));
    m_owners.for_each(f, [&](const std::uint32_t i) { m_samples.push_back(i); });
  }

  // the faces around the target of h; those at `other` are gone in the end, and are added with `adds_faces_at_other` only
  void add_end(const Halfedge_index h, const Vertex_index other, const bool adds_faces_at_other)
  {
    for (const Halfedge_index in : m_mesh.halfedges_around_target(h))
    {
      if (m_mesh.is_border(in))
        continue;
      const Triangle t(in, m_mesh);
      const bool has_other = t.a == other || t.c == other;
      if (has_other && !adds_faces_at_other)
        continue;
      add_samples(m_mesh.face(in));
      if (!has_other)
        m_corners.push_back({m_mesh.point(t.b).point, m_mesh.point(t.c).point, m_mesh.point(t.a).point});
    }
  }

  double price_at(const Vector& point) const
  {
    double price = 0;
    for (const auto& c : m_corners)
    {
      const Space_triangle before{c[0], c[1], c[2]}, after{point, c[1], c[2]};
      const Vector m = before.normal(), n = after.normal();
      if (!(n.norm() > 0) || n.dot(m) < smallest_cosine * n.norm() * m.norm())
        return infinity();
      const double ratio = after.ratio();
      if (ratio > m_price.largest_ratio() && ratio > before.ratio())
        return infinity();
      price += m_price(after);
    }
    return price;
  }

  const Mesh& m_mesh;
  const Owners& m_owners;
  const Shape_price& m_price;
  std::vector<std::array<Vector, 3>> m_corners; // of the faces that stay; the moving one comes first
  std::vector<std::uint32_t> m_samples;
  double m_weight = 1; // of each sample, over that of its area
  double m_cost = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SAMPLED_RING_H
