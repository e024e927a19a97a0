// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_SPACE_TRIANGLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_SPACE_TRIANGLE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// a face in space, by its corners
struct Space_triangle
{
  Vector a, b, c;

  Closest_on_triangle closest(const Vector& p) const { return closest_on_triangle(p, a, b, c); }
  Vector point(const Vector& barycentric) const { return barycentric[0] * a + barycentric[1] * b + barycentric[2] * c; }
  Vector normal() const { return (b - a).cross(c - a); } // of twice the area

  // the longest edge over the altitude on it; about 1.15 for an equilateral triangle
  double ratio() const
  {
    const double longest = (std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double area = normal().norm();
    return area > 0 ? longest / area : (std::numeric_limits<double>::max)();
  }
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_SPACE_TRIANGLE_H
