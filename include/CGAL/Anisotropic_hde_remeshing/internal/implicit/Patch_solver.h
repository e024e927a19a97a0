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
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Off_surface_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Sparse_interpolation_system.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_matrix.h>

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
  double smoothing = 0;
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

// Interpolates the data of a patch, the paper's (12): 0 at its points, +-eps_i at the off-surface points.
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
  // `unit_of_length` is that of the caller in the coordinates of the sample
  Patch_solver(const Surface_sample& sample, const Offsets& offsets, const RadialFunction& function,
               const double unit_of_length)
    : m_sample(sample), m_offsets(offsets), m_function(function), m_unit_of_length(unit_of_length)
  {
  }

  Solved_patch<RadialFunction> operator()(const Blending_tree::Leaf& leaf, const Patch_settings& settings) const
  {
    Solved_patch<RadialFunction> result;
    const Patch_frame frame = frame_of(leaf);
    RadialFunction function = m_function;
    if constexpr (Has_unit<RadialFunction>::value)
      function.set_unit(frame.unit / m_unit_of_length);

    Points centres;
    Eigen::VectorXd data;
    const bool has_off_surface_points = constraints(leaf, frame, settings.offset_factor, centres, data);
    result.record.number_of_centres = std::size_t(centres.cols());
    if (!has_off_surface_points || centres.cols() <= 4)
      return result;
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
      const Interpolation_coefficients solution = solve(centres, polynomials, null_space, function, settings.smoothing, data);
      result.record.relative_residual = solution.relative_residual;
      result.record.condition = solution.condition;
      result.record.solver = solution.solver;
      if (solution.solver == Solver::FAILED)
        continue;
      result.record.value_residual = frame.unit * (solution.relative_residual * data.template lpNorm<Eigen::Infinity>() +
                                                   settings.smoothing * solution.weights.template lpNorm<Eigen::Infinity>());
      result.interpolant = Interpolant(frame, centres, solution.weights, basis.combination(solution.polynomial), function);
      break;
    }
    return result;
  }

private:
  Interpolation_coefficients solve(const Points& centres, const Eigen::MatrixXd& polynomials,
                                   const Polynomial_null_space<Eigen::MatrixXd>& null_space, const RadialFunction& function,
                                   const double smoothing, const Eigen::VectorXd& data) const
  {
    if constexpr (Has_compact_support<RadialFunction>::value)
    {
      static_assert(RadialFunction::order == 0, "a function of compact support is expected to be positive definite");
      if (centres.cols() >= least_sparse_size && density_of_interpolation_matrix(centres, function) < largest_density)
      {
        const auto matrix = sparse_interpolation_matrix(centres, function, smoothing);
        Interpolation_coefficients solution = Sparse_interpolation_system(matrix, polynomials).solve(data);
        if (solution.solver != Solver::FAILED || centres.cols() > largest_dense_size)
          return solution;
      }
    }
    const auto matrix = [&] { return interpolation_matrix(centres, function, smoothing); };
    Interpolation_coefficients result = Interpolation_system<Eigen::MatrixXd>(matrix, polynomials, null_space).solve(data);
    result.weights *= RadialFunction::sign;
    return result;
  }

  // Its centre is that of the box of the points. Its unit is the median of the spacings of the points in its own cell.
  Patch_frame frame_of(const Blending_tree::Leaf& leaf) const
  {
    Vector low = m_sample.points[leaf.points.front()], high = low;
    for (const std::size_t i : leaf.points)
    {
      low = low.cwiseMin(m_sample.points[i]);
      high = high.cwiseMax(m_sample.points[i]);
    }
    std::vector<double> spacings;
    for (const std::size_t i : leaf.own_points)
      spacings.push_back(m_sample.spacings[i]);
    const auto median = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
    std::nth_element(spacings.begin(), median, spacings.end());
    return Patch_frame{0.5 * (low + high), *median};
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

  // the centres and the data of a patch in the coordinates of its frame
  bool constraints(const Blending_tree::Leaf& leaf, const Patch_frame& frame, const double offset_factor, Points& centres,
                   Eigen::VectorXd& data) const
  {
    std::vector<std::pair<std::size_t, double>> off_surface;
    for (std::size_t k = 0; k < leaf.points.size(); ++k)
      if (leaf.has_offset[k])
      {
        const std::size_t i = leaf.points[k];
        if (m_offsets.outer(i) > 0)
          off_surface.emplace_back(i, offset_factor * m_offsets.outer(i));
        if (m_offsets.inner(i) > 0)
          off_surface.emplace_back(i, -offset_factor * m_offsets.inner(i));
      }
    centres.resize(3, Eigen::Index(leaf.points.size() + off_surface.size()));
    data = Eigen::VectorXd::Zero(centres.cols());
    Eigen::Index next = 0;
    for (const std::size_t i : leaf.points)
      centres.col(next++) = frame(m_sample.points[i]);
    for (const auto& [i, offset] : off_surface)
    {
      centres.col(next) = frame(m_sample.points[i] + offset * m_sample.normals[i]);
      data[next++] = offset / frame.unit;
    }
    return !off_surface.empty();
  }

  const Surface_sample& m_sample;
  const Offsets& m_offsets;
  const RadialFunction m_function;
  const double m_unit_of_length;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCH_SOLVER_H
