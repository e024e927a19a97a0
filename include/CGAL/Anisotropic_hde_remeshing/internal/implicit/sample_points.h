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
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the points and normals of a range; their spacings are not known yet
template <typename PointRange, typename PointMap, typename NormalMap>
Surface_sample sample_points(const PointRange& range, const PointMap point_map, const NormalMap normal_map,
                             Interruption& interruption)
{
  Surface_sample sample;
  sample.is_of_points = true;
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
  return sample;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SAMPLE_POINTS_H
