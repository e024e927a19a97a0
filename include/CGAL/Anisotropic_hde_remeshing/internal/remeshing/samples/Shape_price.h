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
  static constexpr double largest_multiple = 6;

public:
  // A ratio of the longest edge to the altitude above `free_ratio` costs `price` mean errors of a face for each such ratio more.
  Shape_price(const double price, const double free_ratio, const double largest_ratio)
    : m_price(price), m_free_ratio(free_ratio), m_largest_ratio(largest_ratio)
  {
  }

  void set_mean_cost(const double mean_cost) { m_mean_cost = mean_cost; }
  double mean_cost() const { return m_mean_cost; }
  double free_ratio() const { return m_free_ratio; }
  double largest_ratio() const { return m_largest_ratio; }

  double operator()(const Space_triangle& t) const
  {
    return m_price * m_mean_cost * (std::min)(largest_multiple, (std::max)(0., t.ratio() / m_free_ratio - 1));
  }

private:
  double m_price, m_free_ratio, m_largest_ratio;
  double m_mean_cost = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_SHAPE_PRICE_H
