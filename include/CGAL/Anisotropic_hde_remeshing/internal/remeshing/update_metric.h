// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_UPDATE_METRIC_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_UPDATE_METRIC_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Metric_tensor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Shape_operator_estimate.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// whether the embedding is a metric that follows from the curvature, which the vertices keep
template <typename Embedding>
constexpr bool is_metric = std::is_base_of<Metric_tensor, typename Embedding::Vertex_data>::value;

// Gives every vertex the metric of the curvature around it, bounds the lengths that edges can have by it, and limits how fast
// it changes: Alauzet, Size gradation control of anisotropic meshes, Finite Elements in Analysis and Design 46, 2010. What a
// vertex gets does not depend on the order of the vertices.
template <typename ConcurrencyTag, typename Mesh, typename Metric>
class Metric_updater
{
  // a bound: a sweep carries a metric one edge further, and few are needed as it loses a constant factor an edge
  static constexpr int maximum_number_of_sweeps = 30;
  static constexpr double negligible_growth = 1.02;

public:
  // `diagonal` is that of the mesh, `length` the target in the metric; as long as it is 0, there are neither bounds nor a limit
  Metric_updater(Mesh& mesh, const Metric& metric, const double diagonal, const double length, Interruption& interruption)
    : m_mesh(mesh),
      m_metric(metric),
      m_length(length),
      m_least(square(length / (metric.longest_edge() * diagonal))),
      m_largest(square(length / (metric.shortest_edge() * diagonal))),
      m_interruption(interruption)
  {
  }

  void operator()()
  {
    m_metrics.resize(vertex_capacity(m_mesh));
    for_each_vertex([&](const Vertex_index v) { m_metrics[v] = metric_of_curvature(v); });
    if (m_length > 0)
      limit_gradation();
    if (m_interruption.is_requested())
      return;
    for_each_vertex([&](const Vertex_index v) { store(v); });
  }

private:
  static double square(const double x) { return x * x; }

  template <typename Function>
  void for_each_vertex(const Function& f)
  {
    parallel_for<ConcurrencyTag>(
        vertex_capacity(m_mesh),
        [&](const std::size_t i)
        {
          const Vertex_index v(static_cast<Vertex_index::size_type>(i));
          if (!m_mesh.is_removed(v))
            f(v);
        },
        64, m_interruption);
  }

  Eigen::Matrix2d metric_of_curvature(const Vertex_index v) const
  {
    const Eigen::Matrix2d shape_operator = shape_operator_at(v, m_mesh);
    Eigen::Matrix2d metric = m_metric.of_shape_operator(shape_operator);
    if (!(m_length > 0))
      return metric;
    // along t the normal turns by |S t|
    const Eigen::Matrix2d of_turn = square(m_length / m_metric.turn()) * shape_operator * shape_operator;
    return bounded_metric(metric_intersection(metric, of_turn), m_least, m_largest);
  }

  // sweeps from vertices to their neighbours until little changes
  void limit_gradation()
  {
    std::vector<char> is_changed(m_metrics.size(), 1), is_changed_next(m_metrics.size(), 0);
    for (int sweep = 0; sweep < maximum_number_of_sweeps; ++sweep)
    {
      std::vector<Eigen::Matrix2d> next = m_metrics;
      for_each_vertex([&](const Vertex_index v) { is_changed_next[v] = limit(v, is_changed, next[v]); });
      if (m_interruption.ask())
        return;
      m_metrics.swap(next);
      is_changed.swap(is_changed_next);
      if (std::find(is_changed.begin(), is_changed.end(), char(1)) == is_changed.end())
        return;
    }
  }

  // by the neighbours that have changed; whether that is worth another sweep
  bool limit(const Vertex_index v, const std::vector<char>& is_changed, Eigen::Matrix2d& metric) const
  {
    const double area_before = metric.determinant();
    const Tangent_frame frame = tangent_frame(m_mesh.point(v).normal);
    for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      const Vertex_index u = m_mesh.source(h);
      if (!is_changed[u])
        continue;
      const auto &from = m_mesh.point(u), &to = m_mesh.point(v);
      if (!(from.normal.dot(to.normal) > 0))
        continue; // across a fold of the surface the planes have no directions in common
      const Tangent_frame other = tangent_frame(from.normal);
      const Eigen::Vector2d edge = other.transpose() * (to.point - from.point);
      const double length = std::sqrt((std::max)(edge.dot(m_metrics[u] * edge), 0.)) / m_length;
      const double growth = 1 + length * std::log(m_metric.gradation());
      // from plane to plane, by the rotation that takes one normal to the other
      const Eigen::Matrix2d turn = frame.transpose() * rotation(from.normal, to.normal) * other;
      metric = metric_intersection(metric, turn * (m_metrics[u] / square(growth)) * turn.transpose());
    }
    return metric.determinant() > square(negligible_growth) * area_before;
  }

  // the smallest that takes unit vector `a` to `b`, which are not opposite
  static Matrix rotation(const Vector& a, const Vector& b)
  {
    const Vector axis = a.cross(b);
    Matrix cross;
    cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    return Matrix::Identity() + cross + cross * cross / (1 + a.dot(b));
  }

  void store(const Vertex_index v)
  {
    auto& vertex = m_mesh.point(v);
    const Tangent_frame frame = tangent_frame(vertex.normal);
    // across the surface as along its shortest edges: two sheets that face each other do not count as near
    const double across =
        0.5 * (m_metrics[v].trace() + std::sqrt((std::max)(square(m_metrics[v].trace()) - 4 * m_metrics[v].determinant(), 0.)));
    static_cast<Metric_tensor&>(vertex) =
        Metric_tensor(frame * m_metrics[v] * frame.transpose() + across * vertex.normal * vertex.normal.transpose());
  }

  Mesh& m_mesh;
  const Metric& m_metric;
  const double m_length;
  const double m_least, m_largest; // eigenvalues
  Interruption& m_interruption;
  std::vector<Eigen::Matrix2d> m_metrics; // in tangent_frame(normal)
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_UPDATE_METRIC_H
