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

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Hole_rims.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Outliers.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The spacing of a point without edges: the mean distance to its six nearest neighbours, as many as a vertex has. On request, looks
// for holes where all of these are on one side.
template <typename ConcurrencyTag>
void compute_spacings(Surface_sample& sample, const bool finds_holes, Interruption& interruption)
{
  static constexpr unsigned int number_of_neighbors = 6;
  if (sample.points.empty())
    return; // a search tree needs points
  const Point_search search(sample.points);
  std::vector<Vector> gaps(finds_holes ? sample.size() : 0, Vector::Zero());
  parallel_for<ConcurrencyTag>(
      sample.size(),
      [&](const std::size_t i)
      {
        double sum = 0;
        std::vector<Vector> ways;
        // the nearest is the point itself
        for (const auto& neighbor : search.nearest(sample.points[i], number_of_neighbors + 1))
          if (neighbor.second != i)
          {
            sum += std::sqrt(neighbor.first);
            ways.push_back(sample.points[neighbor.second] - sample.points[i]);
          }
        sample.spacings[i] = ways.empty() ? 0. : sum / double(ways.size());
        if (finds_holes && !sample.normals[i].isZero(0))
          gaps[i] = direction_of_gap(sample.normals[i], ways, Hole_rims::least_gap);
      },
      256, interruption);
  interruption.check();
  if (finds_holes)
    find_rims_of_points<ConcurrencyTag>(sample, gaps, search, interruption);
}

template <typename ConcurrencyTag, typename PointRange, typename PointMap, typename NormalMap>
Surface_sample sample_points(const PointRange& range, const PointMap point_map, const NormalMap normal_map,
                             const bool detects_outliers, const bool finds_holes, Interruption& interruption)
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
  compute_spacings<ConcurrencyTag>(sample, finds_holes, interruption);
  return sample;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_POINTS_H
