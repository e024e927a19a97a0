// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_NOISE_OF_REGIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_NOISE_OF_REGIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/estimate_noise.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The standard deviation of the noise of the vertices: the median over the regions, each as often as it has vertices. Regions that
// are too small to tell do not count.
template <typename ConcurrencyTag>
double noise_of_regions(const std::vector<Region_mesh>& regions, Interruption& interruption)
{
  static constexpr std::size_t least_number_of_vertices = 50;
  std::vector<std::pair<double, std::size_t>> noises; // with numbers of vertices
  std::size_t number_of_vertices = 0;
  for (const Region_mesh& region : regions)
  {
    if (region.number_of_vertices() < least_number_of_vertices)
      continue;
    const Surface_sample sample = sample_mesh(region, get(vertex_point, region), internal_np::Param_not_found(), interruption);
    noises.emplace_back(estimate_noise<ConcurrencyTag>(sample, interruption) / sample.normalization.scale, sample.size());
    number_of_vertices += sample.size();
  }
  std::sort(noises.begin(), noises.end());
  std::size_t below = 0;
  for (const auto& [noise, number] : noises)
    if (2 * (below += number) >= number_of_vertices)
      return noise;
  return 0;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_NOISE_OF_REGIONS_H
