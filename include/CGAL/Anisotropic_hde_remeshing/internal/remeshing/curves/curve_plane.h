// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_PLANE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_PLANE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The plane in which a polyline runs at one of its edges.
struct Curve_plane
{
  Vector normal = Vector::Zero(); // of length 1; zero where the polyline is straight
  bool is_exact = false;          // whether the edges are in it, as where a plane has cut the surface
  double longest_edge = 0;        // of the edges around
};

struct Plane_of_points
{
  Vector normal = Vector::Zero();
  double distance = 0; // the largest one of a point
  double height = 0;   // about that of the turns
};

// The unit normal of the plane of some points in a row; zero if they are in a line. The turns of a polyline that waves in a plane look to
// both sides of the plane: those against the largest one count with the opposite sign.
inline Plane_of_points plane_of_points(const std::vector<Vector>& points)
{
  static constexpr double smallest_turn = 1e-3; // in radians, about
  Vector largest = Vector::Zero(), sum = Vector::Zero();
  double scale = 0, longest = 0;
  for (const bool is_second_round : {false, true})
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      const Vector before = points[i] - points[i - 1], behind = points[i + 1] - points[i], turn = before.cross(behind);
      if (is_second_round)
        sum += turn.dot(largest) < 0 ? Vector(-turn) : turn;
      else if (turn.squaredNorm() > largest.squaredNorm())
        largest = turn;
      scale += 0.5 * before.norm() * behind.norm();
      longest = (std::max)({longest, before.norm(), behind.norm()});
    }
  if (!(sum.norm() > smallest_turn * scale))
    return Plane_of_points();
  Plane_of_points result;
  result.normal = sum.normalized();
  result.height = sum.norm() / longest;
  for (const Vector& p : points)
    result.distance = (std::max)(result.distance, std::abs(result.normal.dot(p - points.front())));
  return result;
}

// The plane of the edge in the middle. Of the groups of three edges with it, the one that is nearest to plane counts: where the polyline
// turns from one plane into another, the edge is in one of them.
inline Curve_plane curve_plane(const std::array<Vector, 6>& points)
{
  static constexpr double largest_distance = 0.01; // of an exact plane, over the height of the turns
  Curve_plane result;
  double least = (std::numeric_limits<double>::infinity)();
  for (std::size_t first = 0; first < 3; ++first)
  {
    const Plane_of_points plane = plane_of_points(std::vector<Vector>(points.begin() + first, points.begin() + first + 4));
    if (plane.normal.isZero(0) || plane.distance >= least)
      continue;
    least = plane.distance;
    result.normal = plane.normal;
    result.is_exact = plane.distance <= largest_distance * plane.height;
  }
  for (std::size_t i = 1; i < points.size(); ++i)
    result.longest_edge = (std::max)(result.longest_edge, (points[i] - points[i - 1]).norm());
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_CURVES_CURVE_PLANE_H
