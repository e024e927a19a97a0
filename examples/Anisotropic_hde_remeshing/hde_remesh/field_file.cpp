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
#include "Text_reader.h"
#include "mesh_file.h"
#include "readers.h"

#include <cmath>

namespace hde_remesh {

std::vector<double> read_vertex_property(const std::string& file_name, const std::string& name)
{
  if (format_of(file_name) != Format::PLY)
    throw Failure("--field needs a PLY file, whose vertices have properties, not " + in_quotes(file_name));
  std::vector<double> values;
  try
  {
    values = read_ply_property(text_of_file(file_name), name);
  }
  catch (const Unreadable& error)
  {
    throw Failure("cannot read " + in_quotes(file_name) + ": " + error.what());
  }
  if (values.empty())
    throw Failure(in_quotes(file_name) + " has no vertex property " + in_quotes(name) + " of numbers");
  for (const double value : values)
    if (!std::isfinite(value))
      throw Failure(in_quotes(file_name) + ": the vertex property " + in_quotes(name) + " has the value " +
                    std::to_string(value));
  return values;
}

} // namespace hde_remesh
