// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_HELP_H
#define HDE_REMESH_HELP_H

#include <string>

namespace CLI {
class App;
}

namespace hde_remesh {

// All in lines of at most 100 columns: what is printed without arguments, and for --help and --help-all.
std::string usage();
std::string short_help(const CLI::App& app);
std::string full_help(const CLI::App& app);

} // namespace hde_remesh

#endif // HDE_REMESH_HELP_H
