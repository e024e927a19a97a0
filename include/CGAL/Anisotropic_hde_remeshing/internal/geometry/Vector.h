// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_VECTOR_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_VECTOR_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the numbers in which both halves of the package compute, for any kernel of the caller
typedef Eigen::Vector3d Vector;
typedef Eigen::Matrix3d Matrix;

// the point or vector of the caller in plain numbers
template <typename Point_or_vector>
Vector to_vector(const Point_or_vector& p)
{
  return Vector(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// The same; throws if it is not finite, or not below a bound. The usual bound is far below the largest double, so that no square
// of a difference overflows.
template <typename Point_or_vector>
Vector finite_vector(const Point_or_vector& p, const char* what, const std::size_t index, const double bound = 1e150)
{
  Vector result = to_vector(p);
  if (!(result.array().abs() < bound).all())
  {
    std::ostringstream message;
    message << "the " << what << " of vertex " << index << " is (" << result.transpose() << "): its coordinates must be finite";
    if (std::isfinite(bound))
      message << " and below " << bound;
    throw std::invalid_argument(message.str());
  }
  return result;
}

template <typename Vector_3>
Vector unit_normal(const Vector_3& normal, const std::size_t index)
{
  return finite_vector(normal, "normal", index).stableNormalized();
}

// in radians. CGAL::approximate_angle() takes an arc cosine, which loses half of the digits of a small angle.
inline double angle_between(const Vector& u, const Vector& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); }

inline double diagonal_of(const Bbox_3& box)
{
  return Vector(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()).stableNorm();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_VECTOR_H
