// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SIGNED_DISTANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SIGNED_DISTANCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>

#include <optional>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The signed distance to the input itself. The function is this distance far from the surface, where interpolants only
// extrapolate, and where no interpolant is good enough. The self-check judges by it, too.
class Signed_distance
{
public:
  virtual ~Signed_distance() = default;

  // the distance, negative inside, with its gradient
  virtual Value_and_gradient distance(const Vector& p) const = 0;

  // The same value, with a gradient along the interpolated normals of the input. The gradient is so long that Newton's step
  // along it ends on the input. This makes a surface whose normals do not jump.
  virtual Value_and_gradient with_interpolated_normals(const Vector& p) const = 0;
};

// The signed distance at one point. Several patches may ask for it; it is searched for once.
class Distance_at
{
public:
  Distance_at(const Signed_distance& distance, const Vector& point) : m_distance(distance), m_point(point) {}

  const Vector& point() const { return m_point; }

  const Value_and_gradient& distance()
  {
    if (!m_plain)
      m_plain = m_distance.distance(m_point);
    return *m_plain;
  }

  const Value_and_gradient& with_interpolated_normals()
  {
    if (!m_with_interpolated_normals)
      m_with_interpolated_normals = m_distance.with_interpolated_normals(m_point);
    return *m_with_interpolated_normals;
  }

private:
  const Signed_distance& m_distance;
  const Vector& m_point;
  std::optional<Value_and_gradient> m_plain, m_with_interpolated_normals;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SIGNED_DISTANCE_H
