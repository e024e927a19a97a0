// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LIKELIHOOD_OF_HEIGHTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LIKELIHOOD_OF_HEIGHTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Tangent_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Blending_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patch_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Polynomial_null_space.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Restricted_likelihood.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What the heights of a patch are asked for. Noise is what no smooth surface explains, so squares are subtracted, and steep slopes,
// on which noise counts more, are left out. The scale of the function is what it has to bend, all over the patch.
struct Heights
{
  double least_cosine; // of the angle between the normals of the points and of the plane
  Eigen::Index number_of_polynomials;

  static constexpr Heights for_noise() { return {0.8, 6}; }
  static constexpr Heights for_scale() { return {0.5, 3}; }
};

// The normal of a patch with which most of its points agree. At an edge it is that of one side. Zero if no point has one.
inline Vector common_normal(const Surface_sample& sample, const Blending_tree::Leaf& leaf, const double least_cosine)
{
  Vector result = Vector::Zero();
  std::size_t most = 0;
  for (const std::size_t i : leaf.own_points)
  {
    const auto agrees = [&](const std::size_t j) { return sample.normals[j].dot(sample.normals[i]) > least_cosine; };
    const std::size_t number = std::size_t(std::count_if(leaf.points.begin(), leaf.points.end(), agrees));
    if (number > most)
    {
      most = number;
      result = sample.normals[i];
    }
  }
  return result;
}

// the points of a patch that look in the direction of the normal; if there are very many, the nearest ones, by increasing index
inline std::vector<std::size_t> points_with_height(const Surface_sample& sample, const Blending_tree::Leaf& leaf,
                                                   const Vector& normal, const double least_cosine, const Vector& centre)
{
  static constexpr std::size_t largest_number = 400;
  std::vector<std::size_t> result;
  for (const std::size_t i : leaf.points)
    if (sample.normals[i].dot(normal) > least_cosine)
      result.push_back(i);
  if (result.size() > largest_number)
  {
    const auto distance = [&](const std::size_t i) { return (sample.points[i] - centre).squaredNorm(); };
    std::nth_element(result.begin(), result.begin() + largest_number, result.end(),
                     [&](const std::size_t i, const std::size_t j)
                     { return std::make_pair(distance(i), i) < std::make_pair(distance(j), j); });
    result.resize(largest_number);
    std::sort(result.begin(), result.end());
  }
  return result;
}

// How likely the heights of a patch over a plane are, in the coordinates of its frame, as those of a smooth surface with noise.
// Off-surface points say nothing of the noise. Empty if too few points have a height.
template <typename Dense_matrix, typename RadialFunction>
std::optional<Restricted_likelihood<Dense_matrix>>
likelihood_of_heights(const Surface_sample& sample, const Blending_tree::Leaf& leaf, const Patch_frame& frame,
                      const RadialFunction& function, const Heights& which)
{
  static constexpr Eigen::Index least_number_of_points = 20;
  const Vector normal = common_normal(sample, leaf, which.least_cosine);
  const std::vector<std::size_t> used = points_with_height(sample, leaf, normal, which.least_cosine, frame.centre);
  const Eigen::Index n = Eigen::Index(used.size()), q = which.number_of_polynomials;
  if (n < least_number_of_points)
    return std::nullopt;
  const Tangent_frame tangents = tangent_frame(normal);
  Eigen::Matrix<double, 3, Eigen::Dynamic> places(3, n);
  Dense_matrix polynomials(n, q);
  Eigen::Matrix<double, Eigen::Dynamic, 1> heights(n);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    const Vector y = frame(sample.points[used[std::size_t(k)]]);
    const double u = tangents.col(0).dot(y), v = tangents.col(1).dot(y);
    places.col(k) = Vector(u, v, 0);
    const double values[] = {1, u, v, u * u, u * v, v * v};
    for (Eigen::Index j = 0; j < q; ++j)
      polynomials(k, j) = values[j];
    heights[k] = normal.dot(y);
  }
  const Polynomial_null_space<Dense_matrix> null_space(polynomials);
  Dense_matrix matrix = interpolation_matrix(places, function, 0.);
  null_space.transform(matrix);
  return Restricted_likelihood<Dense_matrix>(matrix.bottomRightCorner(n - q, n - q),
                                             null_space.transformed(heights).tail(n - q));
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_LIKELIHOOD_OF_HEIGHTS_H
