// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What is read of a file of a mesh or of points, a function for each format. Each count and index of the file is checked against what follows.

#ifndef HDE_REMESH_READERS_H
#define HDE_REMESH_READERS_H

#include "Soup.h"

#include <string>
#include <vector>

namespace hde_remesh {

// All throw Unreadable, which names the line or the byte and what was expected there. The text is the whole file.
Soup read_off(const std::string& text);
Soup read_obj(const std::string& text);
Soup read_ply(const std::string& text);
Soup read_stl(const std::string& text);
Soup read_xyz(const std::string& text);

// whether the size of the file is that of a binary STL file, whose header may begin with any bytes
bool has_size_of_binary_stl(const std::string& text);

// The values of a vertex property of a PLY file; none if there is no number of this name.
std::vector<double> read_ply_property(const std::string& text, const std::string& name);

} // namespace hde_remesh

#endif // HDE_REMESH_READERS_H
