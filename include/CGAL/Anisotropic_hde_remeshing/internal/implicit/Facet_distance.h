// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_DISTANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_DISTANCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The distance to the facets of a mesh. Its sign tells the side of the pseudonormal at the closest point (Baerentzen and
// Aanaes). The pseudonormal is the normal of the facet. On an edge it is the sum of the normals of the facets there. At a
// vertex it is the sum of these normals, weighted by angle. If no facet has an area, but points have normals, this is the
// distance to the points. (CGAL::Side_of_triangle_mesh tells the side exactly, but only of a closed mesh.)
class Facet_distance : public Signed_distance
{
public:
  explicit Facet_distance(std::shared_ptr<const Surface_sample> sample)
    : m_sample(std::move(sample)), m_closest_facet(m_sample->points, m_sample->facets), m_point_distance(m_sample)
  {
  }

  Value_and_gradient distance(const Vector& p) const override
  {
    return m_closest_facet.empty() ? m_point_distance.distance(p) : distance(p, closest(p));
  }

  Value_and_gradient with_interpolated_normals(const Vector& p) const override
  {
    if (m_closest_facet.empty())
      return m_point_distance.with_interpolated_normals(p);
    const Closest_facet::Answer answer = closest(p);
    Value_and_gradient result = distance(p, answer);
    Vector normal = Vector::Zero();
    for (int k = 0; k < 3; ++k)
      normal += answer.barycentric[k] * m_sample->normals[m_sample->facets[answer.facet][k]];
    const double length = normal.norm();
    if (!(length > 0))
      return result;
    normal /= length;
    const double cosine = normal.dot(result.gradient);
    if (cosine > least_cosine)
      result.gradient = cosine * normal;
    return result;
  }

private:
  // least cosine between the interpolated normal and the direction of the distance; below it, the interpolated normal is of no
  // use
  static constexpr double least_cosine = 0.2;
  // largest barycentric coordinate of a point that is on the opposite edge
  static constexpr double on_edge = 1e-9;

  typedef std::pair<std::pair<std::size_t, std::size_t>, Vector> Edge_normal;

  Closest_facet::Answer closest(const Vector& p) const
  {
    std::call_once(m_is_built, [this] { build(); });
    return m_closest_facet(p);
  }

  Value_and_gradient distance(const Vector& p, const Closest_facet::Answer& answer) const
  {
    const Vector out = p - answer.point, normal = pseudonormal(answer);
    const double length = out.norm(), side = out.dot(normal) < 0 ? -1. : 1.;
    Value_and_gradient result;
    result.value = side * length;
    result.gradient = length > 1e-12 ? Vector(side / length * out) : normal; // coordinates are below 1
    return result;
  }

  Vector pseudonormal(const Closest_facet::Answer& answer) const
  {
    const Facet& facet = m_sample->facets[answer.facet];
    Vector normal = m_facet_normals[answer.facet];
    int last = 0, number_on_edge = 0;
    for (int k = 0; k < 3; ++k)
      if (answer.barycentric[k] <= on_edge)
      {
        last = k;
        ++number_on_edge;
      }
    if (number_on_edge == 1)
      normal = edge_normal(facet[(last + 1) % 3], facet[(last + 2) % 3]);
    else if (number_on_edge == 2)
    {
      Eigen::Index vertex;
      answer.barycentric.maxCoeff(&vertex);
      normal = m_vertex_normals[facet[std::size_t(vertex)]];
    }
    const double length = normal.norm();
    return length > 0 ? Vector(normal / length) : m_facet_normals[answer.facet];
  }

  static std::pair<std::size_t, std::size_t> key(const std::size_t i, const std::size_t j)
  {
    return std::make_pair((std::min)(i, j), (std::max)(i, j));
  }

  Vector edge_normal(const std::size_t i, const std::size_t j) const
  {
    Vector sum = Vector::Zero();
    for (auto edge = std::lower_bound(m_edge_normals.begin(), m_edge_normals.end(), key(i, j),
                                      [](const Edge_normal&e, const auto&k) { return e.first < k; });
         edge != m_edge_normals.end() && edge->first == key(i, j); ++edge)
      sum += edge->second;
    return sum;
  }

  void build() const
  {
    m_vertex_normals.assign(m_sample->size(), Vector::Zero());
    m_facet_normals.assign(m_sample->facets.size(), Vector::Zero());
    for (std::size_t f = 0; f < m_sample->facets.size(); ++f)
    {
      const Facet& facet = m_sample->facets[f];
      const auto edge = [&](const int k) -> Vector
      { return m_sample->points[facet[std::size_t((k + 1) % 3)]] - m_sample->points[facet[std::size_t(k)]]; };
      const Vector area = edge(0).cross(-edge(2)); // as Closest_facet has it
      if (!(area.norm() > 0))
        continue;
      m_facet_normals[f] = area.normalized();
      for (int k = 0; k < 3; ++k)
      {
        const Vector out = edge(k), in = -edge((k + 2) % 3);
        m_vertex_normals[facet[std::size_t(k)]] += angle_between(out, in) * m_facet_normals[f];
        m_edge_normals.emplace_back(key(facet[std::size_t(k)], facet[std::size_t((k + 1) % 3)]), m_facet_normals[f]);
      }
    }
    std::stable_sort(m_edge_normals.begin(), m_edge_normals.end(),
                     [](const Edge_normal& e, const Edge_normal& f) { return e.first < f.first; });
  }

  std::shared_ptr<const Surface_sample> m_sample;
  Closest_facet m_closest_facet;
  Point_distance m_point_distance;
  mutable std::once_flag m_is_built;
  mutable std::vector<Vector> m_facet_normals, m_vertex_normals;
  mutable std::vector<Edge_normal> m_edge_normals; // sorted by edge; one for each facet at an edge
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FACET_DISTANCE_H
