// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_TEXT_OF_NUMBER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_TEXT_OF_NUMBER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Numbers in messages as people write them.

// so many digits, without those of an exponent that say nothing: "1e-9" for "1e-09", "3.1e18" for "3.1e+18"
inline std::string text_with_digits(const double value, const int number_of_digits)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(number_of_digits);
  stream << value;
  std::string text = stream.str();
  const std::size_t e = text.find('e');
  if (e == std::string::npos)
    return text;
  if (text[e + 1] == '+')
    text.erase(e + 1, 1);
  const std::size_t first = e + (text[e + 1] == '-' ? 2 : 1);
  while (text[first] == '0' && first + 1 < text.size())
    text.erase(first, 1);
  return text;
}

// six digits, or as many as it takes to tell the number from others
inline std::string text_of_number(const double value)
{
  for (int digits = 6; digits < std::numeric_limits<double>::max_digits10; digits += 3)
  {
    const std::string text = text_with_digits(value, digits);
    if (std::strtod(text.c_str(), nullptr) == value)
      return text;
  }
  return text_with_digits(value, std::numeric_limits<double>::max_digits10);
}

inline std::string text_of_number(const float value) { return text_with_digits(value, 6); }

// a count that is only an estimate where it is large
inline std::string text_of_estimate(const double number) { return text_with_digits(number, std::abs(number) < 1e10 ? 6 : 2); }

// An unsigned number may come from a negative one. The text then has the negative one, too.
template <typename Integer, typename = std::enable_if_t<std::is_integral<Integer>::value>>
std::string text_of_number(const Integer n)
{
  if constexpr (std::is_unsigned<Integer>::value && sizeof(Integer) >= sizeof(int))
    if (n > (std::numeric_limits<Integer>::max)() / 2)
      return std::to_string(n) + " (" + std::to_string(static_cast<std::make_signed_t<Integer>>(n)) + " as an unsigned number)";
  return std::to_string(n);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_TEXT_OF_NUMBER_H
