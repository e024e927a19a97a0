// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_ON_TRIANGLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_ON_TRIANGLE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the closest point of a triangle
struct Closest_on_triangle
{
  double squared_distance;
  Vector barycentric; // of sum 1 and not negative
};

namespace closest_on_triangle_impl {

// keeps the closer one of the answer and the closest point of the side from corner i to corner j
inline void look_at_side(const Vector& p, const Vector& from, const Vector& to, const int i, const int j,
                         Closest_on_triangle& answer)
{
  const Vector side = to - from;
  const double squared_length = side.squaredNorm();
  const double t = squared_length > 0 ? (std::min)((std::max)((p - from).dot(side) / squared_length, 0.), 1.) : 0.;
  const double squared_distance = (p - from - t * side).squaredNorm();
  if (!(squared_distance < answer.squared_distance))
    return;
  answer.squared_distance = squared_distance;
  answer.barycentric.setZero();
  answer.barycentric[i] = 1 - t;
  answer.barycentric[j] = t;
}

} // namespace closest_on_triangle_impl

// CGAL's squared_distance() tells no barycentric coordinates and takes several times as long: this is the innermost loop. A
// point whose foot is outside the triangle is closest to a side beyond which the foot lies.
inline Closest_on_triangle closest_on_triangle(const Vector& p, const Vector& a, const Vector& b, const Vector& c)
{
  using closest_on_triangle_impl::look_at_side;
  const Vector u = b - a, v = c - a, w = p - a;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), wu = w.dot(u), wv = w.dot(v);
  const double determinant = uu * vv - uv * uv, s = vv * wu - uv * wv, t = uu * wv - uv * wu;
  const bool is_flat = !(determinant > 1e-12 * uu * vv); // rounding would decide
  if (!is_flat && s >= 0 && t >= 0 && s + t <= determinant)
  {
    const double x = s / determinant, y = t / determinant;
    return Closest_on_triangle{(w - x * u - y * v).squaredNorm(), Vector(1 - x - y, x, y)};
  }
  Closest_on_triangle answer{(std::numeric_limits<double>::infinity)(), Vector(1, 0, 0)};
  if (t < 0 || is_flat)
    look_at_side(p, a, b, 0, 1, answer);
  if (s + t > determinant || is_flat)
    look_at_side(p, b, c, 1, 2, answer);
  if (s < 0 || is_flat)
    look_at_side(p, c, a, 2, 0, answer);
  return answer;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_ON_TRIANGLE_H
