// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_NETWORK_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_NETWORK_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/curves/curve_plane.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Which way a point of a border goes onto the surface: perpendicular to one or two unit vectors, or to zero vectors, no further than the
// reach.
struct Border_way
{
  Vector one = Vector::Zero(), other = Vector::Zero();
  double reach = 0;
};

// The polylines of the input that the mesh keeps: its boundaries, the constrained edges and the edges between patches. A curve
// goes from corner to corner, or is closed without a corner. A corner is where curves end, branch or turn sharply. Corners are
// fixed. The other vertices of a curve stay on it.
class Curve_network
{
  // polylines turn by more than this, in radians, at a corner
  static constexpr double corner_angle = 60 * 3.14159265358979323846 / 180;
  // A polyline stands for an arc if it turns by at most this angle at each point, in radians: a circle has at least 60 edges.
  // The turns at the ends of an edge must not differ by more than this share of their mean.
  static constexpr double largest_turn_of_arc = 6 * 3.14159265358979323846 / 180;
  static constexpr double largest_change_of_turn = 0.5;
  // the largest distance of a vertex of a crease from its polyline, as a multiple of that of an edge
  static constexpr double largest_reach_per_deviation = 10;

public:
  // traces the edges of the mesh that are marked as unnamed, names their curves and fixes the corners
  template <typename Mesh>
  explicit Curve_network(Mesh& mesh)
  {
    const std::vector<int> degrees = curve_degrees(mesh);
    for (const Vertex_index v : mesh.vertices())
      if (degrees[v] > 0)
      {
        mesh.point(v).is_on_curve = true;
        if (mesh.point(v).is_fixed)
          continue;
        mesh.point(v).is_fixed = degrees[v] != 2 || is_sharp(v, mesh);
        if (mesh.point(v).is_fixed && degrees[v] == 2)
          m_turns.push_back(v);
      }
    std::vector<char> is_traced(edge_capacity(mesh), 0);
    for (const bool from_corners : {true, false}) // a curve that no corner reaches is closed
      for (const Halfedge_index h : mesh.halfedges())
        if (is_named_later(mesh.arc(h)) && !is_traced[mesh.edge(h)] && (mesh.point(mesh.source(h)).is_fixed || !from_corners))
          trace(h, mesh, is_traced);
  }

  std::size_t size() const { return m_curves.size(); }

  Vector point(const int curve, const double arc_length) const { return m_curves[std::size_t(curve)].point(arc_length); }

  // How far a new vertex may lie from the polyline: twice the height of the circular arc that turns as the polyline does there.
  // It is 0 where the polyline is straight. It is also 0 where the polyline turns too much or too unevenly to stand for an arc.
  double reach(const int curve, const double arc_length) const
  {
    return (std::min)(m_curves[std::size_t(curve)].reach(arc_length), largest_reach_per_deviation * m_largest_deviation);
  }

  // whether vertices of the curves may be removed, and whether they may be smoothed along them
  void set_allowed(const bool collapse, const bool smooth)
  {
    m_may_collapse = collapse;
    m_may_smooth = smooth;
  }
  bool may_collapse() const { return m_may_collapse; }
  bool may_smooth() const { return m_may_smooth; }

  // Lets borders be put on the surface, with their sharp turns. Where they turn from a plane into another one there are corners, too.
  // Call it before the vertices get other numbers.
  template <typename Mesh>
  void project_borders(Mesh& mesh)
  {
    m_projects_borders = true;
    m_border_planes.resize(m_curves.size());
    double length = 0;
    std::size_t number = 0;
    for (const Halfedge_index h : mesh.halfedges())
      if (mesh.is_border(h) && mesh.arc(h).curve >= 0)
      {
        const Curve_arc arc = mesh.arc(h);
        const Curve& curve = m_curves[std::size_t(arc.curve)];
        std::vector<Curve_plane>& planes = m_border_planes[std::size_t(arc.curve)];
        planes.resize(curve.arc_lengths().size() - 1);
        planes[curve.edge(0.5 * (arc.source + arc.target))] = border_plane(h, mesh);
        if (!mesh.point(mesh.target(h)).is_fixed && is_between_planes(h, mesh))
        {
          mesh.point(mesh.target(h)).is_fixed = true;
          m_turns.push_back(mesh.target(h));
        }
        length += std::abs(arc.target - arc.source);
        ++number;
      }
    m_mean_border_edge = number > 0 ? length / double(number) : 0;
    for (const Vertex_index v : m_turns)
      for (const Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if (mesh.is_border(h))
          m_corners.emplace(mesh.point(v).input_vertex, border_corner_at(h, mesh));
  }

  bool projects_borders() const { return m_projects_borders; }
  bool is_projected(const int curve) const { return m_projects_borders && !m_border_planes[std::size_t(curve)].empty(); }

  // In the plane of the border, if it has one there; otherwise, and along the second way, perpendicular to it. The surface may not
  // cross the plane.
  std::array<Border_way, 2> border_ways(const int curve, const double arc_length) const
  {
    const std::size_t edge = m_curves[std::size_t(curve)].edge(arc_length);
    const Curve_plane& plane = m_border_planes[std::size_t(curve)][edge];
    std::array<Border_way, 2> result;
    result[1].one = m_curves[std::size_t(curve)].direction(edge);
    result[0].one = plane.normal.isZero(0) ? result[1].one : plane.normal;
    result[0].reach = result[1].reach = reach(plane, plane);
    return result;
  }

  // a sharp turn of a border in the input, and its way along both planes; a null pointer if the vertex is none
  struct Border_corner
  {
    Vector point;
    Border_way way;
  };
  const Border_corner* border_corner(const std::uint32_t input_vertex) const
  {
    const auto found = m_corners.find(input_vertex);
    return found == m_corners.end() ? nullptr : &found->second;
  }

  // bounds how far the polyline may be from an edge that stands for a part of it
  void set_largest_deviation(const double deviation) { m_largest_deviation = deviation; }
  double largest_deviation() const { return m_largest_deviation; }
  bool bounds_deviation() const { return std::isfinite(m_largest_deviation); }

  // whether an edge may stand for this part of a curve
  bool accepts(const Curve_arc& arc) const
  {
    return !bounds_deviation() ||
           m_curves[std::size_t(arc.curve)].deviation((std::min)(arc.source, arc.target), (std::max)(arc.source, arc.target)) <=
               m_largest_deviation;
  }

  // the next halfedge along the curve of `h`; the target of `h` must be on this curve only
  template <typename Mesh>
  static Halfedge_index next_on_curve(const Halfedge_index h, const Mesh& mesh)
  {
    Halfedge_index in = h;
    do
      in = mesh.prev(mesh.opposite(in));
    while (!mesh.is_on_curve(mesh.edge(in)));
    return mesh.opposite(in);
  }

private:
  class Curve
  {
  public:
    Curve(std::vector<Vector> points, const bool is_closed) : m_points(std::move(points)), m_is_closed(is_closed)
    {
      m_arc_lengths.push_back(0);
      for (std::size_t i = 1; i < m_points.size(); ++i)
        m_arc_lengths.push_back(m_arc_lengths.back() + (m_points[i] - m_points[i - 1]).norm());
    }

    const std::vector<double>& arc_lengths() const { return m_arc_lengths; }

    Vector point(const double arc_length) const
    {
      const Place place = find(arc_length);
      return (1 - place.share) * m_points[place.edge] + place.share * m_points[place.edge + 1];
    }

    double reach(const double arc_length) const
    {
      const std::size_t edge = find(arc_length).edge;
      const bool begins = is_corner(edge), ends = is_corner(edge + 1);
      if (begins && ends)
        return 0;
      const Vector before = begins ? turn(edge + 1) : turn(edge), behind = ends ? before : turn(edge + 1);
      const double angle = 0.5 * (before + behind).norm();
      const bool is_arc = angle <= largest_turn_of_arc && (before - behind).norm() <= largest_change_of_turn * angle;
      return is_arc ? 0.25 * angle * (m_arc_lengths[edge + 1] - m_arc_lengths[edge]) : 0;
    }

    std::size_t edge(const double arc_length) const { return find(arc_length).edge; }

    // of length 1, or zero
    Vector direction(const std::size_t edge) const
    {
      const Vector along = m_points[edge + 1] - m_points[edge];
      return along.norm() > 0 ? along.normalized() : along;
    }

    // The largest distance of the polyline between two arc lengths from the line segment that joins its points there. To look
    // at the vertices of the polyline is enough.
    double deviation(const double from, const double to) const
    {
      const Vector source = point(from), chord = point(to) - source;
      const double squared_length = chord.squaredNorm();
      double largest = 0;
      const auto look_at = [&](const Vector& p)
      {
        const double share = squared_length > 0 ? (p - source).dot(chord) / squared_length : 0;
        largest = (std::max)(largest, (source + (std::min)((std::max)(share, 0.), 1.) * chord - p).norm());
      };
      const double length = m_arc_lengths.back();
      // one round of a closed curve after the other; `begin` is where a round begins
      double begin = m_is_closed && length > 0 ? length * std::floor(from / length) : 0;
      for (; begin < to; begin += length)
      {
        auto next = std::upper_bound(m_arc_lengths.begin(), m_arc_lengths.end(), from - begin);
        for (; next != m_arc_lengths.end() && begin + *next < to; ++next)
          look_at(m_points[std::size_t(next - m_arc_lengths.begin())]);
        if (!m_is_closed || !(length > 0))
          break;
      }
      return largest;
    }

  private:
    struct Place
    {
      std::size_t edge;
      double share;
    };

    Place find(double arc_length) const
    {
      const double length = m_arc_lengths.back();
      if (!(length > 0))
        return Place{0, 0};
      if (m_is_closed)
        arc_length -= length * std::floor(arc_length / length);
      const auto above = std::upper_bound(m_arc_lengths.begin() + 1, m_arc_lengths.end() - 1, arc_length);
      const std::size_t i = std::size_t(above - m_arc_lengths.begin()) - 1;
      const double edge = m_arc_lengths[i + 1] - m_arc_lengths[i];
      return Place{i, edge > 0 ? (std::min)((std::max)((arc_length - m_arc_lengths[i]) / edge, 0.), 1.) : 0.};
    }

    bool is_corner(const std::size_t i) const { return !m_is_closed && (i == 0 || i + 1 == m_points.size()); }

    // the rotation at a point: its axis, with its angle as the length; zero at a corner
    Vector turn(const std::size_t i) const
    {
      if (is_corner(i))
        return Vector::Zero();
      const std::size_t last = m_points.size() - 1;
      const Vector &before = m_points[i == 0 ? last - 1 : i - 1], &behind = m_points[i == last ? 1 : i + 1];
      const Vector one = m_points[i] - before, other = behind - m_points[i], axis = one.cross(other);
      return axis.norm() > 0 ? Vector(std::atan2(axis.norm(), one.dot(other)) * axis.normalized()) : Vector(Vector::Zero());
    }

    std::vector<Vector> m_points; // a closed curve has its first point again at the end
    std::vector<double> m_arc_lengths;
    bool m_is_closed;
  };

  // the plane of a border at one of its edges, by the edges around it, also beyond corners
  template <typename Mesh>
  static Curve_plane border_plane(const Halfedge_index h, const Mesh& mesh)
  {
    std::array<Vector, 6> points;
    Halfedge_index g = mesh.prev(mesh.prev(h));
    for (Vector& p : points)
    {
      p = mesh.point(mesh.source(g)).point;
      g = mesh.next(g);
    }
    return curve_plane(points);
  }

  // whether the border goes from one plane into another where h ends
  template <typename Mesh>
  static bool is_between_planes(const Halfedge_index h, const Mesh& mesh)
  {
    static constexpr double largest_cosine = 0.87; // of 30 degrees
    const Curve_plane one = border_plane(h, mesh), other = border_plane(mesh.next(h), mesh);
    return one.is_exact && other.is_exact && std::abs(one.normal.dot(other.normal)) < largest_cosine;
  }

  template <typename Mesh>
  Border_corner border_corner_at(const Halfedge_index before, const Mesh& mesh) const
  {
    static constexpr double least_sine = 0.17; // of 10 degrees: planes that meet at less are one
    const Curve_plane one = border_plane(before, mesh), other = border_plane(mesh.next(before), mesh);
    Border_corner result;
    result.point = mesh.point(mesh.target(before)).point;
    result.way.reach = reach(one, other);
    result.way.one = one.normal;
    const Vector rest = other.normal - other.normal.dot(one.normal) * one.normal;
    if (rest.norm() > least_sine)
      result.way.other = rest.normalized();
    return result;
  }

  // A point may go half as far as the edges around are long, or as those of the border are in the mean, if that is more: there may be
  // tiny edges.
  double reach(const Curve_plane& one, const Curve_plane& other) const
  {
    return 0.5 * (std::max)({one.longest_edge, other.longest_edge, m_mean_border_edge});
  }

  static bool is_named_later(const Curve_arc& arc) { return arc.curve == Curve_arc::unnamed; }

  // The number of edges on curves at each vertex. An edge that must not be touched counts as three: so its ends are never inner
  // vertices of a curve.
  template <typename Mesh>
  static std::vector<int> curve_degrees(const Mesh& mesh)
  {
    std::vector<int> degrees(vertex_capacity(mesh), 0);
    for (const Halfedge_index h : mesh.halfedges())
    {
      const int curve = mesh.arc(h).curve;
      if (curve != Curve_arc::none)
        degrees[mesh.target(h)] += curve == Curve_arc::untouchable ? 3 : 1;
    }
    return degrees;
  }

  // whether the curve turns sharply at a vertex that has two edges on curves
  template <typename Mesh>
  static bool is_sharp(const Vertex_index v, const Mesh& mesh)
  {
    Halfedge_index in = mesh.halfedge(v);
    while (!mesh.is_on_curve(mesh.edge(in)))
      in = mesh.prev(mesh.opposite(in));
    const Vector& p = mesh.point(v).point;
    const Vector before = p - mesh.point(mesh.source(in)).point;
    const Vector behind = mesh.point(mesh.target(next_on_curve(in, mesh))).point - p;
    return std::atan2(before.cross(behind).norm(), before.dot(behind)) > corner_angle;
  }

  // traces a curve from the source of `first` to the next corner, or once around
  template <typename Mesh>
  void trace(const Halfedge_index first, Mesh& mesh, std::vector<char>& is_traced)
  {
    std::vector<Halfedge_index> halfedges(1, first);
    std::vector<Vector> points{mesh.point(mesh.source(first)).point, mesh.point(mesh.target(first)).point};
    while (!mesh.point(mesh.target(halfedges.back())).is_fixed)
    {
      const Halfedge_index h = next_on_curve(halfedges.back(), mesh);
      if (h == first)
        break;
      halfedges.push_back(h);
      points.push_back(mesh.point(mesh.target(h)).point);
    }
    const int curve = int(m_curves.size());
    m_curves.emplace_back(std::move(points), !mesh.point(mesh.source(first)).is_fixed);
    const std::vector<double>& arc_lengths = m_curves.back().arc_lengths();
    for (std::size_t i = 0; i < halfedges.size(); ++i)
    {
      mesh.set_arc(halfedges[i], Curve_arc{curve, arc_lengths[i], arc_lengths[i + 1]});
      is_traced[mesh.edge(halfedges[i])] = 1;
    }
  }

  std::vector<Curve> m_curves;
  std::vector<Vertex_index> m_turns; // the corners at which one curve turns
  // if borders are projected: the planes of the edges of the curves, none for other curves; the corners by their numbers in the input
  std::vector<std::vector<Curve_plane>> m_border_planes;
  std::map<std::uint32_t, Border_corner> m_corners;
  double m_mean_border_edge = 0;
  bool m_projects_borders = false;
  double m_largest_deviation = (std::numeric_limits<double>::infinity)();
  bool m_may_collapse = true, m_may_smooth = true;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_NETWORK_H
