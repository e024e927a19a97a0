// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "reconstruct.h"
#include "Failure.h"
#include "Nearest_points.h"
#include "signals.h"

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>
#include <CGAL/rbf_surface_reconstruction.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace hde_remesh {

namespace Hde = CGAL::Anisotropic_hde_remeshing;

namespace {

typedef std::pair<Point_3, Vector_3> Point_with_normal;

// How much larger facets may be than the spacing, where few are asked for: at least two for each of those, so that there is a
// choice, and so many spacings at most, so that details stay. On area A a mesh of facets of size s has about 1.6 A / s^2 of them.
double coarseness(const std::size_t number_of_points, const Options& options)
{
  static constexpr double faces_for_each = 2, faces_on_square = 1.6, largest = 4;
  std::optional<double> number_of_faces;
  if (options.faces)
    number_of_faces = static_cast<double>(*options.faces);
  else if (options.vertices)
    number_of_faces = 2 * static_cast<double>(*options.vertices);
  if (!number_of_faces || options.error || options.absolute_error)
    return 1;
  const double area = static_cast<double>(number_of_points); // in squares of the spacing
  return std::clamp(std::sqrt(faces_on_square * area / (faces_for_each * *number_of_faces)), 1., largest);
}

} // namespace

Reconstructed reconstruct(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals, const Options& options,
                          Progress& progress)
{
  std::vector<Point_with_normal> points_with_normals;
  for (std::size_t i = 0; i < points.size(); ++i)
    points_with_normals.emplace_back(points[i], normals[i]);
  const auto smoothing = options.smoothing ? Hde::Smoothing(*options.smoothing) : Hde::AUTOMATIC_SMOOTHING;
  const double facet_size = coarseness(points.size(), options) * median_spacing(points);
  Reconstructed result;
  progress.stage("surface of the points");
  Progress_visitor visitor(progress);
  is_listening() = 1;
  try
  {
    result.result =
        CGAL::rbf_surface_reconstruction<CGAL::Parallel_if_available_tag>(points_with_normals, result.mesh,
                                                                          Hde::parameters::smoothing(smoothing)
                                                                              .detect_outliers(options.detect_outliers)
                                                                              .facet_size(facet_size)
                                                                              .visitor(std::ref(visitor)));
  }
  catch (const Hde::Interrupted&)
  {
    throw Failure(cancelled_text(), STATUS_CANCELLED);
  }
  is_listening() = 0;
  return result;
}

} // namespace hde_remesh
