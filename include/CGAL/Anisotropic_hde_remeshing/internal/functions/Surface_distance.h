// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_SURFACE_DISTANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_SURFACE_DISTANCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The signed distance along the gradient to the zero set of any function, by Newton's method. Its absolute value is never less
// than the distance, and differs from the distance in third order.
template <typename Function>
class Surface_distance
{
  static constexpr int newton_steps = 12;
  static constexpr double exactness = 1e-4; // of the distance

public:
  struct Answer
  {
    double distance; // negative inside; not a number where no zero is found
    Vector normal;   // of the zero set
  };

  explicit Surface_distance(const Function& function) : m_function(function) {}

  // looks no further than `largest`
  Answer operator()(const Vector& p, const double largest) const
  {
    const Answer nothing{std::numeric_limits<double>::quiet_NaN(), Vector::Zero()};
    Vector q = p;
    for (int step = 0; step < newton_steps; ++step)
    {
      Value_and_gradient at_q = value_and_gradient_of(m_function, q);
      const double slope = at_q.gradient.norm();
      if (!(slope > 0) || !std::isfinite(slope) || !std::isfinite(at_q.value))
        return nothing;
      const Vector normal = at_q.gradient / slope;
      const double way = at_q.value / slope;
      q -= way * normal;
      const double distance = (q - p).norm();
      if (!(distance <= largest))
        return nothing;
      if (std::abs(way) <= exactness * distance || !(std::abs(way) > 1e-13))
        return Answer{(p - q).dot(normal) < 0 ? -distance : distance, normal};
    }
    return nothing;
  }

private:
  const Function& m_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_SURFACE_DISTANCE_H
