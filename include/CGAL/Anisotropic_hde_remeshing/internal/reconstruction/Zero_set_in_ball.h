// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_ZERO_SET_IN_BALL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_ZERO_SET_IN_BALL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Limited_function.h>

#include <boost/cstdint.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A straight way on which a function changes its sign.
struct Crossing_way
{
  Vector begin, end;
  double value_at_begin, value_at_end;

  Vector outward() const { return value_at_begin < 0 ? Vector(end - begin) : Vector(begin - end); }
};

// The zero set of a function in a ball: where segments, rays and lines meet it.
template <typename Function>
class Zero_set_in_ball
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // `exactness` is the length up to which zeros are found
  Zero_set_in_ball(Limited_function<Function>& function, const Vector& centre, const double squared_radius,
                   const double exactness)
    : m_function(function), m_centre(centre), m_squared_radius(squared_radius), m_exactness(exactness)
  {
  }

  // The parts in the ball, if the function has different signs at their ends. The far end of a segment may be at a great distance,
  // so that positions are exact only if they are measured from the near one.
  std::optional<Crossing_way> on_segment(const Vector& p, const Vector& q) const
  {
    return (q - m_centre).squaredNorm() < (p - m_centre).squaredNorm() ? in_ball(q, p - q, 0, 1, p)
                                                                       : in_ball(p, q - p, 0, 1, q);
  }
  std::optional<Crossing_way> on_ray(const Vector& source, const Vector& direction) const
  {
    return in_ball(source, direction, 0, infinity, source);
  }
  std::optional<Crossing_way> on_line(const Vector& point, const Vector& direction) const
  {
    return in_ball(point, direction, -infinity, infinity, point);
  }

  // a zero on the way
  Vector zero_on(const Crossing_way& way) const
  {
    const Vector direction = way.end - way.begin;
    const double least_share = 4 * std::numeric_limits<double>::epsilon();
    const double share = (std::max)(m_exactness / direction.norm(), least_share);
    boost::uintmax_t number_of_steps = 100;
    const std::pair<double, double> bracket = boost::math::tools::toms748_solve(
        [&](const double t) { return m_function.evaluate(way.begin + t * direction); }, 0., 1., way.value_at_begin,
        way.value_at_end, [share](const double low, const double high) { return high - low <= share; }, number_of_steps);
    return way.begin + 0.5 * (bracket.first + bracket.second) * direction;
  }

private:
  // `end` is the place at `last`
  std::optional<Crossing_way> in_ball(const Vector& origin, const Vector& direction, const double first, const double last,
                                      const Vector& end) const
  {
    const Vector from_centre = origin - m_centre;
    const double a = direction.squaredNorm(), b = from_centre.dot(direction),
                 discriminant = b * b - a * (from_centre.squaredNorm() - m_squared_radius);
    if (!(a > 0) || !(discriminant > 0) || !std::isfinite(discriminant))
      return std::nullopt;
    const double root = std::sqrt(discriminant), low = (-b - root) / a, high = (root - b) / a;
    const bool is_cut_at_first = !(low <= first), is_cut_at_last = !(high >= last);
    if (!((std::max)(low, first) < (std::min)(high, last)))
      return std::nullopt;
    Crossing_way way;
    way.begin = is_cut_at_first ? Vector(origin + low * direction) : origin;
    way.end = is_cut_at_last ? Vector(origin + high * direction) : end;
    way.value_at_begin = m_function(way.begin);
    way.value_at_end = m_function(way.end);
    if ((way.value_at_begin < 0) == (way.value_at_end < 0))
      return std::nullopt;
    return way;
  }

  Limited_function<Function>& m_function;
  Vector m_centre;
  double m_squared_radius, m_exactness;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_ZERO_SET_IN_BALL_H
