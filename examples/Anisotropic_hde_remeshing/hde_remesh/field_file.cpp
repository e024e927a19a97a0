// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "field_file.h"
#include "Failure.h"
#include "Format.h"
#include "Mesh.h"

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/version.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>

namespace hde_remesh {

namespace {

// the values of the property if it has this type
template <typename Number>
bool read_as(const Mesh& mesh, const std::string& name, std::vector<double>& values)
{
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  const auto property = mesh.property_map<Mesh::Vertex_index, Number>("v:" + name);
  if (!property)
    return false;
  const auto map = *property;
#else
  const auto property = mesh.property_map<Mesh::Vertex_index, Number>("v:" + name);
  if (!property.second)
    return false;
  const auto map = property.first;
#endif
  for (const Mesh::Vertex_index v : mesh.vertices())
    values.push_back(static_cast<double>(map[v]));
  return true;
}

} // namespace

std::vector<double> read_vertex_property(const std::string& file_name, const std::string& name)
{
  if (format_of(file_name) != Format::PLY)
    throw Failure("--field needs a PLY file, whose vertices have properties, not " + in_quotes(file_name));
  Mesh mesh;
  std::string comments;
  std::ifstream stream(file_name, std::ios::binary);
  CGAL::IO::set_binary_mode(stream); // the header of the file has the last word
  if (!CGAL::IO::read_PLY(stream, mesh, comments, false))
    throw Failure("cannot read the vertex properties of " + in_quotes(file_name));
  std::vector<double> values;
  const bool is_found = read_as<double>(mesh, name, values) || read_as<float>(mesh, name, values) ||
                        read_as<std::int32_t>(mesh, name, values) || read_as<std::uint32_t>(mesh, name, values) ||
                        read_as<std::int16_t>(mesh, name, values) || read_as<std::uint16_t>(mesh, name, values) ||
                        read_as<std::int8_t>(mesh, name, values) || read_as<std::uint8_t>(mesh, name, values);
  if (!is_found)
    throw Failure(in_quotes(file_name) + " has no vertex property " + in_quotes(name) + " of numbers");
  for (const double value : values)
    if (!std::isfinite(value))
      throw Failure(in_quotes(file_name) + ": the vertex property " + in_quotes(name) + " has the value " +
                    std::to_string(value));
  return values;
}

} // namespace hde_remesh
