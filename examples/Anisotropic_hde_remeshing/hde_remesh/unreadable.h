// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_UNREADABLE_H
#define HDE_REMESH_UNREADABLE_H

#include "Format.h"

#include <string>

namespace hde_remesh {

// What CGAL's readers take without a word or refuse without saying where: in a text, the first number that is none, or
// not finite; in a binary STL file the first such coordinate. Empty if there is nothing of that kind.
std::string problem_of_numbers(const std::string& text, Format format);

} // namespace hde_remesh

#endif // HDE_REMESH_UNREADABLE_H
