// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_EMBEDDED_TRIANGLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_EMBEDDED_TRIANGLE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A triangle in the embedding is given by the squared lengths of its edges. Its area and angles follow from them.
namespace Embedded_triangle {

// by Heron's formula; 0 where the lengths of a curved embedding violate the triangle inequality
inline double area(const double x, const double y, const double z)
{
  const double squared = 2 * (x * y + y * z + z * x) - (x * x + y * y + z * z);
  return squared > 0 ? 0.25 * std::sqrt(squared) : 0;
}

// the cosine of the smallest angle, which is opposite to the shortest edge
inline double largest_cosine(const double x, const double y, const double z)
{
  const double shortest = (std::min)({x, y, z});
  const double product = shortest == x ? y * z : shortest == y ? x * z : x * y;
  return product > 0 ? 0.5 * (x + y + z - 2 * shortest) / std::sqrt(product) : 1.;
}

} // namespace Embedded_triangle

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_EMBEDDED_TRIANGLE_H
