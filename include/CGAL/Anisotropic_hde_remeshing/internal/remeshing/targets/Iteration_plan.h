// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ITERATION_PLAN_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ITERATION_PLAN_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// How the iterations of the default scheme aim at a number of faces.
class Iteration_plan
{
  // The default scheme aims alternately at a little fewer and a little more faces than asked for, and flips edges towards
  // valence six. So it contracts and splits edges where the mesh is least regular. This anneals the connectivity: on an
  // ellipsoid the share of valence six rises from 73 to 81%, the mean of the smallest angles from 51.6 to 53.7 degrees. The
  // last iterations settle at the number asked for, and flip towards larger angles.
  static constexpr double alternation = 0.07;
  // A mesh with little to split or contract may be a grid of right triangles, where no operation finds anything to do. So the
  // first iteration disturbs it by more. The mean of the smallest angles of a torus of 131,072 faces is 50.8 degrees without
  // this and 53.5 with it; of an ellipsoid from 81,920 to 40,000 faces 51.3 and 53.5. To refine a mesh disturbs it enough.
  static constexpr double first_alternation = 0.4;
  static constexpr double largest_ratio_to_right_number = 2.5, smallest_ratio_to_right_number = 0.67;
  static constexpr unsigned int settling_share = 6; // one iteration in this many settles, rounded up
  // When a mesh is coarsened, the edges that the thresholds leave are shorter than the target on average. So the length to
  // which the thresholds refer starts larger by this factor. Later it follows the number of faces that results.
  static constexpr double first_length_factor = 1.05;
  static constexpr double feedback = 0.25;
  static constexpr double largest_feedback_ratio = 1.3;
  // Creases may keep more vertices than the mesh shall have. The rest of the mesh is not given up for them: the length stays
  // near the one that the area asks for.
  static constexpr double largest_length_factor_with_creases = 1.2;

public:
  explicit Iteration_plan(const unsigned int number_of_iterations) : m_number_of_iterations(number_of_iterations) {}

  // ends an iteration
  void advance() { ++m_iteration; }

  unsigned int iteration() const { return m_iteration; }
  bool is_first() const { return m_iteration == 0; }
  bool is_done() const { return m_iteration >= m_number_of_iterations; }

  // How many iterations are to be done when the faces are looked at next, to see whether they intersect. Most that can go wrong does so
  // in the first iterations, and where sheets are near.
  unsigned int iterations_at_next_check(const bool has_near_sheets) const
  {
    return (std::min)((std::max)((has_near_sheets ? 2 : 4) * m_iteration, 1u), m_number_of_iterations);
  }

  // whether the iteration is one of the last ones, which settle at the number of faces asked for
  bool is_settling() const { return m_iteration + number_of_settling_iterations() >= m_number_of_iterations; }

  // The share of the whole that is done. `share` is that of this iteration.
  double progress(const double share) const { return (m_iteration + share) / m_number_of_iterations; }

  // What this iteration aims at, over the number of faces asked for. `ratio` is that of the mesh. The last alternation aims at
  // fewer faces: that measures better than more.
  double alternating_factor(const double ratio) const
  {
    if (is_settling())
      return 1;
    if (is_first() && ratio < largest_ratio_to_right_number && ratio > smallest_ratio_to_right_number)
      return 1 + first_alternation;
    const unsigned int to_go = m_number_of_iterations - number_of_settling_iterations() - m_iteration;
    return to_go % 2 == 0 ? 1 + alternation : 1 - alternation;
  }

  // the factor of the length to which the thresholds refer
  double length_factor() const { return m_length_factor; }

  // `ratio` is that of the number of faces to the one aimed at
  void follow_number_of_faces(const double ratio)
  {
    if (!is_settling())
      m_length_factor *= std::pow((std::min)((std::max)(ratio, 1 / largest_feedback_ratio), largest_feedback_ratio), feedback);
  }

  void limit_length_by_creases() { m_length_factor = (std::min)(m_length_factor, largest_length_factor_with_creases); }

private:
  unsigned int number_of_settling_iterations() const { return (m_number_of_iterations + settling_share - 1) / settling_share; }

  unsigned int m_number_of_iterations;
  unsigned int m_iteration = 0;
  double m_length_factor = first_length_factor;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_ITERATION_PLAN_H
