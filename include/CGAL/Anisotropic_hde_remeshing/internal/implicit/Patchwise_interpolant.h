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
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_check.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Off_surface_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patch_check.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patch_solver.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/shares_of_construction.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The function s of the paper's Algorithm 1 in plain numbers. Each patch has a local interpolant that is checked and repaired.
// The tree blends these. Far from the points the function is the signed distance to the input.
template <typename RadialFunction, typename ConcurrencyTag>
class Patchwise_interpolant
{
  typedef Local_interpolant<RadialFunction> Interpolant;
  typedef Off_surface_points<ConcurrencyTag> Offsets;
  typedef Patch_solver<RadialFunction, ConcurrencyTag> Solver_of_patch;
  typedef std::shared_ptr<const Surface_sample> Sample_ptr;
  typedef std::shared_ptr<const Signed_distance> Distance_ptr;

  // largest number of points of a patch, over that of a patch in the plane
  static constexpr double largest_excess_of_points = 2;
  // a dense system of twice as many centres is the largest that is solved in seconds
  static constexpr std::size_t largest_dense_patch = 3000;

  // The function passes from the interpolant to the signed distance from here to there, in units of the local spacing. The
  // constraints reach one spacing from the points at most; two are checked.
  static constexpr double begin_of_far = 2.5, end_of_far = 3.5;
  // The same in units of the support of the kernel. Beyond the support the interpolant says nothing.
  static constexpr double begin_of_support_end = 0.25, end_of_support_end = 0.4;

  // largest share of failed checks of a patch; beyond it, the input itself is better than the interpolant
  static constexpr double largest_share_of_failures = 0.05;
  // the same of a patch with points on facets: facets so large are a good answer
  static constexpr double largest_share_on_facets = 0.02;
  // beyond this share no repair is tried
  static constexpr double largest_repairable_share = 0.1;
  // how often points are added where the zero set leaves the facets
  static constexpr int rounds_of_refinement = 2;
  // stands for a number of failures
  static constexpr std::size_t no_solution = std::size_t(1) << 40;

public:
  Patchwise_interpolant(Sample_ptr sample, Distance_ptr distance, const Interpolation_parameters& parameters,
                        const RadialFunction& function, double unit_of_length, Interruption& interruption);

  template <int order>
  Jet<order> evaluate(const Vector& p) const
  {
    Distance_at distance(*m_distance, p);
    return m_tree.blend(p, [&](const std::size_t k) { return evaluate_patch<order>(m_patches[k], distance); });
  }

  const Blending_tree& tree() const { return m_tree; }

  // that of the constructor, with the points that were added
  const Surface_sample& sample() const { return *m_sample; }

  const Rbf_diagnostics& diagnostics() const { return m_diagnostics; }

private:
  struct Patch
  {
    Interpolant interpolant;
    bool is_on_fallback = false;
    double begin_of_far = 0, end_of_far = 0; // in the unit of the interpolant
  };

  // for each leaf, the numbers of the places of Patch_check at which the leaf counts
  typedef std::vector<std::vector<std::size_t>> Places;

  struct Patch_result
  {
    Patch_record record;
    std::size_t failures = 0;
    bool is_repaired = false;
  };

  // A patch of n points in the plane is about sqrt(n) spacings wide, and gathers points over its margins on either side.
  std::size_t maximum_points_of_patch(const std::size_t number_of_patches, const Interpolation_parameters& parameters) const
  {
    const double own_points = double(m_sample->size()) / double(number_of_patches);
    const double width = std::sqrt(own_points) + 2 * (parameters.patch_blending + parameters.patch_overlap);
    const std::size_t maximum = std::size_t(largest_excess_of_points * width * width);
    return Has_compact_support<RadialFunction>::value ? maximum : (std::min)(maximum, largest_dense_patch);
  }

  // solves these patches
  void solve(const Solver_of_patch& solver, const Places& places, const Interpolation_parameters& parameters,
             const std::vector<std::size_t>& leaves, std::vector<Patch_result>& results, Interruption& interruption)
  {
    parallel_for<ConcurrencyTag>(
        leaves.size(),
        [&](const std::size_t k)
        {
          m_patches[leaves[k]] = Patch();
          results[leaves[k]] = solve_patch(solver, places, parameters, leaves[k]);
          interruption.end_parts(1);
        },
        1, interruption);
    interruption.check();
  }

  // Solves all patches. Where the zero set is too far from the facets after that, it adds points there and solves the patches
  // around once more. Where it still is in the end, the facets answer.
  void solve(Offsets& offsets, const RadialFunction& function, const double unit_of_length,
             const Interpolation_parameters& parameters, Interruption& interruption)
  {
    const std::size_t n = m_tree.leaves().size();
    m_patches.resize(n);
    const Places places = places_of_leaves();
    std::vector<Patch_result> results(n);
    std::vector<std::size_t> changed(n);
    std::iota(changed.begin(), changed.end(), std::size_t(0));
    const bool has_check = parameters.uses_facets && !m_sample->facets.empty();
    const double share_of_solution = has_check ? share_of_first_solution : share_of_last_solution;
    interruption.begin_parts(n, share_of_solution);
    solve(Solver_of_patch(*m_sample, offsets, function, unit_of_length, m_noise), places, parameters, changed, results,
          interruption);
    interruption.report(share_of_solution);
    if (has_check)
    {
      const Facet_edges edges(*m_sample);
      const Facet_check check(*m_sample, edges);
      for (int round = 0; round < rounds_of_refinement && !changed.empty(); ++round)
      {
        changed = refine(check, failed_places(check, changed, interruption), interruption);
        interruption.report(round == 0 ? share_of_check : share_of_last_solution);
        offsets = Offsets(*m_sample, m_tree, parameters.relative_offset, parameters.absolute_offset,
                          parameters.offsets_on_both_sides, interruption);
        solve(Solver_of_patch(*m_sample, offsets, function, unit_of_length, m_noise), places, parameters, changed, results,
              interruption);
      }
      answer_by_facets(check, failed_places(check, changed, interruption), results);
    }
    summarise(results);
  }

  // those at which one of the changed patches counts, and at which the zero set is too far; sorted
  std::vector<std::size_t> failed_places(const Facet_check& check, const std::vector<std::size_t>& changed,
                                         Interruption& interruption) const
  {
    std::vector<std::size_t> result;
    if (changed.empty())
      return result;
    std::vector<char> is_changed(m_patches.size(), 0), has_failed(check.size(), 0);
    for (const std::size_t k : changed)
      is_changed[k] = 1;
    parallel_for<ConcurrencyTag>(
        check.size(),
        [&](const std::size_t i)
        {
          const Facet_check::Place place = check.place(i);
          bool counts = false;
          if (place.bound > 0)
            m_tree.visit_leaves(place.point, [&](const std::size_t k) { counts = counts || is_changed[k]; });
          has_failed[i] = counts && !(std::abs(evaluate<0>(place.point).value) <= place.bound);
        },
        64, interruption);
    interruption.check();
    for (std::size_t i = 0; i < check.size(); ++i)
      if (has_failed[i])
        result.push_back(i);
    return result;
  }

  // Makes points of failed places. Returns the patches that have new points.
  std::vector<std::size_t> refine(const Facet_check& check, const std::vector<std::size_t>& failed, Interruption& interruption)
  {
    std::vector<std::size_t> changed;
    if (failed.empty())
      return changed;
    const auto refined = std::make_shared<Surface_sample>(*m_sample);
    add_places<ConcurrencyTag>(check, check.to_refine(failed), *refined, interruption);
    for (std::size_t i = m_sample->size(); i < refined->size(); ++i)
      m_tree.add_point(*refined, i, [&](const std::size_t k) { changed.push_back(k); });
    m_diagnostics.number_of_refined_places += refined->size() - m_sample->size();
    m_sample = refined;
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
  }

  // The facets answer for the patches that are too far at these places.
  void answer_by_facets(const Facet_check& check, const std::vector<std::size_t>& failed, std::vector<Patch_result>& results)
  {
    for (const std::size_t number : failed)
    {
      const Facet_check::Place place = check.place(number);
      Distance_at distance(*m_distance, place.point);
      m_tree.visit_leaves(place.point,
                          [&](const std::size_t k)
                          {
                            if (m_patches[k].is_on_fallback ||
                                std::abs(evaluate_patch<0>(m_patches[k], distance).value) <= place.bound)
                              return;
                            ++m_diagnostics.patches_off_facets;
                            m_patches[k].is_on_fallback = true;
                            m_patches[k].interpolant = Interpolant();
                            results[k].failures = 0;
                          });
    }
  }

  // Solves a patch and checks it. If it fails, tries smaller offsets, smoothing, and smoothing with a wider view. Each is kept if it
  // at least halves the failures. If that is not good enough either, the input itself answers for the patch.
  Patch_result solve_patch(const Solver_of_patch& solver, const Places& places, const Interpolation_parameters& parameters,
                           const std::size_t k)
  {
    static constexpr double smaller_offset = 0.25, repairing_ridge = 0.01, wider_overlap = 5. / 3;
    const Blending_tree::Leaf& leaf = m_tree.leaves()[k];
    Patch_result best = attempt(solver, places, k, leaf, Patch_settings(), m_patches[k]);
    const double number_of_checks = double(Patch_check::checks_of_place * places[k].size());
    const auto attempt_again = [&](const Blending_tree::Leaf& points, const Patch_settings& settings)
    {
      if (best.failures == 0 || double(best.failures) > largest_repairable_share * number_of_checks)
        return;
      Patch patch;
      const Patch_result result = attempt(solver, places, k, points, settings, patch);
      if (2 * result.failures > best.failures)
        return;
      best = result;
      best.is_repaired = true;
      m_patches[k] = std::move(patch);
    };
    attempt_again(leaf, Patch_settings{smaller_offset, 0});
    attempt_again(leaf, Patch_settings{1, repairing_ridge});
    if (best.failures > 0)
      attempt_again(m_tree.widened_leaf(*m_sample, k, wider_overlap * parameters.patch_overlap),
                    Patch_settings{1, repairing_ridge});
    const bool is_on_facets =
        leaf.own_points.back() >= m_sample->size() - m_sample->number_of_points_on_facets; // they are the last ones
    if (double(best.failures) > (is_on_facets ? largest_share_on_facets : largest_share_of_failures) * number_of_checks)
    {
      m_patches[k].is_on_fallback = true;
      m_patches[k].interpolant = Interpolant();
      best.failures = 0;
    }
    return best;
  }

  // one solution of a patch; without a solution, the number of its failures is `no_solution`
  Patch_result attempt(const Solver_of_patch& solver, const Places& places, const std::size_t k,
                       const Blending_tree::Leaf& leaf, const Patch_settings& settings, Patch& patch) const
  {
    Patch_result result;
    Solved_patch<RadialFunction> solved = solver(leaf, settings);
    result.record = solved.record;
    patch.is_on_fallback = solved.record.solver == Solver::FAILED;
    patch.interpolant = std::move(solved.interpolant);
    set_far(m_tree.leaves()[k], patch);
    result.failures = patch.is_on_fallback ? no_solution : number_of_failures(places, k, patch);
    return result;
  }

  std::size_t number_of_failures(const Places& places, const std::size_t k, const Patch& patch) const
  {
    const Patch_check check(*m_sample, *m_distance, m_noise);
    const auto jet = [&](const Vector& p)
    {
      Distance_at distance(*m_distance, p);
      return evaluate_patch<1>(patch, distance);
    };
    const auto value = [&](const Vector& p)
    {
      Distance_at distance(*m_distance, p);
      return evaluate_patch<0>(patch, distance).value;
    };
    std::size_t failures = 0;
    for (const std::size_t number : places[k])
      failures += check.failures(check.place(number), parity(number), jet, value);
    return failures;
  }

  void set_far(const Blending_tree::Leaf& leaf, Patch& patch) const
  {
    double largest_spacing = 0;
    for (const std::size_t i : leaf.own_points)
      largest_spacing = (std::max)(largest_spacing, m_sample->spacings[i]);
    patch.begin_of_far = begin_of_far * largest_spacing / patch.interpolant.unit();
    patch.end_of_far = end_of_far * largest_spacing / patch.interpolant.unit();
    if constexpr (Has_compact_support<RadialFunction>::value)
    {
      const double support = patch.interpolant.function().support_radius();
      patch.begin_of_far = (std::min)(patch.begin_of_far, begin_of_support_end * support);
      patch.end_of_far = (std::min)(patch.end_of_far, end_of_support_end * support);
    }
  }

  // the number of the facet or the point, and one more for each further place
  std::size_t parity(const std::size_t number) const { return m_sample->facets.empty() ? number : number / 4 + number % 4; }

  Places places_of_leaves() const
  {
    Places result(m_tree.leaves().size());
    Patch_check(*m_sample, *m_distance, m_noise)
        .visit_places([&](const std::size_t number, const Patch_check::Place& place)
                      { m_tree.visit_leaves(place.point, [&](const std::size_t k) { result[k].push_back(number); }); });
    return result;
  }

  template <int order>
  Jet<order> evaluate_patch(const Patch& patch, Distance_at& distance) const
  {
    if (patch.is_on_fallback)
      return constant_beyond_gradient<order>(distance.with_interpolated_normals());
    const Vector& p = distance.point();
    double squared_distance;
    Jet<order> near = patch.interpolant.template evaluate<order>(p, squared_distance);
    if (squared_distance <= patch.begin_of_far * patch.begin_of_far)
      return near;
    Jet<order> far = constant_beyond_gradient<order>(distance.distance());
    // the smooth distance is two thirds of the true one at least
    if (squared_distance >= 2.25 * patch.end_of_far * patch.end_of_far)
      return far;
    Jet<order> t = patch.interpolant.template smooth_distance<order>(p, squared_distance);
    if (t.value <= patch.begin_of_far)
      return near;
    if (t.value >= patch.end_of_far)
      return far;
    const double width = patch.end_of_far - patch.begin_of_far;
    t = composed((t.value - patch.begin_of_far) / width, 1. / width, 0., t);
    return interpolated(near, far, smoothstep(t));
  }

  // A distance is linear, except for the curvature of what it is measured to. So its Hessian is left at zero.
  template <int order>
  static Jet<order> constant_beyond_gradient(const Value_and_gradient& jet)
  {
    Jet<order> result;
    result.value = jet.value;
    if constexpr (order >= 1)
      result.gradient = jet.gradient;
    return result;
  }

  void summarise(const std::vector<Patch_result>& results)
  {
    m_diagnostics.number_of_patches = results.size();
    m_diagnostics.memory_bytes = m_tree.memory_bytes() + memory_bytes_of(*m_sample);
    for (std::size_t k = 0; k < results.size(); ++k)
    {
      const Patch_record& record = results[k].record;
      m_diagnostics.mean_centres += double(record.number_of_centres) / double(results.size());
      m_diagnostics.max_centres = (std::max)(m_diagnostics.max_centres, record.number_of_centres);
      m_diagnostics.memory_bytes += m_patches[k].interpolant.memory_bytes();
      m_diagnostics.number_of_failed_checks += results[k].failures;
      if (m_patches[k].is_on_fallback)
      {
        ++m_diagnostics.patches_on_fallback;
        continue;
      }
      m_diagnostics.worst_residual = (std::max)(m_diagnostics.worst_residual, record.relative_residual);
      m_diagnostics.worst_value_residual = (std::max)(m_diagnostics.worst_value_residual, record.value_residual);
      m_diagnostics.worst_condition = (std::max)(m_diagnostics.worst_condition, record.condition);
      m_diagnostics.patches_repaired += results[k].is_repaired ? 1 : 0;
      m_diagnostics.patches_with_ridge += record.solver == Solver::CHOLESKY_WITH_RIDGE ? 1 : 0;
      m_diagnostics.patches_with_sparse_cholesky += record.solver == Solver::SPARSE_CHOLESKY ? 1 : 0;
      m_diagnostics.patches_with_lu += record.solver == Solver::LU ? 1 : 0;
    }
  }

  Sample_ptr m_sample;
  Distance_ptr m_distance;
  Blending_tree m_tree;
  std::vector<Patch> m_patches;
  Rbf_diagnostics m_diagnostics;
  double m_noise; // standard deviation of that of the points
};

template <typename RadialFunction, typename ConcurrencyTag>
Patchwise_interpolant<RadialFunction, ConcurrencyTag>::Patchwise_interpolant(Sample_ptr sample, Distance_ptr distance,
                                                                             const Interpolation_parameters& parameters,
                                                                             const RadialFunction& function,
                                                                             const double unit_of_length,
                                                                             Interruption& interruption)
  : m_sample(std::move(sample)), m_distance(std::move(distance)), m_noise(parameters.noise)
{
  Real_timer timer;
  timer.start();
  const std::size_t number_of_patches =
      parameters.number_of_patches > 0 ? parameters.number_of_patches : Interpolation_parameters::patches_of(m_sample->size());
  m_tree = Blending_tree(ConcurrencyTag(), *m_sample, number_of_patches, parameters.patch_blending, parameters.patch_overlap,
                         maximum_points_of_patch(number_of_patches, parameters), interruption);
  m_diagnostics.partition_seconds = timer.time();
  interruption.report(share_of_partition);
  timer.reset();
  Offsets offsets(*m_sample, m_tree, parameters.relative_offset, parameters.absolute_offset, parameters.offsets_on_both_sides,
                  interruption);
  m_diagnostics.constraint_seconds = timer.time();
  interruption.report(share_of_offsets);
  timer.reset();
  solve(offsets, function, unit_of_length, parameters, interruption);
  m_diagnostics.solve_seconds = timer.time();
  m_diagnostics.number_of_shortened_offsets = offsets.number_of_shortened_offsets();
  m_tree.release_points();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_PATCHWISE_INTERPOLANT_H
