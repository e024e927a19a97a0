// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_UPDATER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_UPDATER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Tangent_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Shape_operator_estimate.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_embedding.h>

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

// Gives every vertex its metric, by the curvature around it. On a crease every side of the vertex gets one. Bounds the edge
// lengths that follow from the metric. Limits how fast the metric changes: Alauzet, Size gradation control of anisotropic
// meshes, Finite Elements in Analysis and Design 46, 2010. What a vertex gets does not depend on the order of the vertices.
template <typename ConcurrencyTag, typename Mesh, typename Embedding>
class Metric_updater
{
  // A bound only. A sweep carries a metric one edge further. Few sweeps are needed, because a metric loses a constant factor on
  // each edge.
  static constexpr int maximum_number_of_sweeps = 30;
  static constexpr double negligible_growth = 1.02;

public:
  // `diagonal` is that of the mesh, `length` the target in the metric. As long as `length` is 0, there are neither bounds nor a
  // limit.
  Metric_updater(Mesh& mesh, const Embedding& embedding, const double diagonal, const double length, Interruption& interruption)
    : m_mesh(mesh),
      m_embedding(embedding),
      m_length(length),
      m_least(square(length / (embedding.bounds().longest_edge * diagonal))),
      m_largest(square(length / (embedding.bounds().shortest_edge * diagonal))),
      m_interruption(interruption)
  {
  }

  void operator()()
  {
    number_places();
    m_metrics.resize(m_places.size());
    for_each_place([&](const std::size_t i) { m_metrics[i] = metric_of_curvature(m_places[i]); });
    if (m_length > 0)
      limit_gradation();
    if (m_interruption.is_requested())
      return;
    for_each_place([&](const std::size_t i) { store(m_places[i], m_metrics[i]); });
    for (const Vertex_index v : m_mesh.vertices())
      if (m_mesh.point(v).is_on_crease)
        m_mesh.point(v) = m_mesh.sides(v).front().vertex;
  }

private:
  static double square(const double x) { return x * x; }

  // Each place has one metric. A place is a vertex, or one side of a vertex on a crease. It is stored as a halfedge that ends
  // at the vertex and whose face is on that side.
  void number_places()
  {
    m_first_places.resize(vertex_capacity(m_mesh));
    for (const Vertex_index v : m_mesh.vertices())
    {
      m_first_places[v] = m_places.size();
      if (!m_mesh.point(v).is_on_crease)
        m_places.push_back(m_mesh.halfedge(v));
      for (const auto& side : m_mesh.sides(v))
        for (const Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
          if (m_mesh.region(h) == side.region)
          {
            m_places.push_back(h);
            break;
          }
    }
  }

  // the place of a vertex as the face of h sees it
  std::size_t place(const Vertex_index v, const Halfedge_index h) const
  {
    std::size_t i = m_first_places[v];
    if (m_mesh.point(v).is_on_crease)
      while (m_mesh.region(m_places[i]) != m_mesh.region(h))
        ++i;
    return i;
  }

  template <typename Function>
  void for_each_place(const Function& f)
  {
    parallel_for<ConcurrencyTag>(m_places.size(), f, 64, m_interruption);
  }

  Eigen::Matrix2d metric_of_curvature(const Halfedge_index in) const
  {
    const Eigen::Matrix2d shape_operator = shape_operator_at(in, m_mesh);
    const auto& vertex = m_mesh.state(m_mesh.target(in), in);
    Eigen::Matrix2d metric = m_embedding.metric()(vertex.point, tangent_frame(vertex.normal), shape_operator);
    if (!(m_length > 0))
      return metric;
    if (std::isfinite(m_embedding.bounds().turn)) // along t the normal turns by |S t|
      metric = metric_intersection(metric, square(m_length / m_embedding.bounds().turn) * shape_operator * shape_operator);
    return bounded_metric(metric, m_least, m_largest);
  }

  // sweeps from vertices to their neighbours until little changes
  void limit_gradation()
  {
    std::vector<char> is_changed(m_metrics.size(), 1), is_changed_next(m_metrics.size(), 0);
    for (int sweep = 0; sweep < maximum_number_of_sweeps; ++sweep)
    {
      std::vector<Eigen::Matrix2d> next = m_metrics;
      for_each_place([&](const std::size_t i) { is_changed_next[i] = limit(m_places[i], is_changed, next[i]); });
      if (m_interruption.ask())
        return;
      m_metrics.swap(next);
      is_changed.swap(is_changed_next);
      if (std::find(is_changed.begin(), is_changed.end(), char(1)) == is_changed.end())
        return;
    }
  }

  // limits the metric by those neighbours that have changed; returns whether that is worth another sweep
  bool limit(const Halfedge_index in, const std::vector<char>& is_changed, Eigen::Matrix2d& metric) const
  {
    const double area_before = metric.determinant();
    const auto& to = m_mesh.state(m_mesh.target(in), in);
    const Tangent_frame frame = tangent_frame(to.normal);
    for (const Halfedge_index h : m_mesh.halfedges_around_target(in))
    {
      if (to.is_on_crease && m_mesh.region(h) != m_mesh.region(in) && m_mesh.region(m_mesh.opposite(h)) != m_mesh.region(in))
        continue; // in another region
      const std::size_t u = place(m_mesh.source(h), in);
      if (!is_changed[u])
        continue;
      const auto& from = m_mesh.state(m_mesh.source(h), in);
      if (!(from.normal.dot(to.normal) > 0))
        continue; // across a fold of the surface the planes have no directions in common
      const Tangent_frame other = tangent_frame(from.normal);
      const Eigen::Vector2d edge = other.transpose() * (to.point - from.point);
      const double length = std::sqrt((std::max)(edge.dot(m_metrics[u] * edge), 0.)) / m_length;
      const double growth = 1 + length * std::log(m_embedding.bounds().gradation);
      // from plane to plane, by the rotation that takes one normal to the other
      const Eigen::Matrix2d turn = frame.transpose() * rotation(from.normal, to.normal) * other;
      metric = metric_intersection(metric, turn * (m_metrics[u] / square(growth)) * turn.transpose());
    }
    return metric.determinant() > square(negligible_growth) * area_before;
  }

  // the smallest rotation that takes unit vector `a` to unit vector `b`; they are not opposite
  static Matrix rotation(const Vector& a, const Vector& b)
  {
    const Vector axis = a.cross(b);
    Matrix cross;
    cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    return Matrix::Identity() + cross + cross * cross / (1 + a.dot(b));
  }

  void store(const Halfedge_index in, const Eigen::Matrix2d& metric)
  {
    const Vertex_index v = m_mesh.target(in);
    if (!m_mesh.point(v).is_on_crease)
    {
      store(metric, m_mesh.point(v));
      return;
    }
    for (auto& side : m_mesh.sides(v)) // other threads store the other sides
      if (side.region == m_mesh.region(in))
        store(metric, side.vertex);
  }

  static void store(const Eigen::Matrix2d& metric, typename Mesh::Vertex& vertex)
  {
    const Tangent_frame frame = tangent_frame(vertex.normal);
    // Across the surface the metric is the same as along the shortest edges: so two sheets that face each other do not count as
    // near.
    const double across = 0.5 * (metric.trace() + std::sqrt((std::max)(square(metric.trace()) - 4 * metric.determinant(), 0.)));
    static_cast<Metric_tensor&>(vertex) =
        Metric_tensor(frame * metric * frame.transpose() + across * vertex.normal * vertex.normal.transpose());
  }

  Mesh& m_mesh;
  const Embedding& m_embedding;
  const double m_length;
  const double m_least, m_largest; // eigenvalues
  Interruption& m_interruption;
  std::vector<Halfedge_index> m_places;
  std::vector<std::size_t> m_first_places; // of the vertices
  std::vector<Eigen::Matrix2d> m_metrics;  // of the places, in tangent_frame(normal)
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_METRIC_UPDATER_H
