// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_LIMITED_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_LIMITED_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>

#include <CGAL/number_utils.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// thrown where a function is asked too often
struct Too_many_evaluations
{
};

// A function that may be evaluated only so many times, as a mesher asks for ever where the zero set is too rough for it. It keeps
// values: the centre of a cell is asked for once for each of its facets, and again when a neighbour is new. Each evaluation is a part of
// the work that the interruption is told of.
template <typename Function>
class Limited_function
{
  static constexpr std::size_t largest_number_of_kept_values = std::size_t(1) << 20;
  static constexpr std::size_t evaluations_of_kept_value = 16; // more cells than that are seldom in use at once

  struct Kept_value
  {
    Vector point = Vector::Constant(std::numeric_limits<double>::quiet_NaN()); // equal to none
    double value = 0;
  };

public:
  Limited_function(const Function& function, const std::size_t largest_number, Interruption& interruption)
    : m_function(function),
      m_largest_number(largest_number),
      m_interruption(interruption),
      m_kept_values((std::min)(1 + largest_number / evaluations_of_kept_value, largest_number_of_kept_values))
  {
  }

  // for places that are asked for again
  double operator()(const Vector& p)
  {
    Kept_value& kept = m_kept_values[boost::hash_range(p.data(), p.data() + 3) % m_kept_values.size()];
    if (kept.point != p)
    {
      kept.value = evaluate(p);
      kept.point = p;
    }
    return kept.value;
  }

  double evaluate(const Vector& p)
  {
    if (m_number == m_largest_number)
      throw Too_many_evaluations();
    ++m_number;
    m_interruption.end_parts(1);
    m_interruption.check();
    return CGAL::to_double(m_function(typename Function::Point_3(p.x(), p.y(), p.z())));
  }

  std::size_t number_of_evaluations() const { return m_number; }

private:
  const Function& m_function;
  std::size_t m_largest_number, m_number = 0;
  Interruption& m_interruption;
  std::vector<Kept_value> m_kept_values; // by hash; a new one takes the place of the old one
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_LIMITED_FUNCTION_H
