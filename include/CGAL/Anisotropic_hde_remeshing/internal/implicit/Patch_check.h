// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_CHECK_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_CHECK_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The self-check of a patch. It has places on the facets of the input, or at its points if it has no facets. There the gradient
// must point outward, and the surface must be within the local spacing h. At a distance of h/4 to 2 h before and behind the
// places, the sign must be that of the distance to the input. A wrong sign means a sheet that the input does not have, or one
// that is missing. Most signs are known without a distance. The distance is asked for only where the function contradicts. Where
// another sheet of the input is nearer than that, the sign half way to it must be right.
class Patch_check
{
public:
  struct Place
  {
    Vector point, normal;
    double spacing;
  };

  // `noise` is the standard deviation of that of the points
  Patch_check(const Surface_sample& sample, const Signed_distance& input, const double noise)
    : m_sample(sample), m_input(input), m_noise(noise)
  {
  }

  // Places have numbers, four for a facet or one for a point, those on facets behind the facets. They are made when they are
  // asked for. Calls visit(number, place) for all of them: for the centre of each facet that keeps its vertices, for three more
  // in facets that are large for the points around them, and for the points if there are no facets, as for those on facets.
  // Degenerate facets have no places.
  template <typename Visitor>
  void visit_places(const Visitor& visit) const
  {
    if (m_sample.facets.empty())
      for (std::size_t i = 0; i < m_sample.size(); ++i)
        if (m_sample.has_side(i))
          visit(i, place(i));
    for (std::size_t f = 0; f < m_sample.facets.size(); ++f)
    {
      const Place centre = place(4 * f);
      if (!(centre.spacing > 0) || has_replaced_vertex(m_sample.facets[f]))
        continue;
      visit(4 * f, centre);
      if (is_large(m_sample.facets[f]))
        for (std::size_t k = 1; k <= 3; ++k)
          visit(4 * f + k, place(4 * f + k));
    }
    for (std::size_t k = 0; k < m_sample.number_of_points_on_facets; ++k)
      if (m_sample.has_side(first_on_facets() + k))
        visit(4 * m_sample.facets.size() + k, place_of_point(first_on_facets() + k));
  }

  Place place(const std::size_t number) const
  {
    if (m_sample.facets.empty())
      return place_of_point(number);
    if (number >= 4 * m_sample.facets.size())
      return place_of_point(first_on_facets() + number - 4 * m_sample.facets.size());
    const Facet& facet = m_sample.facets[number / 4];
    const Vector &a = m_sample.points[facet[0]], &b = m_sample.points[facet[1]], &c = m_sample.points[facet[2]];
    const Vector area = (b - a).cross(c - a), centre = (a + b + c) / 3;
    Place result{centre, Vector::Zero(), 0};
    if (number % 4 > 0)
      result.point = 0.5 * (centre + m_sample.points[facet[number % 4 - 1]]);
    if (area.norm() > least_height * longest_edge(facet) * longest_edge(facet))
    {
      result.normal = area.normalized();
      result.spacing = ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
    }
    return result;
  }

  static constexpr std::size_t checks_of_place = 3;

  // The number of checks of a place that a function fails. The function is given by its Value_and_gradient and by its value
  // alone, as the value is faster. `parity` varies the distances.
  template <typename Jet_of_function, typename Value_of_function>
  std::size_t failures(const Place& place, const std::size_t parity, const Jet_of_function& jet,
                       const Value_of_function& value_at) const
  {
    std::size_t result = 0;
    const Value_and_gradient at_place = jet(place.point);
    const double length = at_place.gradient.norm();
    if (!(at_place.gradient.dot(place.normal) > 0) ||
        !(std::abs(at_place.value) <= (place.spacing + largest_error * m_noise) * length))
      ++result;
    // noise puts the place off the surface: the sides are those of the zero set nearby
    const double shift = m_noise > 0 && length > 0 ? at_place.value / length : 0.;
    static constexpr double distances[4] = {0.25, 1, 0.25, 2};
    const double distance = distances[parity % 4] * place.spacing;
    for (const double side : {1., -1.})
    {
      const Vector p = place.point + (side * distance - shift) * place.normal;
      const double value = value_at(p);
      if (!std::isfinite(value) || (side * value <= 0 && is_wrong(place, side, distance, shift, value_at)))
        ++result;
    }
    return result;
  }

private:
  static constexpr double least_height = 1e-3;  // over the longest edge
  static constexpr double large_facet = 2;      // its longest edge, in units of the spacing of its points
  static constexpr double largest_error = 4;    // of a point, in units of the noise
  static constexpr double least_distance = 0.2; // from here on the sign counts, in units of the spacing
  static constexpr double widest_gap = 0.9;     // to another sheet, over the distance at which the sign was asked for
  static constexpr double narrowest_gap = 1e-6; // in units of the spacing: below, sheets touch

  std::size_t first_on_facets() const { return m_sample.size() - m_sample.number_of_points_on_facets; }

  Place place_of_point(const std::size_t i) const
  {
    return Place{m_sample.points[i], m_sample.normals[i], m_sample.spacings[i]};
  }

  double longest_edge(const Facet& facet) const
  {
    const Vector &a = m_sample.points[facet[0]], &b = m_sample.points[facet[1]], &c = m_sample.points[facet[2]];
    return (std::max)((b - a).norm(), (std::max)((c - b).norm(), (a - c).norm()));
  }

  // Then there are points on the facet, which are places themselves.
  bool has_replaced_vertex(const Facet& facet) const
  {
    return std::any_of(facet.begin(), facet.end(), [&](const std::size_t i) { return m_sample.datum(i) == Datum::NONE; });
  }

  bool is_large(const Facet& facet) const
  {
    const double spacing = (m_sample.spacings[facet[0]] + m_sample.spacings[facet[1]] + m_sample.spacings[facet[2]]) / 3;
    return longest_edge(facet) > large_facet * spacing;
  }

  // Is asked where the function contradicts the side of a place at a distance. If the input does so, too, another sheet of it is
  // there. Then the middle between both counts.
  template <typename Value_of_function>
  bool is_wrong(const Place& place, const double side, const double distance, const double shift,
                const Value_of_function& value_at) const
  {
    const auto point = [&](const double d) { return Vector(place.point + (side * d - shift) * place.normal); };
    const double signed_distance = side * m_input.distance(point(distance)).value;
    if (signed_distance >= least_distance * place.spacing + m_noise)
      return true;
    const double gap = distance + signed_distance;
    if (!(gap < widest_gap * distance) || !(gap > narrowest_gap * place.spacing + 4 * m_noise))
      return false;
    const Vector middle = point(gap / 2);
    return side * m_input.distance(middle).value >= gap / 4 && side * value_at(middle) <= 0;
  }

  const Surface_sample& m_sample;
  const Signed_distance& m_input;
  double m_noise;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_CHECK_H
