// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_UNBOUNDED_INTERPOLANT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_UNBOUNDED_INTERPOLANT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Distance_to_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Far_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The interpolant of a sample, closed where the sample has holes, up to infinity. Without a hole it is the interpolant alone.
template <typename Interpolant>
class Unbounded_interpolant
{
  static constexpr double radius_of_sphere = 1.1; // over half the diagonal of the box: the zero set bulges between the points
  static constexpr double reach = 1e6;            // the interpolant is evaluated up to here, in the size of the points

public:
  explicit Unbounded_interpolant(std::unique_ptr<const Interpolant> interpolant)
    : m_interpolant(std::move(interpolant)),
      m_half_diagonal(half_diagonal(m_interpolant->sample())),
      m_distance_to_data(m_interpolant->sample().points, number_of_given_points(m_interpolant->sample()))
  {
  }

  // closes the holes of the sample that the interpolant is of
  template <typename ConcurrencyTag>
  void close_holes(const ConcurrencyTag tag, Interruption& interruption)
  {
    const Surface_sample& sample = m_interpolant->sample();
    if (sample.number_of_holes > 0)
    {
      m_number_of_holes = sample.number_of_holes;
      m_far_field.emplace(tag, sample, sample.rim, m_half_diagonal, interruption);
    }
    else if ((!sample.open_ends.empty() || sample.facets.empty()) && has_both_signs_on_sphere())
    {
      m_number_of_holes = (std::max)(sample.number_of_open_ends, std::size_t(1));
      m_far_field.emplace(tag, sample, sample.open_ends, m_half_diagonal, interruption);
    }
  }

  template <int order>
  Jet<order> evaluate(const Vector& p) const
  {
    if (!(p.squaredNorm() <= reach * reach))
      return evaluate_beyond_reach<order>(p);
    return evaluate_within_reach<order>(p);
  }

  double distance_to_data(const Vector& p) const
  {
    if (p.squaredNorm() <= reach * reach)
      return m_distance_to_data(p);
    const Vector way = limited(p);
    const double length = way.stableNorm();
    return m_distance_to_data(reach / length * way) + (length - reach);
  }

  // the zero set is within it
  double radius() const { return (m_far_field ? Far_field::radius_of_sphere : radius_of_sphere) * m_half_diagonal; }

  std::size_t number_of_holes() const { return m_number_of_holes; }
  std::size_t memory_bytes() const { return m_far_field ? m_far_field->memory_bytes() : 0; }

  const Interpolant& interpolant() const { return *m_interpolant; }

private:
  static std::size_t number_of_given_points(const Surface_sample& sample)
  {
    return sample.size() - sample.number_of_points_on_facets;
  }

  template <int order>
  Jet<order> evaluate_within_reach(const Vector& p) const
  {
    const auto near = [&] { return m_interpolant->template evaluate<order>(p); };
    return m_far_field ? m_far_field->template blend<order>(p, near) : near();
  }

  // Beyond its reach the function has its value at the end of the reach in the same direction, plus the way from there. The
  // distances to single facets differ too little out there, and in the end the squares of coordinates overflow.
  template <int order>
  Jet<order> evaluate_beyond_reach(const Vector& p) const
  {
    const Vector way = limited(p);
    const double length = way.stableNorm();
    Jet<order> result = evaluate_within_reach<order>(reach / length * way);
    result.value += std::copysign(length - reach, result.value);
    return result;
  }

  static Vector limited(const Vector& p)
  {
    const double largest = (std::numeric_limits<double>::max)() / 2;
    return p.cwiseMin(largest).cwiseMax(-largest);
  }

  // A surface without an end has one sign around it.
  bool has_both_signs_on_sphere() const
  {
    static constexpr int number_of_places = 200;
    const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
    bool has_negative = false, has_positive = false;
    for (int i = 0; i < number_of_places && !(has_negative && has_positive); ++i)
    {
      const double z = (2. * i + 1) / number_of_places - 1, r = std::sqrt(1 - z * z);
      const Vector direction(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z);
      const double value = m_interpolant->template evaluate<0>(Far_field::radius_of_sphere * m_half_diagonal * direction).value;
      (value < 0 ? has_negative : has_positive) = true;
    }
    return has_negative && has_positive;
  }

  std::unique_ptr<const Interpolant> m_interpolant;
  double m_half_diagonal;
  Distance_to_points m_distance_to_data;
  std::optional<Far_field> m_far_field;
  std::size_t m_number_of_holes = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_UNBOUNDED_INTERPOLANT_H
