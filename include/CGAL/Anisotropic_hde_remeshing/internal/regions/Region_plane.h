// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_PLANE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_PLANE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/split_regions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the signed distance to a plane
struct Region_plane
{
  Vector point = Vector::Zero(), normal = Vector::Zero();

  Value_and_gradient operator()(const Vector& p) const { return Value_and_gradient{{normal.dot(p - point)}, normal}; }
};

// The plane that fits the points best. CGAL::linear_least_squares_fitting_3() has it from the covariance alone, with the error that
// is corrected below. Many planes are orthogonal to an axis: where all points have the same coordinate, the
// plane has exactly that coordinate, too.
inline Region_plane best_plane(const std::vector<Vector>& points, const double size)
{
  Vector low = points.front(), high = low, sum = Vector::Zero();
  for (const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    sum += p - points.front();
  }
  Region_plane plane;
  plane.point = points.front() + sum / double(points.size());
  Eigen::Index axis;
  if ((high - low).minCoeff(&axis) <= 1e-14 * size)
  {
    plane.normal = Vector::Unit(axis);
    plane.point[axis] = low[axis] + 0.5 * (high[axis] - low[axis]);
    return plane;
  }
  if (points.size() < 3)
    return plane;
  Matrix covariance = Matrix::Zero();
  for (const Vector& p : points)
    covariance += ((p - plane.point) / size) * ((p - plane.point) / size).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(covariance);
  plane.normal = axes.eigenvectors().col(0);
  // The squares of a covariance lose digits where a region is much longer than wide. So the normal is corrected towards each of
  // the axes in the plane, by the heights themselves. (A singular value decomposition loses no digits, but Eigen's one takes a
  // tenth of the time to compile a program with this package.)
  for (const Eigen::Index axis : {1, 2})
  {
    const Vector along = axes.eigenvectors().col(axis);
    double products = 0, squares = 0;
    for (const Vector& p : points)
    {
      const double x = along.dot(p - plane.point);
      products += x * plane.normal.dot(p - plane.point);
      squares += x * x;
    }
    if (squares > 0)
      plane.normal -= products / squares * along;
  }
  plane.normal.normalize();
  return plane;
}

// The plane of some facets. All points must be in the plane within `tolerance`, and within a hundredth of their extent. The plane
// looks to where the facets look.
inline std::optional<Region_plane> plane_of(const std::vector<Vector>& points, const std::vector<Facet>& facets,
                                            const double tolerance)
{
  Vector low = points.front(), high = low;
  for (const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm(), thickness = (std::min)(tolerance, 0.01 * size);
  Region_plane plane = best_plane(points, size);
  if (std::any_of(points.begin(), points.end(), [&](const Vector& p) { return !(std::abs(plane(p).value) <= thickness); }))
    return std::nullopt;
  double projected_area = 0, area = 0;
  for (const Facet& facet : facets)
  {
    const Vector twice = (points[facet[1]] - points[facet[0]]).cross(points[facet[2]] - points[facet[0]]);
    projected_area += plane.normal.dot(twice);
    area += twice.norm();
  }
  // They are folded or have no area: there is no side to look to.
  if (!(std::abs(projected_area) > 0.5 * area))
    return std::nullopt;
  if (projected_area < 0)
    plane.normal = -plane.normal;
  return plane;
}

// the same for a region
inline std::optional<Region_plane> plane_of(const Region_mesh& region, const double tolerance)
{
  std::vector<Vector> points;
  for (const Region_mesh::Vertex_index v : region.vertices())
    points.push_back(to_vector(region.point(v)));
  return plane_of(points, facets_of(region, [](const Region_mesh::Vertex_index v) { return std::size_t(v); }), tolerance);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_REGION_PLANE_H
