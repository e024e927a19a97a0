// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_TANGENT_PLANE_BLEND_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_TANGENT_PLANE_BLEND_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The fallback of a patch whose system has no acceptable solution: the mean of the signed distances to the tangent planes of
// its points, sum w_i n_i . (x - x_i) / sum w_i with w_i = (|x - x_i|^2 / h_i^2 + 1/16)^-4. It is smooth, finite everywhere,
// negative inside, and needs no solve; it is merely less accurate.
class Tangent_plane_blend
{
public:
  Tangent_plane_blend() = default;

  Tangent_plane_blend(const Surface_sample& sample, const std::vector<std::size_t>& indices)
  {
    m_points.reserve(indices.size());
    for (const std::size_t i : indices)
      m_points.push_back(Point{sample.points[i], sample.normals[i], 1. / (sample.spacings[i] * sample.spacings[i])});
  }

  bool empty() const { return m_points.empty(); }

  Value_and_gradient operator()(const Vector& p) const
  {
    double weights = 0, value = 0;
    Vector weight_gradient = Vector::Zero(), gradient = Vector::Zero();
    for (const Point& point : m_points)
    {
      const Vector difference = p - point.position;
      const double base = 1. / (difference.squaredNorm() * point.inverse_squared_spacing + 1. / 16);
      const double weight = base * base * base * base;
      const Vector slope = (-8 * weight * base * point.inverse_squared_spacing) * difference;
      const double distance = point.normal.dot(difference);
      weights += weight;
      value += weight * distance;
      weight_gradient += slope;
      gradient += slope * distance + weight * point.normal;
    }
    Value_and_gradient result;
    result.value = value / weights;
    result.gradient = (gradient - result.value * weight_gradient) / weights;
    return result;
  }

  std::size_t memory_bytes() const { return m_points.size() * sizeof(Point); }

private:
  struct Point
  {
    Vector position, normal;
    double inverse_squared_spacing;
  };

  std::vector<Point> m_points;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_TANGENT_PLANE_BLEND_H
