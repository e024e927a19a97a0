// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Format.h"
#include "Failure.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace hde_remesh {

Format format_of(const std::string& file_name)
{
  std::string extension = std::filesystem::path(file_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".off")
    return Format::OFF;
  if (extension == ".obj")
    return Format::OBJ;
  if (extension == ".ply")
    return Format::PLY;
  if (extension == ".stl")
    return Format::STL;
  if (extension == ".vtp")
    return Format::VTP;
  if (extension == ".xyz" || extension == ".pwn")
    return Format::XYZ;
  if (extension == ".las" || extension == ".laz")
    throw Failure(in_quotes(file_name) + ": LAS files are not read, as that takes LASlib; as PLY or XYZ, the points are");
  throw Failure(extension.empty() ? in_quotes(file_name) + " has no extension: .off, .obj, .ply, .stl or .vtp tells the format"
                                  : in_quotes(file_name) + " has the unknown extension " + in_quotes(extension) +
                                        ": .off, .obj, .ply, .stl and .vtp are known");
}

bool is_read(const Format format) { return format != Format::VTP; }

bool is_written(const Format format) { return format != Format::XYZ; }

bool holds_arrays(const Format format) { return format == Format::PLY || format == Format::VTP; }

} // namespace hde_remesh
