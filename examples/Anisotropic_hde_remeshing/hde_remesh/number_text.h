// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_NUMBER_TEXT_H
#define HDE_REMESH_NUMBER_TEXT_H

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace hde_remesh {

inline std::string number(const double value, const int digits)
{
  std::ostringstream stream;
  stream << std::setprecision(digits) << value;
  return stream.str();
}

inline std::string fixed(const double value, const int decimals)
{
  if (!std::isfinite(value) || std::abs(value) >= 1e6)
    return number(value, 4);
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals) << value;
  return stream.str();
}

} // namespace hde_remesh

#endif // HDE_REMESH_NUMBER_TEXT_H
