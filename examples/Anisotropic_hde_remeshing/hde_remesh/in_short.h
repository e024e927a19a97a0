// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_IN_SHORT_H
#define HDE_REMESH_IN_SHORT_H

#include <iomanip>
#include <sstream>
#include <string>

namespace hde_remesh {

// a number in a line for people
inline std::string in_short(const double value, const int digits = 2)
{
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

} // namespace hde_remesh

#endif // HDE_REMESH_IN_SHORT_H
