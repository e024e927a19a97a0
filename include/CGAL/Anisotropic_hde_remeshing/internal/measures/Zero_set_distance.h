// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_ZERO_SET_DISTANCE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_ZERO_SET_DISTANCE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The distance of a point to the zero set of any function. Newton's method along the gradient leads to a point of the zero set.
// Steps along the tangent planes lead from there to the foot of the perpendicular. The result is the distance to a point of the
// zero set, so it is never less than the true one.
template <typename Function>
class Zero_set_distance
{
  static constexpr int newton_steps = 30, foot_steps = 8;
  static constexpr double exactness = 1e-4;     // of the distance
  static constexpr double negligible = 1e-6;    // of the size: a first step of that length needs no second one
  static constexpr double smallest_way = 1e-14; // of the size: rounding
  static constexpr double largest_shift = 0.01; // of the distance: a foot that is so far aside gives the distance to 5e-5

public:
  // `size` is that of the surface: no step is longer
  Zero_set_distance(const Function& function, const double size) : m_function(function), m_size(size) {}

  // of a point; infinite if no way leads to the zero set
  double operator()(const Vector& p) const { return from(p, p, m_size); }

  // The distance of a point that is near to another one, whose distance is known. It is at most the sum of the way to the other
  // one and its distance.
  double operator()(const Vector& p, const Vector& neighbor, const double distance_of_neighbor) const
  {
    const double way = (p - neighbor).norm(), bound = way + distance_of_neighbor;
    const double distance = from(p, p, (std::min)(bound, m_size));
    if (distance <= bound || !std::isfinite(bound))
      return distance;
    return (std::min)(bound, from(neighbor, p, (std::min)(bound, m_size)));
  }

private:
  struct Landing
  {
    Vector point, normal;
    bool is_on_zero_set;
  };

  // follows the gradient from q, in steps of at most `longest`
  Landing land(Vector q, const Vector& p, const double longest) const
  {
    for (int step = 0; step < newton_steps; ++step)
    {
      const Value_and_gradient at_q = value_and_gradient_of(m_function, q);
      const double slope = at_q.gradient.norm();
      if (at_q.value == 0)
        return Landing{q, slope > 0 ? Vector(at_q.gradient / slope) : Vector(Vector::Zero()), true};
      if (!(slope > 0) || !std::isfinite(slope) || !std::isfinite(at_q.value))
        break;
      const Vector normal = at_q.gradient / slope;
      const double way = at_q.value / slope;
      q -= (std::min)((std::max)(way, -longest), longest) * normal;
      const double tolerance = step == 0 ? negligible * m_size : (std::max)(exactness * (q - p).norm(), smallest_way * m_size);
      if (std::abs(way) <= tolerance)
        return Landing{q, normal, true};
    }
    return Landing{q, Vector::Zero(), false};
  }

  // the distance of p, by a way that begins at `start`
  double from(const Vector& start, const Vector& p, const double longest) const
  {
    Landing landing = land(start, p, longest);
    if (!landing.is_on_zero_set)
      return (std::numeric_limits<double>::infinity)();
    double distance = (landing.point - p).norm(), share = 1;
    for (int step = 0; step < foot_steps; ++step)
    {
      const Vector back = p - landing.point, shift = back - back.dot(landing.normal) * landing.normal;
      if (landing.normal.isZero(0) || shift.norm() <= largest_shift * distance)
        break;
      const Landing next = land(landing.point + share * shift, p, shift.norm());
      const double next_distance = (next.point - p).norm();
      if (next.is_on_zero_set && next_distance < distance)
      {
        landing = next;
        distance = next_distance;
      }
      else
        share /= 2; // the surface bends too much for this step
    }
    return distance;
  }

  const Function& m_function;
  const double m_size;
};

template <typename Function>
Zero_set_distance<Function> zero_set_distance(const Function& function, const double size)
{
  return Zero_set_distance<Function>(function, size);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_ZERO_SET_DISTANCE_H
