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

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The self-check of a patch. At places of the input, on its facets or at its points if it has none, the gradient must point
// outward and the surface must be within the local spacing h; at a distance of h/4 to 2 h before and behind them the sign
// must be that of the distance to the input. A wrong sign there is a sheet that the input does not have, or one that is missing.
// Most signs are known without a distance: it is asked only where the function contradicts.
class Patch_check
{
public:
  struct Place
  {
    Vector point, normal;
    double spacing;
  };

  Patch_check(const Surface_sample& sample, const Signed_distance& input) : m_sample(sample), m_input(input) {}

  // All places: the centres of the facets, three more in facets that are large for the points around them, and the points if
  // there are no facets. Degenerate facets have none.
  std::vector<Place> places() const
  {
    std::vector<Place> result;
    for (const Facet& facet : m_sample.facets)
      add_places(facet, result);
    if (m_sample.facets.empty())
      for (std::size_t i = 0; i < m_sample.size(); ++i)
        if (!m_sample.normals[i].isZero(0))
          result.push_back(Place{m_sample.points[i], m_sample.normals[i], m_sample.spacings[i]});
    return result;
  }

  static constexpr std::size_t checks_of_place = 3;

  // how many of the checks of a place a function fails, given by its Value_and_gradient and, faster, by its value alone;
  // `parity` varies the distances
  template <typename Jet_of_function, typename Value_of_function>
  std::size_t failures(const Place& place, const std::size_t parity, const Jet_of_function& jet,
                       const Value_of_function& value_at) const
  {
    std::size_t result = 0;
    const Value_and_gradient at_place = jet(place.point);
    const double length = at_place.gradient.norm();
    if (!(at_place.gradient.dot(place.normal) > 0) || !(std::abs(at_place.value) <= place.spacing * length))
      ++result;
    static constexpr double distances[4] = {0.25, 1, 0.25, 2};
    const double distance = distances[parity % 4] * place.spacing;
    for (const double side : {1., -1.})
    {
      const Vector p = place.point + side * distance * place.normal;
      const double value = value_at(p);
      if (!std::isfinite(value) || (side * value <= 0 && is_wrong(p, side, place.spacing)))
        ++result;
    }
    return result;
  }

private:
  static constexpr double least_height = 1e-3; // over the longest edge
  static constexpr double large_facet = 2;     // its longest edge, in units of the spacing of its points
  static constexpr double least_distance = 0.2; // where the sign counts, in units of the spacing

  void add_places(const Facet& facet, std::vector<Place>& places) const
  {
    const Vector &a = m_sample.points[facet[0]], &b = m_sample.points[facet[1]], &c = m_sample.points[facet[2]];
    const Vector area = (b - a).cross(c - a);
    const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
    const double longest = (std::max)(ab, (std::max)(bc, ca));
    if (!(area.norm() > least_height * longest * longest))
      return;
    const Vector normal = area.normalized();
    const double spacing = (ab + bc + ca) / 3;
    places.push_back(Place{(a + b + c) / 3, normal, spacing});
    const double of_points =
        (m_sample.spacings[facet[0]] + m_sample.spacings[facet[1]] + m_sample.spacings[facet[2]]) / 3;
    if (longest > large_facet * of_points)
      for (const Vector& corner : {a, b, c})
        places.push_back(Place{0.5 * corner + (a + b + c) / 6, normal, spacing});
  }

  bool is_wrong(const Vector& p, const double expected_side, const double spacing) const
  {
    return expected_side * m_input.distance(p).value >= least_distance * spacing;
  }

  const Surface_sample& m_sample;
  const Signed_distance& m_input;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_CHECK_H
