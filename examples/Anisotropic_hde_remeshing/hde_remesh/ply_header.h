// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_PLY_HEADER_H
#define HDE_REMESH_PLY_HEADER_H

#include <string>

namespace hde_remesh {

// What is wrong with the header of a PLY file, with the line; empty if nothing is. CGAL's reader trusts it.
std::string problem_of_ply_header(const std::string& text);

} // namespace hde_remesh

#endif // HDE_REMESH_PLY_HEADER_H
