// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The feature curves of a mesh with marked edges: how far those of two meshes are from each other, and their corners.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CREASES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CREASES_H

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_segment_primitive_3.h>
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_segment_primitive.h>
#  include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace creases {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef std::vector<Kernel::Segment_3> Segments;

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_segment_primitive_3<Kernel, Segments::const_iterator>>> Tree;
#else
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>>> Tree;
#endif

// of the marked edges and of the boundary; none of no length
template <typename Mesh, typename EdgeMap>
Segments segments(const Mesh& mesh, const EdgeMap& is_crease)
{
  Segments result;
  for (const auto e : mesh.edges())
  {
    const Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    if ((get(is_crease, e) || mesh.is_border(e)) && p != q)
      result.emplace_back(p, q);
  }
  return result;
}

// from points of the first segments, their ends among them, to the nearest of the others
inline double largest_distance(const Segments& from, const Segments& to)
{
  static constexpr int steps = 10;
  if (from.empty() || to.empty())
    return from.empty() ? 0. : HUGE_VAL;
  const Tree tree(to.begin(), to.end());
  double largest = 0;
  for (const Kernel::Segment_3& s : from)
    for (int k = 0; k <= steps; ++k)
      largest = (std::max)(largest, tree.squared_distance(s.source() + double(k) / steps * s.to_vector()));
  return std::sqrt(largest);
}

// where marked edges end, branch or turn by more than `angle` degrees
template <typename Mesh, typename EdgeMap>
std::vector<Point_3> corners(const Mesh& mesh, const EdgeMap& is_crease, const double angle = 60)
{
  std::vector<Point_3> result;
  for (const auto v : mesh.vertices())
  {
    std::vector<Kernel::Vector_3> directions;
    if (!mesh.is_isolated(v))
      for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if (get(is_crease, mesh.edge(h)) || mesh.is_border(mesh.edge(h)))
          directions.push_back(mesh.point(mesh.source(h)) - mesh.point(v));
    if (directions.size() == 2 && CGAL::approximate_angle(directions[0], directions[1]) >= 180 - angle)
      continue;
    if (!directions.empty())
      result.push_back(mesh.point(v));
  }
  return result;
}

// how many of the points are no vertices of the mesh
template <typename Mesh>
std::size_t number_of_missing_points(const std::vector<Point_3>& points, const Mesh& mesh)
{
  std::set<Point_3> vertices;
  for (const auto v : mesh.vertices())
    vertices.insert(mesh.point(v));
  return std::size_t(std::count_if(points.begin(), points.end(), [&](const Point_3& p) { return vertices.count(p) == 0; }));
}

} // namespace creases

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_CREASES_H
