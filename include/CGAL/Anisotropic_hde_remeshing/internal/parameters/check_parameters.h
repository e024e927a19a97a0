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

#include <cmath>
#include <cstddef>
#include <limits>
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
  message << name << " is " << value << ": it must be " << requirement;
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
  {
    std::ostringstream range;
    range << "from " << low << " to " << high;
    throw_invalid_argument(name, value, range.str());
  }
  return value;
}

// An unsigned number may come from a negative one. The text then has the negative one, too.
template <typename Number>
std::string text_of_number(const Number n)
{
  std::ostringstream text;
  text << n;
  if constexpr (std::is_unsigned<Number>::value && sizeof(Number) >= sizeof(int))
    if (n > (std::numeric_limits<Number>::max)() / 2)
      text << " (" << static_cast<std::make_signed_t<Number>>(n) << " as an unsigned number)";
  return text.str();
}

// counts may come as signed integers or as doubles: a negative one must not wrap around
template <typename Count>
std::size_t checked_count(const std::string& name, const Count value, const std::size_t largest = std::size_t(1) << 50)
{
  if (!(value >= Count(1)))
    throw_invalid_argument(name, text_of_number(value), "at least 1");
  if (!(double(value) <= double(largest)))
    throw_invalid_argument(name, text_of_number(value), "at most " + std::to_string(largest));
  return std::size_t(value);
}

// A number of iterations or steps. There is no half of one.
template <typename Count>
unsigned int checked_repetitions(const std::string& name, const Count value)
{
  static constexpr double largest = 1e6;
  const double n = double(value);
  if (!(n >= 0 && n <= largest) || n != std::floor(n))
    throw_invalid_argument(name, text_of_number(value), "an integer from 0 to 1000000");
  return static_cast<unsigned int>(n);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
