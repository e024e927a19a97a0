// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COMPLETE_SAMPLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COMPLETE_SAMPLE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Hole_rims.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Outliers.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Points_on_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/estimate_noise.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/mark_apexes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
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

inline void check_sample(const Surface_sample& sample)
{
  if (sample.size() == 0)
    throw std::invalid_argument("the input has no points");
  bool has_normal = false, has_spacing = false;
  for (std::size_t i = 0; i < sample.size(); ++i)
  {
    has_normal = has_normal || !sample.normals[i].isZero(0);
    has_spacing = has_spacing || sample.spacings[i] > 0;
  }
  if (!has_normal || !has_spacing)
    throw std::invalid_argument("the input has no point with a normal: all its faces are degenerate");
}

// Finds out what the sample does not tell by itself: spacings, outliers and holes of points, the noise, edges, and points on facets
// that are to count, too. Throws std::invalid_argument if no function can be built from it. Takes lengths of the parameters to the
// unit of the sample.
template <typename ConcurrencyTag>
void complete_sample(Surface_sample& sample, Interpolation_parameters& interpolation, Interruption& interruption)
{
  if (sample.is_of_points)
  {
    if (interpolation.detects_outliers)
      Outliers(ConcurrencyTag(), sample, interruption).correct(sample);
    compute_spacings<ConcurrencyTag>(sample, interpolation.closes_holes, interruption);
  }
  check_sample(sample);
  if (interpolation.closes_holes && !sample.facets.empty())
    find_rims_of_mesh<ConcurrencyTag>(sample, interruption);
  interpolation.absolute_offset *= sample.normalization.scale;
  interpolation.noise *= sample.normalization.scale;
  if (interpolation.estimates_noise)
    interpolation.noise = estimate_noise<ConcurrencyTag>(sample, interruption);
  if (interpolation.noise > 0)
    interpolation.mistrust_facets();
  if ((interpolation.uses_facets || interpolation.finds_edges) && !sample.facets.empty())
  {
    const Facet_edges edges(sample);
    if (interpolation.finds_edges)
    {
      mark_edges(sample, edges);
      mark_apexes(sample, edges);
    }
    if (interpolation.uses_facets)
      add_points_on_facets<ConcurrencyTag>(sample, edges, interpolation.keeps_vertices, interruption);
  }
}

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // cmake/Shared_compilation.cmake: compiled once for the package's own programs
#  define CGAL_AHR_COMPLETE_SAMPLE(ConcurrencyTag)                                                                             \
    template void complete_sample<ConcurrencyTag>(Surface_sample&, Interpolation_parameters&, Interruption&)
extern CGAL_AHR_COMPLETE_SAMPLE(Sequential_tag);
#  ifdef CGAL_LINKED_WITH_TBB
extern CGAL_AHR_COMPLETE_SAMPLE(Parallel_tag);
#  endif
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_COMPLETE_SAMPLE_H
