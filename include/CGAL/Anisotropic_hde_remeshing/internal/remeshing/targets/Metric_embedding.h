// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_EMBEDDING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_EMBEDDING_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_tensor.h>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The embedding by a metric of the tangent planes, a model of `RemeshingMetric`. The vertices keep the metric.
template <typename Metric>
class Metric_embedding
{
public:
  struct Vertex_data : Metric_tensor
  {
  };

  explicit Metric_embedding(const Metric& metric) : m_metric(metric), m_bounds(checked_bounds(m_metric.bounds())) {}

  Metric_embedding in_unit(const double unit) const { return Metric_embedding(m_metric.in_unit(unit)); }
  double unit_of_lengths(const double unit) const { return m_metric.unit_of_lengths(unit); }

  const Metric& metric() const { return m_metric; }
  const Metric_bounds& bounds() const { return m_bounds; }

  // The metric follows from the curvature around a vertex, which is known only once it has neighbours.
  void place(Vertex_data&) const {}

  template <typename Vertex>
  void place_between(const Vertex& a, const Vertex& b, Vertex& middle) const
  {
    static_cast<Metric_tensor&>(middle) = Metric_tensor::mean(a, b);
  }

  // by the mean of the metrics at the ends
  template <typename Vertex>
  double squared_length(const Vertex& a, const Vertex& b) const
  {
    return Metric_tensor::mean(a, b).squared_length(b.point - a.point);
  }

  // computed in space: the centroid of a triangle is the same in all constant metrics
  template <typename Vertex>
  class Centroid
  {
  public:
    Centroid(const Metric_embedding&, const Vertex& center, const Eigen::Matrix<double, 3, 2>& frame)
      : m_center(center), m_frame(frame)
    {
    }

    void add_neighbor(const Eigen::Vector2d&, const Vertex&) {}

    // Large faces weigh more than by their areas. This makes the largest faces smaller, and with them the largest distances.
    void add_face(const double area, const Vertex& a, const Vertex& b)
    {
      const double weight = area * std::sqrt(area);
      m_weight += weight;
      m_in_space += weight * ((a.point + b.point + m_center.point) / 3 - m_center.point);
    }

    Eigen::Vector2d tangential_step(const Eigen::Matrix2d&) const { return m_frame.transpose() * m_in_space / m_weight; }

  private:
    const Vertex& m_center;
    const Eigen::Matrix<double, 3, 2>& m_frame;
    Eigen::Vector3d m_in_space = Eigen::Vector3d::Zero();
    double m_weight = 0;
  };

private:
  Metric m_metric;
  Metric_bounds m_bounds;
};

// whether the vertices of an embedding keep a metric
template <typename Embedding>
constexpr bool is_metric = std::is_base_of<Metric_tensor, typename Embedding::Vertex_data>::value;

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_EMBEDDING_H
