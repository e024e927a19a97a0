// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINT_DISTANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINT_DISTANCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// An estimate of the signed distance to a surface. Points with normals are samples of this surface. The estimate is the mean of
// the signed distances to the tangent planes of the nearest points. The weights are (1/r_i - 1/r)^2, with the distance r of the
// farthest of these points. The weight of the farthest point is zero, so the value is continuous. The gradient is the mean of
// the normals: the derivative of the value without that of the weights.
class Point_distance : public Signed_distance
{
  static constexpr unsigned int number_of_neighbors = 16;

public:
  explicit Point_distance(std::shared_ptr<const Surface_sample> sample) : m_sample(std::move(sample)) {}

  Value_and_gradient distance(const Vector& p) const override
  {
    std::call_once(m_is_built, [this] { build(); });
    std::vector<std::pair<double, std::size_t>> neighbors = m_search->nearest(p, number_of_neighbors + 1);
    std::sort(neighbors.begin(), neighbors.end());
    const double farthest = neighbors.size() > number_of_neighbors ? 1. / std::sqrt(neighbors.back().first) : 0.;
    double weights = 0;
    Value_and_gradient result;
    for (const auto& neighbor : neighbors)
    {
      const std::size_t i = m_with_normal[neighbor.second];
      // at a point of the sample, its own weight outweighs all others
      const double root = 1. / std::sqrt((std::max)(neighbor.first, 1e-28)) - farthest, weight = root * root;
      weights += weight;
      result.value += weight * m_sample->normals[i].dot(p - m_sample->points[i]);
      result.gradient += weight * m_sample->normals[i];
    }
    if (weights > 0)
    {
      result.value /= weights;
      result.gradient /= weights;
    }
    else // all equally far
    {
      const std::size_t i = m_with_normal[neighbors.front().second];
      result.value = m_sample->normals[i].dot(p - m_sample->points[i]);
      result.gradient = m_sample->normals[i];
    }
    return result;
  }

  Value_and_gradient with_interpolated_normals(const Vector& p) const override { return distance(p); }

private:
  void build() const
  {
    std::vector<Vector> points;
    for (std::size_t i = 0; i < m_sample->size(); ++i)
      if (!m_sample->normals[i].isZero(0))
      {
        points.push_back(m_sample->points[i]);
        m_with_normal.push_back(i);
      }
    m_search = std::make_unique<Point_search>(points);
  }

  std::shared_ptr<const Surface_sample> m_sample;
  mutable std::once_flag m_is_built;
  mutable std::vector<std::size_t> m_with_normal; // the points that have one
  mutable std::unique_ptr<Point_search> m_search;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINT_DISTANCE_H
