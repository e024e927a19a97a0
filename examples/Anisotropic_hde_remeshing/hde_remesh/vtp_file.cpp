// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "vtp_file.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>

namespace hde_remesh {

namespace {

// as VTK reads what is no finite number
void write_number(const double value, std::ostream& stream)
{
  if (std::isfinite(value))
    stream << value;
  else
    stream << (std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
}

// as XML has it between quotes
std::string escaped(const std::string& name)
{
  std::string result;
  for (const char c : name)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

// an element DataArray, whose contents `write` puts into the stream
template <typename Write>
void write_array(const char* attributes, const std::string& name, const Write& write, std::ostream& stream)
{
  stream << "<DataArray " << attributes << " Name=\"" << escaped(name) << "\" format=\"ascii\">\n";
  write();
  stream << "</DataArray>\n";
}

void write_arrays(const char* element, const std::vector<Array>& arrays, std::ostream& stream)
{
  stream << "<" << element << ">\n";
  for (const Array& array : arrays)
    write_array(
        "type=\"Float64\"", array.name,
        [&]
        {
          for (const double value : array.values)
          {
            write_number(value, stream);
            stream << "\n";
          }
        },
        stream);
  stream << "</" << element << ">\n";
}

void write_points(const Soup& soup, std::ostream& stream)
{
  stream << "<Points>\n";
  write_array(
      "type=\"Float64\" NumberOfComponents=\"3\"", "points",
      [&]
      {
        for (const Point_3& p : soup.points)
          stream << p.x() << " " << p.y() << " " << p.z() << "\n";
      },
      stream);
  stream << "</Points>\n";
}

void write_polygons(const Soup& soup, std::ostream& stream)
{
  stream << "<Polys>\n";
  write_array(
      "type=\"Int64\"", "connectivity",
      [&]
      {
        for (const std::vector<std::size_t>& face : soup.faces)
        {
          for (const std::size_t v : face)
            stream << v << " ";
          stream << "\n";
        }
      },
      stream);
  write_array(
      "type=\"Int64\"", "offsets",
      [&]
      {
        std::size_t end = 0;
        for (const std::vector<std::size_t>& face : soup.faces)
          stream << (end += face.size()) << "\n";
      },
      stream);
  stream << "</Polys>\n";
}

} // namespace

void write_vtp(const Soup& soup, std::ostream& stream)
{
  stream.precision(std::numeric_limits<double>::max_digits10);
  stream << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         << "<PolyData>\n<Piece NumberOfPoints=\"" << soup.points.size() << "\" NumberOfPolys=\"" << soup.faces.size()
         << "\">\n";
  write_arrays("PointData", soup.vertex_arrays, stream);
  write_arrays("CellData", soup.face_arrays, stream);
  write_points(soup, stream);
  write_polygons(soup, stream);
  stream << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace hde_remesh
