// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_FORMAT_H
#define HDE_REMESH_FORMAT_H

#include <string>

namespace hde_remesh {

enum class Format
{
  OFF,
  OBJ,
  PLY,
  STL,
  VTP,
  XYZ
};

// the format that the extension of a file name stands for, in either case
Format format_of(const std::string& file_name);

// whether it is read, too; whether it is written
bool is_read(Format format);
bool is_written(Format format);

// whether it holds arrays of numbers of vertices and faces
bool holds_arrays(Format format);

} // namespace hde_remesh

#endif // HDE_REMESH_FORMAT_H
