// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_DISTANCE_AT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_DISTANCE_AT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>

#include <optional>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

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

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_DISTANCE_AT_H
