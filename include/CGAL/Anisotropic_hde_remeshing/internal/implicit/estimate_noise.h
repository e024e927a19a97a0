// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ESTIMATE_NOISE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ESTIMATE_NOISE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Blending_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patch_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/likelihood_of_heights.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Radial_basis_functions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The standard deviation of the noise of the points: the median of what is most likely in each of some patches of the default
// size, so that edges, which only a few patches have, do not count as noise. 0 if the points are exact, or too few.
template <typename ConcurrencyTag>
double estimate_noise(const Surface_sample& sample, Interruption& interruption)
{
  static constexpr std::size_t largest_number_of_patches = 400;
  static constexpr double least_noise = 5e-3; // in units of the spacing: less is rounding, or coarse sampling
  const Interpolation_parameters defaults;
  const std::size_t number_of_patches = Interpolation_parameters::patches_of(sample.size());
  const double width = 5 + 2 * (defaults.patch_blending + defaults.patch_overlap);
  const Blending_tree tree(ConcurrencyTag(), sample, number_of_patches, defaults.patch_blending, defaults.patch_overlap,
                           std::size_t(2 * width * width), interruption);
  const std::size_t leaves = tree.leaves().size(), n = (std::min)(leaves, largest_number_of_patches);
  std::vector<double> noises(n, -1), relative_noises(n, -1);
  parallel_for<ConcurrencyTag>(
      n,
      [&](const std::size_t k)
      {
        const Blending_tree::Leaf& leaf = tree.leaves()[k * leaves / n];
        const Patch_frame frame = frame_of(sample, leaf);
        const auto likelihood =
            likelihood_of_heights<Eigen::MatrixXd>(sample, leaf, frame, Polyharmonic_rbf(), Heights::for_noise());
        if (!likelihood)
          return;
        relative_noises[k] = std::sqrt(likelihood->variance_of_noise());
        noises[k] = relative_noises[k] * frame.unit;
      },
      1, interruption);
  interruption.check();
  const auto median = [](std::vector<double> values)
  {
    values.erase(std::remove(values.begin(), values.end(), -1.), values.end());
    if (values.empty())
      return 0.;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return median(relative_noises) < least_noise ? 0. : median(noises);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_ESTIMATE_NOISE_H
