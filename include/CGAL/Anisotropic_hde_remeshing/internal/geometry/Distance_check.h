// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_DISTANCE_CHECK_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_DISTANCE_CHECK_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Tells for certain whether a triangle stays within a distance of a set of facets. The distance to one facet is a convex
// function: on a triangle it is largest at a corner. And the distance to all of them changes by no more than one goes. So a
// triangle passes if its corners are near enough to the same facet, or far enough from the limit; otherwise it is cut in two.
class Distance_check
{
  // Up to this size, over the limit, the triangle is cut: one that has not passed by then comes within that of the limit.
  static constexpr double smallest_part = 0.02;

public:
  struct Place // on the triangle, with the facet next to it
  {
    Vector point;
    std::size_t facet;
    double distance;
  };
  struct Answer
  {
    bool is_within = true;
    double bound = 0;         // the largest distance is not above; if it is not within, it is above the limit
    Place farthest{{}, 0, 0}; // of those that have been looked at
    boost::container::small_vector<std::size_t, 8> facets; // the distance to these alone is within the limit
  };

  // keeps references
  Distance_check(const std::vector<Vector>& points, const std::vector<Facet>& facets, const Closest_facet& closest_facet)
    : m_points(points), m_facets(facets), m_closest_facet(closest_facet)
  {
  }

  Place look_at(const Vector& p) const
  {
    const Closest_facet::Answer closest = m_closest_facet(p);
    return Place{p, closest.facet, (closest.point - p).norm()};
  }

  // the corners of the triangle have been looked at
  Answer operator()(const std::array<Place, 3>& triangle, const double limit) const
  {
    Answer answer;
    answer.farthest = triangle[0];
    std::vector<std::array<Place, 3>> parts(1, triangle);
    while (!parts.empty())
    {
      const std::array<Place, 3> part = parts.back();
      parts.pop_back();
      for (const Place& corner : part)
        if (corner.distance > answer.farthest.distance)
          answer.farthest = corner;
      const std::size_t k = longest_side(part);
      const double length = (part[(k + 1) % 3].point - part[k].point).norm();
      const double bound = bound_of(part, length);
      if (bound <= limit)
      {
        answer.bound = (std::max)(answer.bound, bound);
        for (const Place& corner : part)
          if (std::find(answer.facets.begin(), answer.facets.end(), corner.facet) == answer.facets.end())
            answer.facets.push_back(corner.facet);
        continue;
      }
      if (answer.farthest.distance > limit || length <= smallest_part * limit)
      {
        answer.is_within = false;
        answer.bound = (std::max)(answer.farthest.distance, (1 + smallest_part) * limit);
        return answer;
      }
      const Place middle = look_at((part[k].point + part[(k + 1) % 3].point) / 2);
      parts.push_back(part);
      parts.back()[k] = middle;
      parts.push_back(part);
      parts.back()[(k + 1) % 3] = middle;
    }
    return answer;
  }

private:
  static std::size_t longest_side(const std::array<Place, 3>& part)
  {
    std::size_t longest = 0;
    double squared_length = -1;
    for (std::size_t k = 0; k < 3; ++k)
      if ((part[(k + 1) % 3].point - part[k].point).squaredNorm() > squared_length)
      {
        squared_length = (part[(k + 1) % 3].point - part[k].point).squaredNorm();
        longest = k;
      }
    return longest;
  }

  // of the distance on a part whose longest side has a length
  double bound_of(const std::array<Place, 3>& part, const double length) const
  {
    // no point is further from the nearest corner than this
    const double way_to_corner = length / std::sqrt(3.);
    double bound = way_to_corner + (std::max)({part[0].distance, part[1].distance, part[2].distance});
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Facet& facet = m_facets[part[k].facet];
      double largest = 0;
      for (const Place& corner : part)
        largest = (std::max)(largest, corner.facet == part[k].facet
                                          ? corner.distance
                                          : std::sqrt(closest_on_triangle(corner.point, m_points[facet[0]], m_points[facet[1]],
                                                                          m_points[facet[2]])
                                                          .squared_distance));
      bound = (std::min)(bound, largest);
    }
    return bound;
  }

  const std::vector<Vector>& m_points;
  const std::vector<Facet>& m_facets;
  const Closest_facet& m_closest_facet;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_DISTANCE_CHECK_H
