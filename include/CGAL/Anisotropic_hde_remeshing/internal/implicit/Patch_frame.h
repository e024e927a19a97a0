// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_FRAME_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_FRAME_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Blending_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The coordinates of a patch, y = (x - centre) / unit. In these the local spacing is 1. So the systems and the sums have the
// same size, wherever the patch is and however large it is.
struct Patch_frame
{
  Vector centre = Vector::Zero();
  double unit = 1;

  Vector operator()(const Vector& p) const { return (p - centre) / unit; }
};

// Its centre is that of the box of the points. Its unit is the median of the spacings of the points in its own cell.
inline Patch_frame frame_of(const Surface_sample& sample, const Blending_tree::Leaf& leaf)
{
  Vector low = sample.points[leaf.points.front()], high = low;
  for (const std::size_t i : leaf.points)
  {
    low = low.cwiseMin(sample.points[i]);
    high = high.cwiseMax(sample.points[i]);
  }
  std::vector<double> spacings;
  for (const std::size_t i : leaf.own_points)
    spacings.push_back(sample.spacings[i]);
  const auto median = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
  std::nth_element(spacings.begin(), median, spacings.end());
  return Patch_frame{0.5 * (low + high), *median};
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_FRAME_H
