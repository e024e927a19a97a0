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
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_flips.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Flips edges where that lowers the measured error, the price of shape included.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Error_flipper
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;
  typedef Edge_flips<ConcurrencyTag, Mesh, Guard> Flips;

  static constexpr int maximum_number_of_passes = 4;
  static constexpr double smallest_gain = 0.03;            // of the cost of both faces
  static constexpr double smallest_cosine = 0.3;           // between a face and its samples
  static constexpr double smallest_cosine_of_faces = -0.2; // between both faces

public:
  Error_flipper(Mesh& mesh, const Guard& guard, Owners& owners, const Shape_price& price, Interruption& interruption)
    : m_mesh(mesh), m_owners(owners), m_price(price), m_flips(mesh, guard, interruption)
  {
  }

  // returns the number of flips
  std::size_t operator()()
  {
    return m_flips(
        maximum_number_of_passes, [&](const Edge_index e) { return gains(e); }, [&](const Edge_index e) { flip(e); });
  }

private:
  void flip(const Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    m_samples.clear();
    m_owners.take(m_mesh.face(h), m_samples);
    m_owners.take(m_mesh.face(g), m_samples);
    m_flips.flip(e);
    m_owners.give(m_samples, std::array<Face_index, 2>{m_mesh.face(h), m_mesh.face(g)});
  }

  bool gains(const Edge_index e) const
  {
    if (m_mesh.is_on_curve(e))
      return false;
    const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
    const typename Flips::Quad q = m_flips.quad(e);
    const Vector &a = m_mesh.point(q.a).point, &b = m_mesh.point(q.b).point, &c = m_mesh.point(q.c).point,
                 &d = m_mesh.point(q.d).point;
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
    return after < limit && m_flips.is_allowed(e, q);
  }

  const Mesh& m_mesh;
  Owners& m_owners;
  const Shape_price& m_price;
  const Flips m_flips;
  std::vector<std::uint32_t> m_samples; // of a flip
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ERROR_FLIPPER_H
