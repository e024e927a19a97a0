// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "mesh_file.h"
#include "Failure.h"
#include "Format.h"
#include "Mesh.h"
#include "Whole_file.h"
#include "unreadable.h"
#include "vtp_file.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace hde_remesh {

namespace {

std::string read_whole(const std::string& file_name)
{
  const auto fail = [&file_name](const std::string& reason)
  { throw Failure("cannot read " + in_quotes(file_name) + ": " + reason); };
  std::error_code error;
  if (std::filesystem::is_directory(file_name, error))
    fail("it is a directory");
  errno = 0;
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream)
    fail(errno != 0 ? std::strerror(errno) : "it cannot be opened");
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad() || (text.fail() && stream.peek() != std::ifstream::traits_type::eof()))
    fail(errno != 0 ? std::strerror(errno) : "reading failed");
  return text.str();
}

bool parse(std::istream& stream, const Format format, Soup& soup)
{
  const auto np = CGAL::parameters::verbose(false);
  switch (format)
  {
  case Format::OFF:
    return CGAL::IO::read_OFF(stream, soup.points, soup.faces, np);
  case Format::OBJ:
    return CGAL::IO::read_OBJ(stream, soup.points, soup.faces, np);
  case Format::PLY:
    CGAL::IO::set_binary_mode(stream); // the header of the file has the last word
    return CGAL::IO::read_PLY(stream, soup.points, soup.faces, np);
  case Format::STL:
    CGAL::IO::set_binary_mode(stream);
    return CGAL::IO::read_STL(stream, soup.points, soup.faces, np);
  case Format::VTP:
    break;
  }
  return false;
}

// CGAL's reader of OBJ files refuses some indices after it has read everything.
std::string reason_of_refusal(const Soup& soup)
{
  for (std::size_t i = 0; i < soup.faces.size(); ++i)
    for (const std::size_t v : soup.faces[i])
      if (v >= soup.points.size())
        return "face " + std::to_string(i + 1) + " of " + std::to_string(soup.faces.size()) +
               " names a vertex that does not exist: there are " + std::to_string(soup.points.size());
  return "it ends early or is no file of its format";
}

void write_as(std::ostream& stream, const Format format, const Soup& soup)
{
  const auto np = CGAL::parameters::stream_precision(17); // a double is read back as it was
  bool is_written = false;
  switch (format)
  {
  case Format::OFF:
    is_written = CGAL::IO::write_OFF(stream, soup.points, soup.faces, np);
    break;
  case Format::OBJ:
    is_written = CGAL::IO::write_OBJ(stream, soup.points, soup.faces, np);
    break;
  case Format::PLY:
    CGAL::IO::set_binary_mode(stream);
    is_written = soup.vertex_arrays.empty() && soup.face_arrays.empty()
                     ? CGAL::IO::write_PLY(stream, soup.points, soup.faces, np)
                     : CGAL::IO::write_PLY(stream, mesh_with_arrays(soup), np);
    break;
  case Format::STL:
    CGAL::IO::set_binary_mode(stream);
    is_written = CGAL::IO::write_STL(stream, soup.points, soup.faces, np);
    break;
  case Format::VTP:
    write_vtp(soup, stream);
    is_written = bool(stream);
    break;
  }
  if (!is_written)
    stream.setstate(std::ios::failbit);
}

} // namespace

Soup read_soup(const std::string& file_name)
{
  const Format format = format_of(file_name);
  if (!is_read(format))
    throw Failure("cannot read " + in_quotes(file_name) + ": files of this format are only written");
  std::string text = read_whole(file_name);
  const std::string problem = problem_of_numbers(text, format);
  if (!problem.empty())
    throw Failure("cannot read " + in_quotes(file_name) + ": " + problem);
  if (format == Format::OBJ) // CGAL's reader knows blanks only
    std::replace(text.begin(), text.end(), '\t', ' ');
  std::istringstream stream(text);
  text = std::string();
  Soup soup;
  bool is_read = false;
  try
  {
    is_read = parse(stream, format, soup);
  }
  catch (const std::exception&)
  {
    // a size that no memory holds, a coordinate over 0: not a file of this format
  }
  if (!is_read)
    throw Failure("cannot read " + in_quotes(file_name) + ": " +
                  (format == Format::OBJ ? reason_of_refusal(soup) : "it ends early or is no file of its format"));
  return soup;
}

void write_soup(const Soup& soup, const std::string& file_name)
{
  const Format format = format_of(file_name);
  Whole_file(file_name).write([&](std::ostream& stream) { write_as(stream, format, soup); });
}

} // namespace hde_remesh
