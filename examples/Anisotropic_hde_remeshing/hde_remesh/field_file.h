// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Numbers at the vertices of a mesh, from a file.

#ifndef HDE_REMESH_FIELD_FILE_H
#define HDE_REMESH_FIELD_FILE_H

#include <string>
#include <vector>

namespace hde_remesh {

// the vertex property `name` of a PLY file, by the vertices of the file
std::vector<double> read_vertex_property(const std::string& file_name, const std::string& name);

} // namespace hde_remesh

#endif // HDE_REMESH_FIELD_FILE_H
