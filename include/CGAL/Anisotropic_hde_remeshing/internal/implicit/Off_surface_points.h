// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_OFF_SURFACE_POINTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_OFF_SURFACE_POINTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Blending_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The offset eps_i of every off-surface point x_i + eps_i n_i (the paper's (12)). If both sides are asked for, there is also
// that of the inner point, x_i - eps_i n_i. An offset is halved while the off-surface point is nearer to another point of the
// surface than to x_i. There its distance to the surface is not eps_i, and the constraint would make a sheet that the surface
// does not have. An offset of 0 means that x_i has no off-surface point on that side.
template <typename ConcurrencyTag>
class Off_surface_points
{
  static constexpr int largest_number_of_halvings = 8;

public:
  // `relative_offset` is in units of the local spacing; a positive `absolute_offset` replaces it
  Off_surface_points(const Surface_sample& sample, const Blending_tree& tree, const double relative_offset,
                     const double absolute_offset, const bool on_both_sides, Interruption& interruption)
    : m_outer(sample.size(), 0.), m_inner(on_both_sides ? sample.size() : 0, 0.), m_is_shortened(sample.size(), 0)
  {
    parallel_for<ConcurrencyTag>(
        tree.leaves().size(),
        [&](const std::size_t k)
        {
          const Blending_tree::Leaf& leaf = tree.leaves()[k];
          for (const std::size_t i : leaf.own_points)
          {
            const double offset = absolute_offset > 0 ? absolute_offset : relative_offset * sample.spacings[i];
            m_outer[i] = valid_offset(sample, leaf, i, offset, 1);
            m_is_shortened[i] = m_outer[i] != offset && !sample.is_on_edge_of_surface(i);
            if (!on_both_sides)
              continue;
            m_inner[i] = valid_offset(sample, leaf, i, offset, -1);
            m_is_shortened[i] = m_is_shortened[i] || (m_inner[i] != offset && !sample.is_on_edge_of_surface(i));
          }
        },
        1, interruption);
    interruption.check();
  }

  double outer(const std::size_t i) const { return m_outer[i]; }
  double inner(const std::size_t i) const { return m_inner.empty() ? 0. : m_inner[i]; }

  std::size_t number_of_shortened_offsets() const
  {
    return std::size_t(std::count(m_is_shortened.begin(), m_is_shortened.end(), char(1)));
  }

private:
  static double valid_offset(const Surface_sample& sample, const Blending_tree::Leaf& leaf, const std::size_t i, double offset,
                             const double side)
  {
    if (!sample.has_side(i))
      return 0;
    for (int halving = 0; halving <= largest_number_of_halvings; ++halving, offset *= 0.5)
      if (is_nearest(sample, leaf, i, side * offset))
        return offset;
    return 0;
  }

  static bool is_nearest(const Surface_sample& sample, const Blending_tree::Leaf& leaf, const std::size_t i,
                         const double offset)
  {
    const Vector p = sample.points[i] + offset * sample.normals[i];
    for (const std::size_t j : leaf.points)
      if (j != i && (p - sample.points[j]).squaredNorm() <= offset * offset)
        return false;
    return true;
  }

  std::vector<double> m_outer, m_inner; // m_inner is empty for one side
  std::vector<char> m_is_shortened;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_OFF_SURFACE_POINTS_H
