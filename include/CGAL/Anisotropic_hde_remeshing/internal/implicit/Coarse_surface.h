// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COARSE_SURFACE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COARSE_SURFACE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Graded_point_grid.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A sample in a few hundred parts, which are small at the rims of holes and large far from them. Each has the points that are
// nearest to one of them, its middle.
class Coarse_surface
{
public:
  struct Part
  {
    std::size_t middle = 0; // a point of the sample
    double radius = 0;      // about
    double area = 0;
    Vector area_normal = Vector::Zero(); // the integral of the normals
    Vector centre = Vector::Zero();      // of mass
  };

  static constexpr double growth = 0.5; // of the radius with the distance to the rim

  template <typename ConcurrencyTag>
  Coarse_surface(const ConcurrencyTag, const Surface_sample& sample, const std::vector<std::size_t>& rim,
                 Interruption& interruption)
  {
    const std::vector<double> from_rim = distances_to<ConcurrencyTag>(sample, rim, interruption);
    select(sample, from_rim);
    const std::vector<double> areas =
        sample.facets.empty() ? areas_of_points<ConcurrencyTag>(sample, from_rim, interruption) : areas_of_vertices(sample);
    gather<ConcurrencyTag>(sample, areas, interruption);
  }

  const std::vector<Part>& parts() const { return m_parts; }

private:
  static constexpr double least_radius = 1.5; // in units of the spacing
  static constexpr std::size_t largest_number = 400;
  static constexpr double growth_of_least_radius = 1.3; // while there are too many

  static std::size_t number_of_points(const Surface_sample& sample)
  {
    return sample.size() - sample.number_of_points_on_facets;
  }

  // without a rim, all points are on it
  template <typename ConcurrencyTag>
  static std::vector<double> distances_to(const Surface_sample& sample, const std::vector<std::size_t>& rim,
                                          Interruption& interruption)
  {
    std::vector<double> result(number_of_points(sample), 0.);
    if (rim.empty())
      return result;
    std::vector<Vector> places;
    for (const std::size_t i : rim)
      places.push_back(sample.points[i]);
    const Point_search search(places);
    parallel_for<ConcurrencyTag>(
        result.size(), [&](const std::size_t i) { result[i] = std::sqrt(search.nearest(sample.points[i], 1).front().first); },
        256, interruption);
    interruption.check();
    return result;
  }

  // Takes points none of which is within the radius of another, ever fewer as long as there are too many.
  void select(const Surface_sample& sample, const std::vector<double>& from_rim)
  {
    std::vector<std::size_t> points(from_rim.size());
    std::iota(points.begin(), points.end(), std::size_t(0));
    for (double least = least_radius;; least *= growth_of_least_radius)
    {
      Graded_point_grid grid;
      m_parts.clear();
      for (const std::size_t i : points)
      {
        const double radius = (std::max)(least * sample.spacings[i], growth * from_rim[i]);
        if (!(radius > 0) || grid.has_near(sample.points[i], radius, radius, [](std::size_t) { return true; }))
          continue;
        grid.insert(sample.points[i], radius);
        m_parts.emplace_back();
        m_parts.back().middle = i;
        m_parts.back().radius = radius;
      }
      if (m_parts.size() <= largest_number)
        return;
      points.clear();
      for (const Part& part : m_parts)
        points.push_back(part.middle);
    }
  }

  static std::vector<double> areas_of_vertices(const Surface_sample& sample)
  {
    std::vector<double> result(sample.size(), 0.);
    for (const Facet& facet : sample.facets)
    {
      const Vector& p = sample.points[facet[0]];
      const double area = (sample.points[facet[1]] - p).cross(sample.points[facet[2]] - p).norm() / 2;
      for (const std::size_t i : facet)
        result[i] += area / 3;
    }
    return result;
  }

  // Proportional to the squares of the spacings. How regularly the points are spread tells the factor: it is the median over
  // places far from the rim, where a disk of more points has an area that is known.
  template <typename ConcurrencyTag>
  std::vector<double> areas_of_points(const Surface_sample& sample, const std::vector<double>& from_rim,
                                      Interruption& interruption) const
  {
    static constexpr unsigned int number_of_neighbors = 24;
    static constexpr double usual_factor = 0.9;
    static constexpr double far_from_rim = 6; // in units of the spacing
    std::vector<double> factors(m_parts.size(), 0.);
    const Point_search search(sample.points);
    parallel_for<ConcurrencyTag>(
        m_parts.size(),
        [&](const std::size_t k)
        {
          const std::size_t i = m_parts[k].middle;
          if (!(from_rim[i] > far_from_rim * sample.spacings[i]) || sample.size() <= 2 * number_of_neighbors)
            return;
          double squared_radius = 0;
          for (const auto& neighbor : search.nearest(sample.points[i], number_of_neighbors + 1))
            squared_radius = (std::max)(squared_radius, neighbor.first);
          factors[k] = CGAL_PI * squared_radius / number_of_neighbors / std::pow(sample.spacings[i], 2);
        },
        16, interruption);
    interruption.check();
    factors.erase(std::remove(factors.begin(), factors.end(), 0.), factors.end());
    double factor = usual_factor;
    if (!factors.empty())
    {
      const auto median = factors.begin() + std::ptrdiff_t(factors.size() / 2);
      std::nth_element(factors.begin(), median, factors.end());
      factor = *median;
    }
    std::vector<double> result;
    for (const double spacing : sample.spacings)
      result.push_back(factor * spacing * spacing);
    return result;
  }

  template <typename ConcurrencyTag>
  void gather(const Surface_sample& sample, const std::vector<double>& areas, Interruption& interruption)
  {
    std::vector<Vector> middles;
    for (const Part& part : m_parts)
      middles.push_back(sample.points[part.middle]);
    const Point_search search(middles);
    std::vector<std::size_t> part_of(number_of_points(sample));
    parallel_for<ConcurrencyTag>(
        part_of.size(), [&](const std::size_t i) { part_of[i] = search.nearest(sample.points[i], 1).front().second; }, 256,
        interruption);
    interruption.check();
    for (std::size_t i = 0; i < part_of.size(); ++i)
    {
      Part& part = m_parts[part_of[i]];
      part.area += areas[i];
      part.area_normal += areas[i] * sample.normals[i];
      part.centre += areas[i] * sample.points[i];
    }
    for (Part& part : m_parts)
      part.centre = part.area > 0 ? Vector(part.centre / part.area) : sample.points[part.middle];
  }

  std::vector<Part> m_parts;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COARSE_SURFACE_H
