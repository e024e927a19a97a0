// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "foreign_file.h"
#include "readers.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hde_remesh {

namespace {

using namespace std::string_view_literals;

std::string name_of(const Format format)
{
  switch (format)
  {
  case Format::OFF:
    return "OFF";
  case Format::OBJ:
    return "OBJ";
  case Format::PLY:
    return "PLY";
  case Format::STL:
    return "STL";
  case Format::VTP:
    return "VTP";
  case Format::XYZ:
    break;
  }
  return "XYZ";
}

std::string extension_of(const Format format)
{
  std::string name = "." + name_of(format);
  std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char c) { return std::tolower(c); });
  return name;
}

bool begins_with(const std::string_view text, const std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}

// what has nothing to do with meshes, or is read by other programs; empty if it is not known
std::string kind_of(const std::string_view text)
{
  static constexpr struct
  {
    std::string_view beginning;
    const char* kind;
  } kinds[] = {{"\x89PNG"sv, "a PNG picture"},
               {"\xFF\xD8\xFF"sv, "a JPEG picture"},
               {"GIF8"sv, "a GIF picture"},
               {"II*\0"sv, "a TIFF picture"},
               {"MM\0*"sv, "a TIFF picture"},
               {"%PDF"sv, "a PDF document"},
               {"PK\x03\x04"sv, "a ZIP archive, as 3MF files and office documents are"},
               {"\x1F\x8B"sv, "compressed by gzip"},
               {"BZh"sv, "compressed by bzip2"},
               {"\xFD"
                "7zXZ"sv,
                "compressed by xz"},
               {"\x28\xB5\x2F\xFD"sv, "compressed by zstd"},
               {"7z\xBC\xAF"sv, "a 7z archive"},
               {"Rar!"sv, "a RAR archive"},
               {"glTF"sv, "a glTF file"},
               {"LASF"sv, "a LAS file"},
               {"\x7F"
                "ELF"sv,
                "a program"},
               {"# vtk DataFile"sv, "a VTK file"},
               {"<VTKFile"sv, "a VTK file"},
               {"<!DOCTYPE"sv, "a page of HTML"},
               {"<html"sv, "a page of HTML"},
               {"<?xml"sv, "an XML file"},
               {"version https://git-lfs"sv, "a pointer of Git LFS, in place of the file itself"}};
  for (const auto& [beginning, kind] : kinds)
    if (begins_with(text, beginning))
      return kind;
  return "";
}

// the format by the first word, if it is one
std::optional<Format> format_by_contents(const std::string& text)
{
  Text_reader reader(text, Text_reader::WITH_COMMENTS);
  if (has_size_of_binary_stl(text))
    return Format::STL;
  if (!reader.next_line())
    return std::nullopt;
  const std::string_view word = reader.words().front();
  const auto is_any_of = [word](const auto&... names) { return ((word == names) || ...); };
  if (word == "ply")
    return Format::PLY;
  if (word == "solid" && text.find("facet") != std::string::npos)
    return Format::STL;
  if (is_any_of("OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"))
    return Format::OFF;
  if (reader.words().size() > 1 && is_any_of("v", "vn", "vt", "mtllib", "usemtl", "o", "g"))
    return Format::OBJ;
  return std::nullopt;
}

bool is_blank(const std::string_view text)
{
  return std::all_of(text.begin(), text.end(), [](const unsigned char c) { return std::isspace(c) != 0; });
}

} // namespace

std::string reason_of(const Unreadable& error, const std::string& text, const Format format)
{
  const std::string name = name_of(format), reason = error.what();
  if (text.empty())
    return "it is empty";
  if (is_blank(text))
    return "it has nothing but blanks";
  if (const std::string kind = kind_of(text); !kind.empty())
    return "it is " + kind + ", and no " + name + " file";
  if (const std::optional<Format> other = format_by_contents(text); other && *other != format)
    return "it looks like " + std::string(*other == Format::PLY ? "a " : "an ") + name_of(*other) +
           " file: then its name must end in " + extension_of(*other);
  switch (error.place())
  {
  case Unreadable::BEGINNING:
    return "it is no " + name + " file: " + reason;
  case Unreadable::END:
    return "it is cut off: " + reason;
  case Unreadable::ELSEWHERE:
    break;
  }
  return reason;
}

} // namespace hde_remesh
