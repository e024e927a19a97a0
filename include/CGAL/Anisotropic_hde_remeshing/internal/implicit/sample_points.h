// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_POINTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_POINTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Outliers.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the spacing of a point without edges: the mean distance to its six nearest neighbours, as many as a vertex has
template <typename ConcurrencyTag>
void compute_spacings(Surface_sample& sample, Interruption& interruption)
{
  static constexpr unsigned int number_of_neighbors = 6;
  if (sample.points.empty())
    return; // a search tree needs points
  const Point_search search(sample.points);
  parallel_for<ConcurrencyTag>(
      sample.size(),
      [&](const std::size_t i)
      {
        double sum = 0;
        std::size_t count = 0;
        // the nearest is the point itself
        for (const auto& neighbor : search.nearest(sample.points[i], number_of_neighbors + 1))
          if (neighbor.second != i)
          {
            sum += std::sqrt(neighbor.first);
            ++count;
          }
        sample.spacings[i] = count > 0 ? sum / double(count) : 0.;
      },
      256, interruption);
  interruption.check();
}

template <typename ConcurrencyTag, typename PointRange, typename PointMap, typename NormalMap>
Surface_sample sample_points(const PointRange& range, const PointMap point_map, const NormalMap normal_map,
                             const bool detects_outliers, Interruption& interruption)
{
  Surface_sample sample;
  std::size_t index = 0;
  for_each_of_range(range,
                    [&](const auto& item)
                    {
                      interruption.check();
                      sample.points.push_back(finite_vector(value_of(point_map, item), "point", index));
                      sample.normals.push_back(unit_normal(value_of(normal_map, item), index));
                      ++index;
                    });
  sample.normalization = normalize(sample.points);
  sample.spacings.assign(sample.size(), 0.);
  merge_duplicate_points(sample);
  if (detects_outliers)
    Outliers(ConcurrencyTag(), sample, interruption).correct(sample);
  compute_spacings<ConcurrencyTag>(sample, interruption);
  return sample;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_POINTS_H
