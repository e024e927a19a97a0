// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCHWISE_INTERPOLANT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCHWISE_INTERPOLANT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Blending_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Interpolation_system.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Local_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Off_surface_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Tangent_plane_blend.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the parameters of the interpolant, checked; lengths in units of the local spacing but for the absolute offset
struct Interpolation_parameters
{
  std::size_t number_of_patches = 0; // 0: one a number of points that measured best
  double patch_overlap = 3;
  double patch_blending = 0.6;
  double relative_offset = 0.05;
  double absolute_offset = 0; // 0: the relative one
};

// The function s of the paper's Algorithm 1 in plain numbers: a local interpolant a patch, blended by the tree.
template <typename RadialFunction, typename ConcurrencyTag>
class Patchwise_interpolant
{
  typedef Local_interpolant<RadialFunction> Interpolant;
  typedef Off_surface_points<ConcurrencyTag> Offsets;

  static constexpr std::size_t points_per_patch = 25;
  // of the points that a patch in the plane would have
  static constexpr double largest_excess_of_points = 2;

public:
  Patchwise_interpolant(const Surface_sample& sample, const Interpolation_parameters& parameters,
                        const RadialFunction& function)
  {
    Real_timer timer;
    timer.start();
    const std::size_t number_of_patches = parameters.number_of_patches > 0
                                              ? parameters.number_of_patches
                                              : (sample.size() + points_per_patch - 1) / points_per_patch;
    const std::size_t maximum_size = maximum_points_of_patch(double(sample.size()) / double(number_of_patches), parameters);
    m_tree = Blending_tree(sample, number_of_patches, parameters.patch_blending, parameters.patch_overlap, maximum_size);
    m_diagnostics.partition_seconds = timer.time();
    timer.reset();
    const Offsets offsets(sample, m_tree, parameters.relative_offset, parameters.absolute_offset);
    m_diagnostics.constraint_seconds = timer.time();
    timer.reset();
    solve(sample, offsets, function);
    m_diagnostics.solve_seconds = timer.time();
    m_diagnostics.number_of_points = sample.size();
    m_diagnostics.number_of_isolated_vertices = sample.number_of_isolated_vertices;
    m_diagnostics.number_of_duplicate_points = sample.number_of_duplicate_points;
    m_diagnostics.number_of_shortened_offsets = offsets.number_of_shortened_offsets();
    m_tree.release_points();
  }

  Value_and_gradient operator()(const Vector& p) const
  {
    return m_tree.blend(p, [&](const std::size_t k) { return m_patches[k](p); });
  }

  const Rbf_diagnostics& diagnostics() const { return m_diagnostics; }

private:
  struct Patch
  {
    Interpolant interpolant;
    Tangent_plane_blend fallback; // empty unless the interpolant could not be found

    Value_and_gradient operator()(const Vector& p) const { return fallback.empty() ? interpolant(p) : fallback(p); }
  };

  // what a patch tells the diagnostics
  struct Patch_record
  {
    std::size_t number_of_centres = 0;
    double relative_residual = 0;
    Solver solver = Solver::FAILED;
  };

  // A patch of n points in the plane is about sqrt(n) spacings wide, and gathers points over its margins on either side.
  static std::size_t maximum_points_of_patch(const double own_points, const Interpolation_parameters& parameters)
  {
    const double width = std::sqrt(own_points) + 2 * (parameters.patch_blending + parameters.patch_overlap);
    return std::size_t(largest_excess_of_points * width * width);
  }

  void solve(const Surface_sample& sample, const Offsets& offsets, const RadialFunction& function)
  {
    const std::size_t n = m_tree.leaves().size();
    m_patches.resize(n);
    std::vector<Patch_record> records(n);
    parallel_for<ConcurrencyTag>(
        n,
        [&](const std::size_t k)
        { records[k] = solve_patch(sample, offsets, function, m_tree.leaves()[k], m_patches[k]); },
        1);
    summarise(records);
  }

  static Patch_record solve_patch(const Surface_sample& sample, const Offsets& offsets, const RadialFunction& function,
                                  const Blending_tree::Leaf& leaf, Patch& patch)
  {
    Vector low = sample.points[leaf.points.front()], high = low;
    for (const std::size_t i : leaf.points)
    {
      low = low.cwiseMin(sample.points[i]);
      high = high.cwiseMax(sample.points[i]);
    }
    const Vector centre = 0.5 * (low + high);
    const double radius = (std::max)(0.5 * (high - low).norm(), sample.spacings[leaf.points.front()]);

    Patch_record record;
    typename Interpolant::Points centres;
    Eigen::VectorXd data;
    const bool has_off_surface_points = constraints(sample, offsets, leaf, centre, radius, centres, data);
    record.number_of_centres = std::size_t(centres.cols());
    if (has_off_surface_points && centres.cols() > 4)
    {
      const Interpolation_coefficients solution = Interpolation_system<RadialFunction>(centres, function).solve(data);
      record.relative_residual = solution.relative_residual;
      record.solver = solution.solver;
      if (solution.solver != Solver::FAILED)
        patch.interpolant =
            Interpolant(centre, radius, centres, solution.weights, solution.polynomial, function);
    }
    if (record.solver == Solver::FAILED)
      patch.fallback = Tangent_plane_blend(sample, leaf.points);
    return record;
  }

  // the centres and the data of a patch in the coordinates of its unit ball, the paper's (12)
  static bool constraints(const Surface_sample& sample, const Offsets& offsets, const Blending_tree::Leaf& leaf,
                          const Vector& centre, const double radius, typename Interpolant::Points& centres,
                          Eigen::VectorXd& data)
  {
    std::vector<std::size_t> off_surface;
    for (std::size_t k = 0; k < leaf.points.size(); ++k)
      if (leaf.has_offset[k] && offsets.offset(leaf.points[k]) > 0)
        off_surface.push_back(leaf.points[k]);
    centres.resize(3, Eigen::Index(leaf.points.size() + off_surface.size()));
    data = Eigen::VectorXd::Zero(centres.cols());
    Eigen::Index next = 0;
    for (const std::size_t i : leaf.points)
      centres.col(next++) = (sample.points[i] - centre) / radius;
    for (const std::size_t i : off_surface)
    {
      centres.col(next) = (sample.points[i] - centre + offsets.offset(i) * sample.normals[i]) / radius;
      data[next++] = offsets.offset(i) / radius;
    }
    return !off_surface.empty();
  }

  void summarise(const std::vector<Patch_record>& records)
  {
    m_diagnostics.number_of_patches = records.size();
    for (const Patch_record& record : records)
    {
      m_diagnostics.mean_centres += double(record.number_of_centres) / double(records.size());
      m_diagnostics.max_centres = (std::max)(m_diagnostics.max_centres, record.number_of_centres);
      if (record.solver != Solver::FAILED)
        m_diagnostics.worst_residual = (std::max)(m_diagnostics.worst_residual, record.relative_residual);
      m_diagnostics.patches_with_ridge += record.solver == Solver::CHOLESKY_WITH_RIDGE ? 1 : 0;
      m_diagnostics.patches_with_lu += record.solver == Solver::LU ? 1 : 0;
      m_diagnostics.patches_on_fallback += record.solver == Solver::FAILED ? 1 : 0;
    }
    for (const Patch& patch : m_patches)
      m_diagnostics.memory_bytes += patch.interpolant.memory_bytes() + patch.fallback.memory_bytes();
  }

  Blending_tree m_tree;
  std::vector<Patch> m_patches;
  Rbf_diagnostics m_diagnostics;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCHWISE_INTERPOLANT_H
