// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SHAPE_PRICE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SHAPE_PRICE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>

#include <algorithm>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What the shape of a face costs, in mean errors of a face: so long triangles stand where they pay and nowhere else.
class Shape_price
{
  static constexpr double usual_free_ratio = 4, usual_largest_ratio = 40, share_of_bound = 0.8;
  static constexpr double largest_multiple = 6;                            // of the free ratio
  static constexpr double weight_beyond = 50, largest_multiple_beyond = 3; // of the bound that is asked for

public:
  // Ratios are those of the longest edge to the altitude over it. A ratio costs nothing up to 4, or up to a bit less than the bound
  // that is asked for, and `weight` mean errors of a face for each such ratio more. Beyond the bound it is dear. `bound` is 0 if none is
  // asked for.
  Shape_price(const double weight, const double bound)
    : m_weight(weight),
      m_weight_beyond(bound > 0 ? weight_beyond : 0.),
      m_free_ratio(bound > 0 ? (std::min)(usual_free_ratio, share_of_bound * bound) : usual_free_ratio),
      m_largest_ratio(bound > 0 ? bound : usual_largest_ratio)
  {
  }

  void set_mean_cost(const double mean_cost) { m_mean_cost = mean_cost; }
  double mean_cost() const { return m_mean_cost; }
  double free_ratio() const { return m_free_ratio; }
  // no operation leaves a face with more, unless it had more before
  double largest_ratio() const { return m_largest_ratio; }

  double operator()(const Space_triangle& t) const
  {
    const double ratio = t.ratio();
    return m_mean_cost * (m_weight * multiple(ratio / m_free_ratio, largest_multiple) +
                          m_weight_beyond * multiple(ratio / m_largest_ratio, largest_multiple_beyond));
  }

private:
  static double multiple(const double ratio, const double largest) { return (std::min)(largest, (std::max)(0., ratio - 1)); }

  double m_weight, m_weight_beyond, m_free_ratio, m_largest_ratio;
  double m_mean_cost = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SHAPE_PRICE_H
