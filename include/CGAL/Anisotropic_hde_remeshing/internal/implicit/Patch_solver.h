// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_SOLVER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_SOLVER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Blending_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Interpolation_system.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Local_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Noise_covariance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Off_surface_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Sparse_interpolation_system.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_matrix.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/likelihood_of_heights.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// what can be changed to solve a patch once more
struct Patch_settings
{
  double offset_factor = 1;
  double ridge = 0; // on the diagonal of the matrix, in which the local spacing is 1
};

// what a solved patch tells the diagnostics
struct Patch_record
{
  std::size_t number_of_centres = 0;
  double relative_residual = 0;
  double value_residual = 0; // the largest difference to a datum
  double condition = 1;
  Solver solver = Solver::FAILED;
};

template <typename RadialFunction>
struct Solved_patch
{
  Local_interpolant<RadialFunction> interpolant;
  Patch_record record;
};

// Interpolates the data of a patch, the paper's (12): 0 at its points, +-eps_i at the off-surface points. If the points are
// noisy, it takes the most likely function instead, as in kriging: the data have the covariance of the noise, and the function
// has the scale that the heights of the patch tell.
template <typename RadialFunction, typename ConcurrencyTag>
class Patch_solver
{
  typedef Local_interpolant<RadialFunction> Interpolant;
  typedef typename Interpolant::Points Points;
  typedef Off_surface_points<ConcurrencyTag> Offsets;

  // least length of the mean normal; below it, the patch has no common direction
  static constexpr double least_mean_normal = 0.5;
  // least independence of the polynomials on the centres
  static constexpr double least_independence = 1e-5;

  // Below that many centres, or above that density, a dense system is as fast.
  static constexpr Eigen::Index least_sparse_size = 500;
  static constexpr double largest_density = 0.1;
  // largest dense system for a patch that was to be sparse; a larger one may not fit into memory
  static constexpr Eigen::Index largest_dense_size = 10000;

  template <typename T, typename = void>
  struct Has_unit : std::false_type
  {
  };
  template <typename T>
  struct Has_unit<T, std::void_t<decltype(std::declval<T&>().set_unit(1.))>> : std::true_type
  {
  };

public:
  // `unit_of_length` is that of the caller in the coordinates of the sample, in which `noise` is the standard deviation of that of
  // the points
  Patch_solver(const Surface_sample& sample, const Offsets& offsets, const RadialFunction& function,
               const double unit_of_length, const double noise)
    : m_sample(sample), m_offsets(offsets), m_function(function), m_unit_of_length(unit_of_length), m_noise(noise)
  {
  }

  Solved_patch<RadialFunction> operator()(const Blending_tree::Leaf& leaf, const Patch_settings& settings) const
  {
    Solved_patch<RadialFunction> result;
    const Patch_frame frame = frame_of(m_sample, leaf);
    RadialFunction function = m_function;
    if constexpr (Has_unit<RadialFunction>::value)
      function.set_unit(frame.unit / m_unit_of_length);

    Points centres;
    Eigen::VectorXd data;
    std::vector<Eigen::Index> point_of; // by datum, the number of its point
    const bool has_off_surface_points = constraints(leaf, frame, settings.offset_factor, centres, data, point_of);
    result.record.number_of_centres = std::size_t(centres.cols());
    if (!has_off_surface_points || centres.cols() <= 4)
      return result;
    const Noise_covariance noise = noise_covariance(leaf, frame, function, std::move(point_of));
    for (const bool with_squares : {true, false})
    {
      const Vector normal = with_squares ? mean_normal(leaf) : Vector::Zero();
      if (with_squares && (normal.isZero(0) || centres.cols() <= 7))
        continue;
      const Polynomial_basis basis(normal);
      const Eigen::MatrixXd polynomials = basis.values(centres);
      const Polynomial_null_space<Eigen::MatrixXd> null_space(polynomials);
      if (with_squares && null_space.independence() < least_independence)
        continue;
      const Interpolation_coefficients solution =
          solve(centres, polynomials, null_space, function, settings.ridge, noise, data);
      result.record.relative_residual = solution.relative_residual;
      result.record.condition = solution.condition;
      result.record.solver = solution.solver;
      if (solution.solver == Solver::FAILED)
        continue;
      const Eigen::VectorXd missed = settings.ridge * solution.weights + noise.times(solution.weights);
      result.record.value_residual = frame.unit * (solution.relative_residual * data.template lpNorm<Eigen::Infinity>() +
                                                   missed.template lpNorm<Eigen::Infinity>());
      result.interpolant = Interpolant(frame, centres, solution.weights, basis.combination(solution.polynomial), function);
      break;
    }
    return result;
  }

private:
  // The scale of the interpolant is less than that of the heights, which know nothing of the slopes that off-surface points tell.
  // Factors of 3 to 10 measured alike, more on the smoothest of shapes.
  static constexpr double excess_of_scale = 7;
  // the variance of approximate points, over the variation of the kernel; .05 to 1 measured alike on simplified meshes
  static constexpr double share_of_variation = 0.2;
  // tau^2 where there are too few points to tell: that of a surface with a radius of about ten spacings
  static constexpr double variance_of_few_points = 0.01;

  Noise_covariance noise_covariance(const Blending_tree::Leaf& leaf, const Patch_frame& frame, const RadialFunction& function,
                                    std::vector<Eigen::Index> point_of) const
  {
    const double variance = std::pow(m_noise / frame.unit, 2);
    if (!(variance > 0))
      return approximation_covariance(leaf, frame, function, std::move(point_of));
    const auto likelihood = likelihood_of_heights<Eigen::MatrixXd>(m_sample, leaf, frame, function, Heights::for_scale());
    const double scale = likelihood ? likelihood->variance_of_function(variance) : variance_of_few_points;
    return Noise_covariance(std::vector<double>(leaf.points.size(), excess_of_scale * variance / scale), std::move(point_of));
  }

  // Approximate points have an error in proportion to what the function varies by over their spacing, aside from quadratic
  // polynomials. So waves shorter than a few spacings are averaged, and others stay, whatever the unit and the kernel.
  Noise_covariance approximation_covariance(const Blending_tree::Leaf& leaf, const Patch_frame& frame,
                                            const RadialFunction& function, std::vector<Eigen::Index> point_of) const
  {
    if (m_sample.data.empty())
      return Noise_covariance();
    std::vector<double> variances;
    bool is_exact = true;
    for (const std::size_t i : leaf.points)
      if (m_sample.datum(i) != Datum::NONE)
      {
        const bool is_approximate = m_sample.datum(i) == Datum::APPROXIMATE;
        variances.push_back(is_approximate ? share_of_variation * variation(function, m_sample.spacings[i] / frame.unit) : 0.);
        is_exact = is_exact && !is_approximate;
      }
    return is_exact ? Noise_covariance() : Noise_covariance(std::move(variances), std::move(point_of));
  }

  // of the kernel over a length: the difference from which squares cancel. It is 4/3 length^3 for the kernel r^3.
  static double variation(const RadialFunction& function, const double length)
  {
    const auto value = [&](const double r) { return function(r * r).value; };
    return std::abs(value(0) - 4. / 3 * value(length) + 1. / 3 * value(2 * length));
  }

  Interpolation_coefficients solve(const Points& centres, const Eigen::MatrixXd& polynomials,
                                   const Polynomial_null_space<Eigen::MatrixXd>& null_space, const RadialFunction& function,
                                   const double ridge, const Noise_covariance& noise, const Eigen::VectorXd& data) const
  {
    if constexpr (Has_compact_support<RadialFunction>::value)
    {
      static_assert(RadialFunction::order == 0, "a function of compact support is expected to be positive definite");
      if (centres.cols() >= least_sparse_size && density_of_interpolation_matrix(centres, function) < largest_density)
      {
        auto matrix = sparse_interpolation_matrix(centres, function, ridge);
        noise.add_to(matrix);
        Interpolation_coefficients solution = Sparse_interpolation_system(matrix, polynomials).solve(data);
        if (solution.solver != Solver::FAILED || centres.cols() > largest_dense_size)
          return solution;
      }
    }
    const auto matrix = [&]
    {
      Eigen::MatrixXd result = interpolation_matrix(centres, function, ridge);
      noise.add_to(result);
      return result;
    };
    Interpolation_coefficients result = Interpolation_system<Eigen::MatrixXd>(matrix, polynomials, null_space).solve(data);
    result.weights *= RadialFunction::sign;
    return result;
  }

  // the normalised mean normal of the points that have normals; zero if these look in too many directions
  Vector mean_normal(const Blending_tree::Leaf& leaf) const
  {
    Vector sum = Vector::Zero();
    double number = 0;
    for (const std::size_t i : leaf.points)
    {
      sum += m_sample.normals[i];
      number += m_sample.normals[i].isZero(0) ? 0 : 1;
    }
    return sum.norm() > least_mean_normal * number ? Vector(sum.normalized()) : Vector(Vector::Zero());
  }

  // the centres and the data of a patch in the coordinates of its frame, and the points that the data belong to
  bool constraints(const Blending_tree::Leaf& leaf, const Patch_frame& frame, const double offset_factor, Points& centres,
                   Eigen::VectorXd& data, std::vector<Eigen::Index>& point_of) const
  {
    std::vector<std::size_t> points;                         // those that say something
    std::vector<std::pair<std::size_t, double>> off_surface; // number among them, offset
    for (std::size_t l = 0; l < leaf.points.size(); ++l)
    {
      const std::size_t i = leaf.points[l], k = points.size();
      if (m_sample.datum(i) == Datum::NONE)
        continue;
      points.push_back(i);
      if (leaf.has_offset[l])
      {
        if (m_offsets.outer(i) > 0)
          off_surface.emplace_back(k, offset_factor * m_offsets.outer(i));
        if (m_offsets.inner(i) > 0)
          off_surface.emplace_back(k, -offset_factor * m_offsets.inner(i));
      }
    }
    centres.resize(3, Eigen::Index(points.size() + off_surface.size()));
    data = Eigen::VectorXd::Zero(centres.cols());
    Eigen::Index next = 0;
    for (const std::size_t i : points)
    {
      point_of.push_back(next);
      centres.col(next++) = frame(m_sample.points[i]);
    }
    for (const auto& [k, offset] : off_surface)
    {
      const std::size_t i = points[k];
      point_of.push_back(Eigen::Index(k));
      centres.col(next) = frame(m_sample.points[i] + offset * m_sample.normals[i]);
      data[next++] = offset / frame.unit;
    }
    return !off_surface.empty();
  }

  const Surface_sample& m_sample;
  const Offsets& m_offsets;
  const RadialFunction m_function;
  const double m_unit_of_length, m_noise;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_SOLVER_H
