// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_PLY_HEADER_H
#define HDE_REMESH_PLY_HEADER_H

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hde_remesh {

enum class Ply_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT32,
  FLOAT64
};

struct Ply_property
{
  std::string name;
  Ply_type type;                     // of the number, or of those of a list
  std::optional<Ply_type> size_type; // of a list
};

struct Ply_element
{
  std::string name;
  std::size_t number;
  std::vector<Ply_property> properties;
};

enum class Ply_format
{
  ASCII,
  BINARY_LITTLE_ENDIAN,
  BINARY_BIG_ENDIAN
};

struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
  std::size_t end = 0, number_of_lines = 0; // where the data begin
};

// `text` begins as the file does, which has `size` bytes. Throws Unreadable, which names the line.
Ply_header read_ply_header(const std::string& text, std::size_t size);
inline Ply_header read_ply_header(const std::string& text) { return read_ply_header(text, text.size()); }

} // namespace hde_remesh

#endif // HDE_REMESH_PLY_HEADER_H
