// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_POINTS_ON_ZERO_SET_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_POINTS_ON_ZERO_SET_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

struct Oriented_point
{
  Vector point, normal;
};

// goes along the gradient to the zero set, up to `exactness`, and no further than `reach`
template <typename Function>
std::optional<Oriented_point> point_on_zero_set(const Function& function, const Vector& start, const double exactness,
                                                const double reach)
{
  static constexpr int newton_steps = 20;
  Vector p = start;
  for (int step = 0; step < newton_steps; ++step)
  {
    const Value_and_gradient at_p = value_and_gradient_of(function, p);
    const double slope = at_p.gradient.norm();
    if (!(slope > 0))
      return std::nullopt;
    const Vector normal = at_p.gradient / slope;
    const double way = at_p.value / slope;
    p -= way * normal;
    if (!((p - start).norm() <= reach)) // not even if it is no number
      return std::nullopt;
    if (std::abs(way) <= exactness)
      return Oriented_point{p, normal};
  }
  return std::nullopt;
}

// those that are found, in the order of the starts
template <typename ConcurrencyTag, typename Function>
std::vector<Oriented_point> points_on_zero_set(const Function& function, const std::vector<Vector>& starts,
                                               const double exactness, const double reach, Interruption& interruption)
{
  std::vector<std::optional<Oriented_point>> found(starts.size());
  parallel_for<ConcurrencyTag>(
      starts.size(), [&](const std::size_t i) { found[i] = point_on_zero_set(function, starts[i], exactness, reach); }, 64,
      interruption);
  interruption.check();
  std::vector<Oriented_point> result;
  for (const std::optional<Oriented_point>& p : found)
    if (p)
      result.push_back(*p);
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_POINTS_ON_ZERO_SET_H
