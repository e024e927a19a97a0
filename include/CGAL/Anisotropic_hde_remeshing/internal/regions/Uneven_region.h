// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_UNEVEN_REGION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_UNEVEN_REGION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Machine parts have triangles that are long along the axis of a cylinder and short around it. An interpolant knows no axis: it
// bulges between points at such uneven distances. So such a region is sampled more densely. The points are on cubic curves over
// its long edges, which follow from the normals at the ends.
class Uneven_region
{
  typedef Region_mesh::Vertex_index Vertex_index;
  typedef Region_mesh::Halfedge_index Halfedge_index;
  typedef Region_mesh::Edge_index Edge_index;
  typedef Simple_cartesian<double>::Vector_3 Normal;

  // The length of an edge over that of the short edges at its ends: an edge is long from the first ratio on, and is divided
  // into parts of the second ratio.
  static constexpr double long_ratio = 4, divided_ratio = 2;
  // the least angle, in radians, by which normals turn over the length of a long edge; less does no harm
  static constexpr double least_turn = 0.2;
  // An edge is a diagonal if the normal turns less over another edge of its faces. The bound is this share of its own turn.
  static constexpr double turn_of_side = 0.5;
  static constexpr double most_parts = 200;
  // least share of added points, relative to those of the region, for which the region is uneven
  static constexpr double least_growth = 0.1;

  struct Shape
  {
    Vector normal = Vector::Zero();
    double short_length = 0; // of the second shortest edge
    double turn = 0;         // largest turn of the normal on the way to a neighbour, in radians per unit of length
  };

public:
  typedef std::vector<std::pair<Region_mesh::Point, Normal>> Points_with_normals;

  explicit Uneven_region(const Region_mesh& mesh) : m_mesh(mesh), m_shapes(mesh.number_of_vertices())
  {
    const auto point_of = [this](const Vertex_index v) { return point(v); };
    for (const Vertex_index v : m_mesh.vertices())
    {
      double spacing;
      normal_and_spacing(v, m_mesh, point_of, m_shapes[v].normal, spacing);
    }
    for (const Vertex_index v : m_mesh.vertices())
      measure(v);
  }

  // the added points with those of the vertices; none if the region is even
  Points_with_normals points() const
  {
    Points_with_normals result;
    for (const Vertex_index v : m_mesh.vertices())
      result.emplace_back(m_mesh.point(v), Normal(m_shapes[v].normal[0], m_shapes[v].normal[1], m_shapes[v].normal[2]));
    for (const Edge_index e : m_mesh.edges())
      if (is_long(e) && !is_diagonal(e))
        divide(e, result);
    if (double(result.size()) < (1 + least_growth) * double(m_mesh.number_of_vertices()))
      result.clear();
    return result;
  }

private:
  Vector point(const Vertex_index v) const { return to_vector(m_mesh.point(v)); }

  const Shape& shape(const Edge_index e, const unsigned int end) const { return m_shapes[m_mesh.vertex(e, end)]; }

  double length(const Edge_index e) const { return (point(m_mesh.vertex(e, 1)) - point(m_mesh.vertex(e, 0))).norm(); }

  void measure(const Vertex_index v)
  {
    std::array<double, 2> shortest{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const Vertex_index w : vertices_around_target(v, m_mesh))
    {
      const double distance = (point(w) - point(v)).norm();
      if (distance > 0)
        m_shapes[v].turn = (std::max)(m_shapes[v].turn, angle_between(m_shapes[v].normal, m_shapes[w].normal) / distance);
      shortest[1] = (std::min)(shortest[1], (std::max)(shortest[0], distance));
      shortest[0] = (std::min)(shortest[0], distance);
    }
    m_shapes[v].short_length = shortest[1];
  }

  bool is_long(const Edge_index e) const
  {
    const Shape &a = shape(e, 0), &b = shape(e, 1);
    return length(e) > long_ratio * (std::min)(a.short_length, b.short_length) &&
           length(e) * (std::max)(a.turn, b.turn) > least_turn;
  }

  bool is_diagonal(const Edge_index e) const
  {
    const double turn = turn_of_side * angle_between(shape(e, 0).normal, shape(e, 1).normal);
    for (const unsigned int side : {0, 1})
    {
      const Halfedge_index h = m_mesh.halfedge(e, side);
      if (m_mesh.is_border(h))
        continue;
      for (const Edge_index other : {m_mesh.edge(m_mesh.next(h)), m_mesh.edge(m_mesh.prev(h))})
        if (is_long(other) && angle_between(shape(other, 0).normal, shape(other, 1).normal) < turn)
          return true;
    }
    return false;
  }

  // Adds points of the cubic curve from a to b. Its directions at the ends are that of the edge, projected to the tangent
  // planes there.
  void divide(const Edge_index e, Points_with_normals& result) const
  {
    const Shape &s = shape(e, 0), &t = shape(e, 1);
    const Vector a = point(m_mesh.vertex(e, 0)), b = point(m_mesh.vertex(e, 1)), way = b - a;
    const double step =
        (std::max)(divided_ratio * (std::min)(s.short_length, t.short_length), least_turn / (std::max)(s.turn, t.turn));
    const double parts = (std::min)(most_parts, std::ceil(way.norm() / step));
    const bool is_curved = angle_between(s.normal, t.normal) < 1;
    const Vector after_a = a + (is_curved ? Vector(way - way.dot(s.normal) * s.normal) : way) / 3;
    const Vector before_b = b - (is_curved ? Vector(way - way.dot(t.normal) * t.normal) : way) / 3;
    for (double i = 1; i < parts; ++i)
    {
      const double u = i / parts, w = 1 - u;
      const Vector p = w * w * w * a + 3 * u * w * w * after_a + 3 * u * u * w * before_b + u * u * u * b;
      const Vector n = (w * s.normal + u * t.normal).normalized();
      result.emplace_back(Region_mesh::Point(p[0], p[1], p[2]), Normal(n[0], n[1], n[2]));
    }
  }

  const Region_mesh& m_mesh;
  std::vector<Shape> m_shapes; // by vertex
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_UNEVEN_REGION_H
