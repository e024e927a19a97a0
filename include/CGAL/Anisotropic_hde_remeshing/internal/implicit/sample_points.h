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

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the spacing of a point without edges: the mean distance to its six nearest neighbours, as many as a vertex has
template <typename ConcurrencyTag>
void compute_spacings(Surface_sample& sample)
{
  typedef Simple_cartesian<double>::Point_3 Point;
  typedef Search_traits_3<Simple_cartesian<double>> Traits;
  typedef Orthogonal_k_neighbor_search<Traits> Neighbor_search;
  static constexpr unsigned int number_of_neighbors = 6;

  std::vector<Point> points;
  points.reserve(sample.size());
  for (const Vector& p : sample.points)
    points.emplace_back(p[0], p[1], p[2]);
  typename Neighbor_search::Tree tree(points.begin(), points.end());
  tree.build();
  parallel_for<ConcurrencyTag>(sample.size(),
                               [&](const std::size_t i)
                               {
                                 // the nearest is the point itself
                                 Neighbor_search search(tree, points[i], number_of_neighbors + 1);
                                 double sum = 0;
                                 std::size_t count = 0;
                                 for (const auto& neighbor : search)
                                 {
                                   sum += std::sqrt(neighbor.second);
                                   count += neighbor.second > 0 ? 1 : 0;
                                 }
                                 sample.spacings[i] = count > 0 ? sum / double(count) : 0.;
                               });
}

template <typename ConcurrencyTag, typename PointRange, typename PointMap, typename NormalMap>
Surface_sample sample_points(const PointRange& range, const PointMap point_map, const NormalMap normal_map)
{
  Surface_sample sample;
  std::size_t index = 0;
  for (const auto& item : range)
  {
    sample.points.push_back(finite_vector(get(point_map, item), "point", index));
    sample.normals.push_back(unit_normal(get(normal_map, item), index));
    ++index;
  }
  sample.spacings.assign(sample.size(), 0.);
  merge_duplicate_points(sample);
  compute_spacings<ConcurrencyTag>(sample);
  return sample;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_POINTS_H
