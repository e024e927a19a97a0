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
#include "Text_reader.h"
#include "Whole_file.h"
#include "foreign_file.h"
#include "readers.h"
#include "reading_position.h"
#include "vtp_file.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

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

// A byte order mark is no part of the text. One of UTF-16 is followed by characters of two bytes; none of them is more than ASCII
// where a reader looks.
std::string without_byte_order_mark(std::string text)
{
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
    return text.substr(3);
  const bool is_little_endian = text.compare(0, 2, "\xFF\xFE") == 0;
  if (!is_little_endian && text.compare(0, 2, "\xFE\xFF") != 0)
    return text;
  std::string result;
  for (std::size_t i = 2; i + 1 < text.size(); i += 2)
  {
    const char low = text[is_little_endian ? i : i + 1], high = text[is_little_endian ? i + 1 : i];
    result += high == 0 ? low : '?';
  }
  return result;
}

Soup parse(const std::string& text, const Format format)
{
  switch (format)
  {
  case Format::OFF:
    return read_off(text);
  case Format::OBJ:
    return read_obj(text);
  case Format::PLY:
    return read_ply(text);
  case Format::XYZ:
    return read_xyz(text);
  case Format::STL:
  case Format::VTP:
    break;
  }
  return read_stl(text);
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
  case Format::XYZ: // of points only
    break;
  }
  if (!is_written)
    stream.setstate(std::ios::failbit);
}

} // namespace

std::string text_of_file(const std::string& file_name)
{
  std::string text = read_whole(file_name);
  return format_of(file_name) == Format::STL && has_size_of_binary_stl(text) ? text : without_byte_order_mark(std::move(text));
}

Soup read_soup(const std::string& file_name)
{
  const Format format = format_of(file_name);
  if (!is_read(format))
    throw Failure("cannot read " + in_quotes(file_name) + ": files of this format are only written");
  const std::string text = text_of_file(file_name);
  reading_position().begin(text.size());
  try
  {
    Soup soup = parse(text, format);
    if (format == Format::OBJ && soup.points.empty())
      throw Unreadable("it has no line of a vertex", Unreadable::BEGINNING);
    return soup;
  }
  catch (const Unreadable& error)
  {
    throw Failure("cannot read " + in_quotes(file_name) + ": " + reason_of(error, text, format));
  }
}

void write_soup(const Soup& soup, const std::string& file_name)
{
  const Format format = format_of(file_name);
  Whole_file(file_name).write([&](std::ostream& stream) { write_as(stream, format, soup); });
}

} // namespace hde_remesh
