// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MESH_FILE_H
#define HDE_REMESH_MESH_FILE_H

#include "Soup.h"

#include <string>

namespace hde_remesh {

// the bytes of a file, without a byte order mark
std::string text_of_file(const std::string& file_name);

Soup read_soup(const std::string& file_name);

// Writes the soup whole or not at all.
void write_soup(const Soup& soup, const std::string& file_name);

} // namespace hde_remesh

#endif // HDE_REMESH_MESH_FILE_H
