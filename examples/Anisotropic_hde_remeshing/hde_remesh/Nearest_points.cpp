// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Nearest_points.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>

namespace hde_remesh {

namespace Hde_internal = CGAL::Anisotropic_hde_remeshing::internal;

namespace {

std::vector<Hde_internal::Vector> to_vectors(const std::vector<Point_3>& points)
{
  std::vector<Hde_internal::Vector> result;
  result.reserve(points.size());
  for (const Point_3& p : points)
    result.push_back(Hde_internal::to_vector(p));
  return result;
}

} // namespace

Nearest_points::Nearest_points(const std::vector<Point_3>& points) : m_search(to_vectors(points)) {}

std::size_t Nearest_points::nearest(const Point_3& p) const
{
  return m_search.nearest(Hde_internal::to_vector(p), 1).front().second;
}

double Nearest_points::distance(const Point_3& p) const
{
  return std::sqrt(m_search.nearest(Hde_internal::to_vector(p), 1).front().first);
}

double median_spacing(const std::vector<Point_3>& points)
{
  static constexpr std::size_t enough = 10000;
  static constexpr unsigned int number_of_neighbors = 6;
  const Hde_internal::Point_search search(to_vectors(points));
  std::vector<double> spacings;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / enough)
  {
    double sum = 0, number = 0;
    for (const auto& neighbor : search.nearest(Hde_internal::to_vector(points[i]), number_of_neighbors + 1))
      if (neighbor.first > 0) // neither the point itself nor a double of it
      {
        sum += std::sqrt(neighbor.first);
        ++number;
      }
    if (number > 0)
      spacings.push_back(sum / number);
  }
  if (spacings.empty())
    return 0;
  const auto middle = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

} // namespace hde_remesh
