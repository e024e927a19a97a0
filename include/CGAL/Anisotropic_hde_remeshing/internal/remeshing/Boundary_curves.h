// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_BOUNDARY_CURVES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_BOUNDARY_CURVES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The closed polylines that bound the input. A vertex of the boundary stays on its curve: its parameter counts the
// vertices of the polyline, linear in between, and grows along the border halfedges.
class Boundary_curves
{
  // polylines turn by more than this, in radians, at a corner, which is kept
  static constexpr double corner_angle = 60 * 3.14159265358979323846 / 180;

public:
  Boundary_curves() = default;

  // finds the curves of the mesh and places its vertices on them
  explicit Boundary_curves(Working_mesh& mesh)
  {
    std::vector<char> is_visited(mesh.num_halfedges(), 0);
    for (const Halfedge_index first : mesh.halfedges())
    {
      if (!mesh.is_border(first) || is_visited[first])
        continue;
      std::vector<Vector> points;
      Halfedge_index h = first;
      do
      {
        is_visited[h] = 1;
        Vertex_state& state = mesh.point(mesh.target(h));
        state.is_fixed = state.is_on_boundary(); // curves touch in a vertex: it stays
        state.curve = int(m_curves.size());
        state.parameter = double(points.size());
        points.push_back(state.point);
        h = mesh.next(h);
      } while (h != first);
      m_curves.push_back(Curve(std::move(points)));
    }
    for (const Vertex_index v : mesh.vertices())
    {
      Vertex_state& state = mesh.point(v);
      if (state.is_on_boundary() && m_curves[std::size_t(state.curve)].turn(std::size_t(state.parameter)) > corner_angle)
        state.is_fixed = true;
    }
  }

  std::size_t size() const { return m_curves.size(); }

  // whether two neighbours lie on the same curve, so that there is a way between them along it
  static bool are_on_one_curve(const Vertex_state& a, const Vertex_state& b)
  {
    return a.is_on_boundary() && a.curve == b.curve;
  }

  // the way along the curve from one vertex to the next, in arc length
  double distance(const Vertex_state& from, const Vertex_state& to) const
  {
    const Curve& curve = m_curves[std::size_t(from.curve)];
    const double difference = curve.arc_length(to.parameter) - curve.arc_length(from.parameter);
    return difference > 0 ? difference : difference + curve.length();
  }

  // places `state` at the arc length `distance` behind `from`, which may be negative
  void place(Vertex_state& state, const Vertex_state& from, const double distance) const
  {
    const Curve& curve = m_curves[std::size_t(from.curve)];
    state.curve = from.curve;
    state.parameter = curve.parameter(curve.arc_length(from.parameter) + distance);
    state.point = curve.point(state.parameter);
  }

private:
  class Curve
  {
  public:
    explicit Curve(std::vector<Vector> points) : m_points(std::move(points)), m_arc_lengths(1, 0.)
    {
      for (std::size_t i = 0; i < m_points.size(); ++i)
        m_arc_lengths.push_back(m_arc_lengths.back() + (next(i) - m_points[i]).norm());
    }

    double length() const { return m_arc_lengths.back(); }

    double arc_length(const double parameter) const
    {
      const std::size_t i = (std::min)(std::size_t(parameter), m_points.size() - 1);
      return m_arc_lengths[i] + (parameter - double(i)) * (m_arc_lengths[i + 1] - m_arc_lengths[i]);
    }

    double parameter(double arc_length) const
    {
      arc_length -= length() * std::floor(arc_length / length());
      const auto above = std::upper_bound(m_arc_lengths.begin(), m_arc_lengths.end(), arc_length);
      const std::size_t i =
          (std::min)(std::size_t((std::max)(above - m_arc_lengths.begin(), std::ptrdiff_t(1))) - 1, m_points.size() - 1);
      const double edge = m_arc_lengths[i + 1] - m_arc_lengths[i];
      return double(i) + (edge > 0 ? (std::min)((arc_length - m_arc_lengths[i]) / edge, 1.) : 0.);
    }

    Vector point(const double parameter) const
    {
      const std::size_t i = (std::min)(std::size_t(parameter), m_points.size() - 1);
      const double share = parameter - double(i);
      return (1 - share) * m_points[i] + share * next(i);
    }

    // the angle, in radians, by which the polyline turns at its vertex i
    double turn(const std::size_t i) const
    {
      const Vector before = m_points[i] - m_points[(i + m_points.size() - 1) % m_points.size()];
      const Vector behind = next(i) - m_points[i];
      return std::atan2(before.cross(behind).norm(), before.dot(behind));
    }

  private:
    const Vector& next(const std::size_t i) const { return m_points[(i + 1) % m_points.size()]; }

    std::vector<Vector> m_points;
    std::vector<double> m_arc_lengths; // of the vertices, and at last of the whole
  };

  std::vector<Curve> m_curves;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_BOUNDARY_CURVES_H
