// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FAR_FIELD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FAR_FIELD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Coarse_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Coarse_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What the function is far from the data of a sample with holes. The share of all directions in which a place sees the inside
// of the coarse surface (the winding number, a harmonic field) tells what is certainly inside, certainly outside, or neither.
// The latter is a band that spans the holes. In it the coarse interpolant goes on smoothly from the rims. The winding number
// vanishes far away, so the zero set is bounded. "Far" is measured in radii of the parts of the coarse surface, which grow with
// the distance to the rim. So the function near the data, and wherever the data are nearer than the rim, is left as it is.
class Far_field
{
  static constexpr double least_begin = 1, excess_over_data = 1.1; // of the blend, in units of the radius of the parts
  static constexpr double width = 2;                               // of the blend: its end over its begin
  // shares of all directions; half of them are in the plane of a flat hole
  static constexpr double begin_of_inside = 0.65, end_of_inside = 0.85, begin_of_outside = 0.35, end_of_outside = 0.15;
  // of all that is negative, in units of half the diagonal of the box
  static constexpr double begin_of_end = 1.25, end_of_end = 1.45;

public:
  static constexpr double radius_of_sphere = 1.5; // in the same unit; the function is positive on the sphere about the origin

  template <typename ConcurrencyTag>
  Far_field(const ConcurrencyTag tag, const Surface_sample& sample, const std::vector<std::size_t>& rim,
            const double half_diagonal, Interruption& interruption)
    : Far_field(sample, Coarse_surface(tag, sample, rim, interruption), half_diagonal)
  {
    m_begin = (std::max)(least_begin, excess_over_data * largest_distance_of_data<ConcurrencyTag>(sample, interruption));
  }

  // `near` returns the function near the data
  template <int order, typename Near>
  Jet<order> blend(const Vector& p, const Near& near) const
  {
    const Jet<order> weight = weight_of_far<order>(p);
    Jet<order> result;
    if (!(weight.value > 0))
      result = near();
    else if (weight.value < 1)
      result = interpolated(near(), closing_field<order>(p), weight);
    else
      result = closing_field<order>(p);
    const Jet<order> edge = step(squared_length<order>(p), begin_of_end, end_of_end);
    return edge.value > 0 ? interpolated(result, smooth_distance<order>(p), edge) : result;
  }

  std::size_t memory_bytes() const { return m_parts.size() * sizeof(Part) + m_interpolant.memory_bytes(); }

private:
  struct Part
  {
    Vector centre, area_normal; // the latter over 4 pi
    double weight_of_radius, weight_of_area;
  };

  static constexpr double smallest_squared_distance = 1e-24; // coordinates are below 1

  Far_field(const Surface_sample& sample, const Coarse_surface& surface, const double half_diagonal)
    : m_interpolant(sample, surface), m_half_diagonal(half_diagonal)
  {
    double area = 0;
    for (const Coarse_surface::Part& part : surface.parts())
      area += part.area;
    for (const Coarse_surface::Part& part : surface.parts())
      m_parts.push_back({part.centre, part.area_normal / (4 * CGAL_PI), part.area * std::pow(part.radius, 4) * 2 / CGAL_PI,
                         part.area / area});
  }

  // the sum of weight / |way|^6 over the parts
  template <int order>
  Jet<order> sum_of_inverse_powers(const Vector& p, double Part::*const weight) const
  {
    Jet<order> sum;
    for (const Part& part : m_parts)
    {
      const Vector way = p - part.centre;
      const double inverse = 1 / (std::max)(way.squaredNorm(), smallest_squared_distance);
      const double power = part.*weight * inverse * inverse * inverse;
      sum.value += power;
      if constexpr (order >= 1)
        sum.gradient -= 6 * power * inverse * way;
      if constexpr (order >= 2)
        sum.hessian += power * inverse * (48 * inverse * way * way.transpose() - 6 * Matrix::Identity());
    }
    return sum;
  }

  // 0 where the function is as without this, 1 where only the closing field counts
  template <int order>
  Jet<order> weight_of_far(const Vector& p) const
  {
    const Jet<order> sum = sum_over_radii<order>(p);
    const double distance = distance_over_radii(sum.value), end = width * m_begin;
    if (!(distance > m_begin))
      return Jet<order>();
    if (distance >= end)
      return constant<order>(1);
    return step(composed(distance, -distance / (4 * sum.value), 5 * distance / (16 * sum.value * sum.value), sum), m_begin,
                end);
  }

  // Over a plane it is the inverse of the fourth power of the distance over the radius of the parts. The integral of r^-6 over
  // a plane at distance d is pi / (2 d^4).
  template <int order>
  Jet<order> sum_over_radii(const Vector& p) const
  {
    return sum_of_inverse_powers<order>(p, &Part::weight_of_radius);
  }

  static double distance_over_radii(const double sum) { return 1 / std::sqrt(std::sqrt(sum)); }

  // The function is left as it is at the data.
  template <typename ConcurrencyTag>
  double largest_distance_of_data(const Surface_sample& sample, Interruption& interruption) const
  {
    const std::size_t n = sample.size();
    std::vector<double> distances(n + sample.facets.size());
    parallel_for<ConcurrencyTag>(
        distances.size(),
        [&](const std::size_t i)
        {
          Vector p;
          if (i < n)
            p = sample.points[i];
          else
          {
            const Facet& facet = sample.facets[i - n];
            p = (sample.points[facet[0]] + sample.points[facet[1]] + sample.points[facet[2]]) / 3;
          }
          distances[i] = distance_over_radii(sum_over_radii<0>(p).value);
        },
        64, interruption);
    interruption.check();
    return *std::max_element(distances.begin(), distances.end());
  }

  template <int order>
  static Jet<order> constant(const double value)
  {
    Jet<order> result;
    result.value = value;
    return result;
  }

  // from 0 at `first` to 1 at `last`, which may be less
  template <int order>
  static Jet<order> step(const Jet<order>& x, const double first, const double last)
  {
    const double t = (x.value - first) / (last - first);
    if (!(t > 0))
      return Jet<order>();
    if (t >= 1)
      return constant<order>(1);
    return smoothstep(composed(t, 1 / (last - first), 0., x));
  }

  // the length over half the diagonal of the box
  template <int order>
  Jet<order> squared_length(const Vector& p) const
  {
    Jet<order> square;
    square.value = p.squaredNorm() / (m_half_diagonal * m_half_diagonal);
    if constexpr (order >= 1)
      square.gradient = 2 / (m_half_diagonal * m_half_diagonal) * p;
    if constexpr (order >= 2)
      square.hessian = 2 / (m_half_diagonal * m_half_diagonal) * Matrix::Identity();
    const double length = std::sqrt(square.value);
    return length > 0 ? composed(length, 0.5 / length, -0.25 / (length * square.value), square) : Jet<order>();
  }

  // a mean of the distances to the parts, most of which is the nearest; positive, smooth, and grows as the distance far away
  template <int order>
  Jet<order> smooth_distance(const Vector& p) const
  {
    const Jet<order> sum = sum_of_inverse_powers<order>(p, &Part::weight_of_area);
    const double distance = std::pow(sum.value, -1. / 6);
    return composed(distance, -distance / (6 * sum.value), 7 * distance / (36 * sum.value * sum.value), sum);
  }

  template <int order>
  Jet<order> winding_number(const Vector& p) const
  {
    Jet<order> result;
    for (const Part& part : m_parts)
    {
      const Vector way = p - part.centre;
      const double inverse = 1 / way.squaredNorm(), cube = inverse * std::sqrt(inverse);
      const double along = part.area_normal.dot(way);
      result.value -= along * cube;
      if constexpr (order >= 1)
        result.gradient += cube * (3 * along * inverse * way - part.area_normal);
      if constexpr (order >= 2)
      {
        const Matrix mixed = part.area_normal * way.transpose();
        result.hessian +=
            3 * cube * inverse *
            (mixed + mixed.transpose() + along * Matrix::Identity() - 5 * along * inverse * way * way.transpose());
      }
    }
    return result;
  }

  template <int order>
  Jet<order> closing_field(const Vector& p) const
  {
    const Jet<order> winding = winding_number<order>(p);
    const Jet<order> inside = step(winding, begin_of_inside, end_of_inside),
                     outside = step(winding, begin_of_outside, end_of_outside);
    Jet<order> result;
    if (!m_interpolant.is_solved())
      result = composed((0.5 - winding.value) * m_half_diagonal, -m_half_diagonal, 0., winding);
    else if (inside.value < 1 && outside.value < 1)
      result = m_interpolant.template evaluate<order>(p);
    if (!(inside.value > 0 || outside.value > 0))
      return result;
    const Jet<order> distance = smooth_distance<order>(p);
    if (inside.value > 0)
      return interpolated(result, composed(-distance.value, -1., 0., distance), inside);
    return interpolated(result, distance, outside);
  }

  std::vector<Part> m_parts;
  Coarse_interpolant m_interpolant;
  double m_half_diagonal;
  double m_begin = least_begin; // of the blend
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_FAR_FIELD_H
