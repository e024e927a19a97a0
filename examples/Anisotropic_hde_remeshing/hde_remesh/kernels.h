// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
#ifndef HDE_REMESH_KERNELS_H
#define HDE_REMESH_KERNELS_H

#include <string>
#include <vector>

namespace hde_remesh {

// the radial functions, as --kernel calls them
std::vector<std::string> names_of_kernels();

// whether a radial function has a shape parameter
bool has_shape(const std::string& kernel);

} // namespace hde_remesh

#endif // HDE_REMESH_KERNELS_H
