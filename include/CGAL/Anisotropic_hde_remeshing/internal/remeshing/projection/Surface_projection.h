// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_PROJECTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_PROJECTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Moves points onto the zero set and gives them its normal. Newton's method along the gradient comes first, then bisection
// along the gradient at the start, then a descent along the gradient in small steps. If all fail, the closest point of the input
// is taken. Of a piecewise function, the piece of the given region counts. The class is thread-safe. The result for a point depends
// on nothing but the point.
template <typename ImplicitFunction>
class Surface_projection
{
public:
  typedef ImplicitFunction Function;

private:
  // The distance to the zero set that exact projections reach, over the diagonal. One more step of Newton's method squares it.
  static constexpr double exact_distance = 1e-9;
  static constexpr int newton_steps = 8;
  static constexpr int bisection_steps = 60;
  static constexpr int descent_steps = 64;
  static constexpr double longest_descent = 0.1;  // of the diagonal
  static constexpr double least_coarseness = 1.5; // of a facet of the input, over the trust radius, half of an edge
  static constexpr double settled = 1e-4;         // of the exact distance: there Newton's method ends
  static constexpr double largest_jump = 10;      // of the exact distance: up to there a change of sign counts as a zero
  // squared sine of 15 degrees: two surfaces that meet at less have no well-defined curve in common
  static constexpr double smallest_squared_sine = 0.067;

public:
  Surface_projection(const Function& function, const Input_surface& input)
    : m_function(function),
      m_input(input),
      m_exact_distance(exact_distance * input.diagonal()),
      m_orientations(number_of_pieces(function), 1.)
  {
  }

  // the caller's mesh may be oriented against the gradient: then the normals are turned over
  void set_orientation(const Region region, const double sign) { m_orientations[region] = sign; }
  double orientation(const Region region) const { return m_orientations[region]; }

  const Function& function() const { return m_function; }
  const Input_surface& input() const { return m_input; }

  // Whether `project()` would hardly move the point. The limit for the last step is a thousand times the distance that counts
  // as exact, 1e-6 of the diagonal. After a last step Newton's method leaves a distance of its square times half a curvature.
  // At the limit that is 1e-9 of the diagonal where the curvature is 2000 over the diagonal.
  bool is_exact(const Vertex_state& state) const { return state.last_step <= 1e3 * m_exact_distance; }

  // whether the point is as near to the zero set as the worst of the exact projections, to first order
  bool is_on_surface(const Vertex_state& state, const Region region) const
  {
    const Value_and_gradient at_point = evaluate(state.point, region);
    // false if they are not numbers
    return std::abs(at_point.value) <= largest_jump * m_exact_distance * at_point.gradient.norm();
  }

  // moves the point onto the zero set, as near as doubles allow
  void project(Vertex_state& state, const Region region, const double trust_radius) const
  {
    project(state, region, trust_radius, m_exact_distance);
  }

  // Does only one evaluation if the start is nearer to the zero set than `good_distance`: Newton's step leaves a distance that
  // is quadratic in that of the start. This is good enough for the iterations, because vertices move again. The remesher
  // projects all of them exactly in the end.
  void project_roughly(Vertex_state& state, const Region region, const double trust_radius, const double good_distance) const
  {
    project(state, region, trust_radius, good_distance);
  }

  // The same by Newton's method only. If it does not find the surface, `state` is unchanged and the result is false.
  bool find_roughly(Vertex_state& state, const Region region, const double trust_radius, const double good_distance) const
  {
    if (!newton(state, region, trust_radius, good_distance))
      return false;
    m_number_by_newton.fetch_add(1, std::memory_order_relaxed);
    return true;
  }

  // updates the normal at a point that stays where it is, on the polyline of a boundary
  void update_normal(Vertex_state& state, const Region region) const
  {
    Vector normal;
    if (unit_vector(evaluate(state.point, region).gradient, normal))
      state.normal = m_orientations[region] * normal;
  }

  // Moves the point onto the curve where the zero sets of two regions meet, by Newton's method on both. Each step is the
  // shortest one that meets both tangent planes. So the point does not move along the curve. If the steps do not lead to the
  // curve within the trust radius, `point` is unchanged and the result is false.
  bool project_on_crease(Vector& point, const Region one, const Region other, const double trust_radius) const
  {
    Vector p = point;
    for (int step = 0; step < newton_steps; ++step)
    {
      const Value_and_gradient at_one = evaluate(p, one), at_other = evaluate(p, other);
      Vector normal_of_one, normal_of_other;
      if (!std::isfinite(at_one.value) || !std::isfinite(at_other.value) || !unit_vector(at_one.gradient, normal_of_one) ||
          !unit_vector(at_other.gradient, normal_of_other))
        return false;
      const double cosine = normal_of_one.dot(normal_of_other), squared_sine = 1 - cosine * cosine;
      if (!(squared_sine > smallest_squared_sine))
        return false;
      const double d = at_one.value / at_one.gradient.norm(), e = at_other.value / at_other.gradient.norm();
      if (std::abs(d) <= settled * m_exact_distance && std::abs(e) <= settled * m_exact_distance)
        break;
      p -= ((d - cosine * e) * normal_of_one + (e - cosine * d) * normal_of_other) / squared_sine;
      if (!((p - point).squaredNorm() <= trust_radius * trust_radius))
        return false;
    }
    for (const Region region : {one, other})
    {
      const Value_and_gradient at_p = evaluate(p, region);
      if (!(std::abs(at_p.value) <= m_exact_distance * at_p.gradient.norm()))
        return false;
    }
    point = p;
    m_number_by_newton.fetch_add(1, std::memory_order_relaxed);
    return true;
  }

  // Moves the point onto the zero set by Newton's method, perpendicular to two unit vectors, which are orthogonal to each other, or
  // zero. If the steps do not lead there within the trust radius, or the surface is nearly perpendicular to the way, `point` is unchanged
  // and the result is false.
  bool project_across(Vector& point, const Region region, const Vector& one, const Vector& other,
                      const double trust_radius) const
  {
    static constexpr double least_slope = 0.17; // over the length of the gradient: a way at 10 degrees to the surface
    Vector p = point;
    for (int step = 0; step < newton_steps; ++step)
    {
      const Value_and_gradient at_p = evaluate(p, region);
      const double length = at_p.gradient.norm();
      const Vector along = at_p.gradient - at_p.gradient.dot(one) * one - at_p.gradient.dot(other) * other;
      if (!std::isfinite(at_p.value) || !std::isfinite(length) || !(along.norm() > least_slope * length))
        return false;
      if (std::abs(at_p.value) <= settled * m_exact_distance * length)
        break;
      p -= at_p.value / along.squaredNorm() * along;
      if (!((p - point).squaredNorm() <= trust_radius * trust_radius))
        return false;
    }
    const Value_and_gradient at_p = evaluate(p, region);
    if (!(std::abs(at_p.value) <= m_exact_distance * at_p.gradient.norm()))
      return false;
    point = p;
    m_number_by_newton.fetch_add(1, std::memory_order_relaxed);
    return true;
  }

  Projection_counters counters() const
  {
    return Projection_counters{m_number_by_newton, m_number_by_bisection, m_number_by_descent, m_number_by_closest_point};
  }

private:
  Value_and_gradient evaluate(const Vector& p, const Region region) const
  {
    // A point may overflow, for instance after a step where the curvature overflows. No function has to answer there.
    if (!std::isfinite(p.squaredNorm()))
    {
      Value_and_gradient none;
      none.value = std::numeric_limits<double>::quiet_NaN();
      return none;
    }
    return value_and_gradient_of(piece(m_function, region), p);
  }

  static bool unit_vector(const Vector& gradient, Vector& normal)
  {
    const double length = gradient.norm();
    if (!(length > 0) || !std::isfinite(length))
      return false;
    normal = gradient / length;
    return true;
  }

  void project(Vertex_state& state, const Region region, const double trust_radius, const double distance) const
  {
    if (newton(state, region, trust_radius, distance))
      m_number_by_newton.fetch_add(1, std::memory_order_relaxed);
    else if (bisection(state, region, trust_radius))
      m_number_by_bisection.fetch_add(1, std::memory_order_relaxed);
    else if (descent(state, region, trust_radius))
      m_number_by_descent.fetch_add(1, std::memory_order_relaxed);
    else
    {
      m_input.project(state);
      state.last_step = 0;
      state.is_on_input = true;
      m_number_by_closest_point.fetch_add(1, std::memory_order_relaxed);
    }
  }

  bool newton(Vertex_state& state, const Region region, const double trust_radius, const double distance) const
  {
    const bool is_exact = distance <= m_exact_distance;
    double best_distance = distance;
    bool is_found = false;
    const Vector start = state.point;
    Vector p = start;
    for (int step = 0; step < newton_steps; ++step)
    {
      const Value_and_gradient at_p = evaluate(p, region);
      Vector normal;
      if (!std::isfinite(at_p.value) || !unit_vector(at_p.gradient, normal))
        return is_found;
      const double signed_distance = at_p.value / at_p.gradient.norm();
      const Vector next = p - signed_distance * normal;
      if (!((next - start).squaredNorm() <= trust_radius * trust_radius))
        return is_found;
      if (std::abs(signed_distance) <= best_distance)
      {
        // An exact projection takes the point that was evaluated, not the one after the next step: so near to the zero set, the
        // function need not be better than its own noise.
        state.point = is_exact ? p : next;
        state.normal = m_orientations[region] * normal;
        state.last_step = best_distance = std::abs(signed_distance);
        state.is_on_input = false;
        is_found = true;
        if (!is_exact || best_distance <= settled * m_exact_distance)
          return true;
      }
      else if (is_found)
        return true; // it does not get better
      p = next;
    }
    return is_found;
  }

  // Looks for a change of sign on the line along the gradient at the start, within the trust radius, and halves the interval
  // around it. The surface found must face the same way as at the start, or it is another sheet.
  bool bisection(Vertex_state& state, const Region region, const double trust_radius) const
  {
    const Value_and_gradient start = evaluate(state.point, region);
    Vector direction;
    if (!std::isfinite(start.value) || !unit_vector(start.gradient, direction))
      return false;
    direction *= start.value > 0 ? -1. : 1.;
    double inner = 0, outer = 0;
    bool is_bracketed = false;
    for (int k = 1; k <= 8 && !is_bracketed; ++k)
    {
      inner = outer;
      outer = trust_radius * k / 8.;
      is_bracketed = evaluate(state.point + outer * direction, region).value * start.value <= 0;
    }
    if (!is_bracketed)
      return false;
    for (int k = 0; k < bisection_steps && outer - inner > 0.5 * m_exact_distance; ++k)
    {
      const double middle = 0.5 * (inner + outer);
      (evaluate(state.point + middle * direction, region).value * start.value > 0 ? inner : outer) = middle;
    }
    const Vector p = state.point + outer * direction;
    const Value_and_gradient at_p = evaluate(p, region);
    Vector normal;
    if (!unit_vector(at_p.gradient, normal) || !(normal.dot(start.gradient) > 0))
      return false;
    if (!(std::abs(at_p.value) <= largest_jump * m_exact_distance * at_p.gradient.norm()))
      return false; // the sign changes without a zero
    state.point = p;
    state.normal = m_orientations[region] * normal;
    state.last_step = 0;
    state.is_on_input = false;
    return true;
  }

  // Goes along the gradient in steps of about the trust radius, to where Newton's method or bisection lead on. It does so only
  // where the mesh that was given is coarser than the mesh is now, and so may be far from the surface. The way is at most twice as
  // long as the sides of the facet there.
  bool descent(Vertex_state& state, const Region region, const double trust_radius) const
  {
    const double size = m_input.size_of_closest_facet(state.point);
    if (!(size > least_coarseness * trust_radius))
      return false;
    double rest = (std::min)(2 * size, longest_descent * m_input.diagonal());
    const double longest_step = (std::max)(trust_radius, rest / descent_steps);
    Vertex_state moved = state;
    for (int step = 0; step < 2 * descent_steps && rest > 0; ++step)
    {
      const Value_and_gradient at_point = evaluate(moved.point, region);
      Vector normal;
      if (!std::isfinite(at_point.value) || !unit_vector(at_point.gradient, normal))
        return false;
      const double distance = at_point.value / at_point.gradient.norm();
      if (step > 0 && std::abs(distance) <= longest_step &&
          (newton(moved, region, longest_step, m_exact_distance) || bisection(moved, region, longest_step)))
      {
        state = moved;
        return true;
      }
      const double way = (std::min)({std::abs(distance), longest_step, rest});
      rest -= way;
      moved.point -= std::copysign(way, distance) * normal;
    }
    return false;
  }

  const Function& m_function;
  const Input_surface& m_input;
  double m_exact_distance;
  std::vector<double> m_orientations; // by region: 1 or -1
  mutable std::atomic<std::size_t> m_number_by_newton{0}, m_number_by_bisection{0}, m_number_by_descent{0},
      m_number_by_closest_point{0};
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_PROJECTION_H
