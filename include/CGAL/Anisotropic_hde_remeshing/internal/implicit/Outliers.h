// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_OUTLIERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_OUTLIERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Points of a range that their neighbours contradict. An outlier is off the tangent planes of all but two of its nearest neighbours,
// by more than a share of the spacing and more than most points are. At a sharp edge, a corner or a tip there are more neighbours on
// whose planes a point lies. A normal is wrong if the neighbours agree on another one, and the point lies on their sheet: it is turned
// if it is the opposite of theirs, else dropped. If many points are contradicted, all are kept: the sampling is too coarse to judge.
class Outliers
{
  static constexpr unsigned int number_of_neighbors = 12;
  static constexpr std::size_t least_number_of_supporters = 3;
  // largest height of a point over the tangent plane of a supporter, over the spacing: this one, or so many times what is usual
  static constexpr double least_slope = 0.2, usual_slopes = 4, usual_quantile = 0.9;
  static constexpr double largest_slope_of_sheet = 0.3;
  static constexpr int number_of_rounds = 3; // outliers support each other in the first one
  static constexpr double least_agreement =
      0.8; // length of the mean normal of the neighbours that do not look to the other side
  static constexpr double largest_wrong_cosine = 0.5, largest_turned_cosine = -0.5; // to their mean normal
  static constexpr std::size_t least_number_of_agreeing = 8;
  static constexpr double farthest_supporter = 2; // in units of the distance to its own farthest neighbour
  static constexpr double largest_share = 0.1;

public:
  template <typename ConcurrencyTag>
  Outliers(const ConcurrencyTag, const Surface_sample& sample, Interruption& interruption)
    : m_slopes(sample.size(), 0), m_cosines(sample.size(), 1)
  {
    if (sample.size() <= number_of_neighbors)
      return;
    const Point_search search(sample.points);
    std::vector<Neighbors> neighbors(sample.size());
    parallel_for<ConcurrencyTag>(
        sample.size(), [&](const std::size_t i) { neighbors[i] = neighbors_of(sample, search, i); }, 256, interruption);
    interruption.check();
    for (int round = 0; round < number_of_rounds; ++round)
    {
      const std::vector<double> before = m_slopes;
      const auto is_sound = [&](const std::size_t j) { return !(before[j] > m_largest_slope); };
      parallel_for<ConcurrencyTag>(
          sample.size(), [&](const std::size_t i) { m_slopes[i] = slope(sample, neighbors, i, is_sound); }, 256, interruption);
      interruption.check();
      if (round == 0)
        m_largest_slope = (std::max)(least_slope, usual_slopes * quantile(m_slopes, usual_quantile));
    }
    parallel_for<ConcurrencyTag>(
        sample.size(), [&](const std::size_t i) { m_cosines[i] = cosine(sample, neighbors[i], i); }, 256, interruption);
    interruption.check();
  }

  // removes and turns in the sample what is contradicted, and counts it there
  void correct(Surface_sample& sample) const
  {
    const std::size_t outliers = std::size_t(std::count_if(m_slopes.begin(), m_slopes.end(),
                                                           [&](const double slope) { return slope > m_largest_slope; })),
                      wrong = std::size_t(std::count_if(m_cosines.begin(), m_cosines.end(),
                                                        [](const double cosine) { return cosine < largest_wrong_cosine; }));
    const double most = largest_share * double(sample.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < sample.size(); ++i)
    {
      if (m_slopes[i] > m_largest_slope && double(outliers) <= most)
        continue;
      Vector normal = sample.normals[i];
      if (m_cosines[i] < largest_wrong_cosine && double(wrong) <= most)
      {
        normal = m_cosines[i] < largest_turned_cosine ? Vector(-normal) : Vector(Vector::Zero());
        ++sample.number_of_wrong_normals;
      }
      sample.points[next] = sample.points[i];
      sample.normals[next++] = normal;
    }
    sample.number_of_outliers = sample.size() - next;
    sample.points.resize(next);
    sample.normals.resize(next);
    sample.spacings.resize(next);
  }

private:
  static double quantile(std::vector<double> values, const double share)
  {
    const auto place = values.begin() + std::ptrdiff_t(share * double(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  }

  struct Neighbors
  {
    std::array<std::size_t, number_of_neighbors> points;
    double radius = 0;
  };

  static Neighbors neighbors_of(const Surface_sample& sample, const Point_search& search, const std::size_t i)
  {
    auto nearest = search.nearest(sample.points[i], number_of_neighbors + 1);
    std::sort(nearest.begin(), nearest.end());
    Neighbors result;
    std::size_t number = 0;
    for (const auto& [squared_distance, j] : nearest)
      if (j != i && number < number_of_neighbors)
      {
        result.points[number++] = j;
        result.radius = std::sqrt(squared_distance);
      }
    return result;
  }

  // The third smallest height over the tangent plane of a neighbour, over the spacing, or over the way from it if that is less. A
  // neighbour does not support a point that is far for what is around itself, nor if it is an outlier.
  template <typename Is_sound>
  static double slope(const Surface_sample& sample, const std::vector<Neighbors>& neighbors, const std::size_t i,
                      const Is_sound& is_sound)
  {
    static constexpr double unsupported = 2;
    const Vector &p = sample.points[i], &normal = sample.normals[i];
    std::array<double, number_of_neighbors> slopes;
    for (std::size_t k = 0; k < number_of_neighbors; ++k)
    {
      const std::size_t j = neighbors[i].points[k];
      const Vector way = p - sample.points[j];
      const double length = way.norm();
      slopes[k] = unsupported;
      if (length > farthest_supporter * neighbors[j].radius || !is_sound(j))
        continue;
      const double base = (std::min)(length, neighbors[i].radius / 2); // about the spacing
      slopes[k] = std::abs(sample.normals[j].dot(way)) / base;
      // between points of a bend, the mean of their normals is across the way
      if (sample.normals[j].dot(normal) > 0.5)
        slopes[k] = (std::min)(slopes[k], std::abs((sample.normals[j] + normal).normalized().dot(way)) / base);
    }
    const auto last = slopes.begin() + std::ptrdiff_t(least_number_of_supporters - 1);
    std::nth_element(slopes.begin(), last, slopes.end());
    return *last;
  }

  // of the angle between the normal and the mean normal of the neighbours; 1 if most of these do not agree, or are another sheet
  static double cosine(const Surface_sample& sample, const Neighbors& neighbors, const std::size_t i)
  {
    Vector sum = Vector::Zero(), sum_of_agreeing = Vector::Zero();
    for (const std::size_t j : neighbors.points)
      sum += sample.normals[j];
    std::size_t number = 0;
    for (const std::size_t j : neighbors.points)
      if (const Vector way = sample.points[i] - sample.points[j];
          sample.normals[j].dot(sum) > 0 && std::abs(sample.normals[j].dot(way)) <= largest_slope_of_sheet * way.norm())
      {
        sum_of_agreeing += sample.normals[j];
        ++number;
      }
    const double length = sum_of_agreeing.norm();
    if (number < least_number_of_agreeing || !(length > least_agreement * double(number)) || sample.normals[i].isZero(0))
      return 1;
    return sample.normals[i].dot(sum_of_agreeing) / length;
  }

  std::vector<double> m_slopes, m_cosines; // by point
  double m_largest_slope = 10;             // more than any
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_OUTLIERS_H
