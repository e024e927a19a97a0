// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/text_of_number.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Errors of the caller. They are reported in Release, too: "sigma is -1: it must be finite and not negative"
template <typename Value>
[[noreturn]] void throw_invalid_argument(const std::string& name, const Value& value, const std::string& requirement)
{
  std::ostringstream message;
  message << name << " is ";
  if constexpr (std::is_arithmetic<Value>::value)
    message << text_of_number(value);
  else
    message << value;
  message << ": it must be " << requirement;
  throw std::invalid_argument(message.str());
}

inline double checked_positive(const std::string& name, const double value)
{
  if (!(value > 0) || !std::isfinite(value))
    throw_invalid_argument(name, value, "finite and positive");
  return value;
}

inline double checked_not_negative(const std::string& name, const double value)
{
  if (!(value >= 0) || !std::isfinite(value))
    throw_invalid_argument(name, value, "finite and not negative");
  return value;
}

inline double checked_between(const std::string& name, const double value, const double low, const double high)
{
  if (!(value >= low && value <= high))
    throw_invalid_argument(name, value, "from " + text_of_number(low) + " to " + text_of_number(high));
  return value;
}

// counts may come as signed integers or as doubles: a negative one must not wrap around
template <typename Count>
std::size_t checked_count(const std::string& name, const Count value, const std::size_t largest = std::size_t(1) << 50)
{
  if (!(value >= Count(1)))
    throw_invalid_argument(name, value, "at least 1");
  if (!(double(value) <= double(largest)))
    throw_invalid_argument(name, value, "at most " + text_of_number(largest));
  return std::size_t(value);
}

// A number of iterations or steps. There is no half of one.
template <typename Count>
unsigned int checked_repetitions(const std::string& name, const Count value)
{
  static constexpr double largest = 1e6;
  const double n = double(value);
  if (!(n >= 0 && n <= largest) || n != std::floor(n))
    throw_invalid_argument(name, value, "an integer from 0 to 1000000");
  return static_cast<unsigned int>(n);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
