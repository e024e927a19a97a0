// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "ply_header.h"

#include "Text_reader.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace hde_remesh {

namespace {

typedef std::vector<std::string_view> Words;

class Header_reader
{
public:
  Header_reader(const std::string& text, const std::size_t size) : m_size(size), m_reader(text, Text_reader::PLAIN) {}

  Ply_header read()
  {
    if (!m_reader.next_line() || m_reader.words().front() != "ply")
      m_reader.fail("'ply', with which a PLY file begins", m_reader.words().empty() ? "" : m_reader.words().front());
    bool has_format = false;
    while (m_reader.next_line())
    {
      const Words& words = m_reader.words();
      if (words.front() == "end_header")
      {
        if (!has_format)
          fail("expected the line of the format before the end of the header");
        m_header.end = m_reader.position();
        m_header.number_of_lines = m_reader.line_number();
        return std::move(m_header);
      }
      if (words.front() == "format")
        has_format = read_format(words);
      else if (words.front() == "element")
        read_element(words);
      else if (words.front() == "property")
        read_property(words);
      else if (words.front() != "comment" && words.front() != "obj_info")
        fail(excerpt(words.front()) + " begins no line of a header");
    }
    throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": the header does not end", Unreadable::END);
  }

private:
  [[noreturn]] void fail(const std::string& problem) const
  {
    throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": " + problem);
  }

  bool read_format(const Words& words)
  {
    const std::string_view name = words.size() > 1 ? words[1] : std::string_view("no format");
    if (name == "ascii")
      m_header.format = Ply_format::ASCII;
    else if (name == "binary_little_endian")
      m_header.format = Ply_format::BINARY_LITTLE_ENDIAN;
    else if (name == "binary_big_endian")
      m_header.format = Ply_format::BINARY_BIG_ENDIAN;
    else
      m_reader.fail("the format ascii, binary_little_endian or binary_big_endian", name);
    return true;
  }

  void read_element(const Words& words)
  {
    Ply_element element;
    if (words.size() != 3 || !Text_reader::to_whole_number(words[2], element.number))
      fail("an element needs a name and a number");
    if (element.number > m_size) // of which each has a byte at least
      fail("the file is too short for " + std::string(words[2]) + " of " + std::string(words[1]));
    element.name = words[1];
    if (has_name(m_header.elements, element.name))
      fail("there are two elements " + excerpt(element.name));
    m_header.elements.push_back(element);
  }

  // `property TYPE NAME` or `property list TYPE TYPE NAME`
  void read_property(const Words& words)
  {
    if (m_header.elements.empty())
      fail("a property comes before any element");
    const bool is_list = words.size() == 5 && words[1] == "list";
    if (words.size() != 3 && !is_list)
      fail("expected a property of a type and a name, or a list of two types and a name");
    Ply_property property;
    property.name = words.back();
    property.type = type(words[words.size() - 2]);
    if (is_list)
    {
      property.size_type = type(words[2]);
      if (*property.size_type == Ply_type::FLOAT32 || *property.size_type == Ply_type::FLOAT64)
        fail("the size of a list is no whole number");
    }
    Ply_element& element = m_header.elements.back();
    if (has_name(element.properties, property.name))
      fail("the element " + excerpt(element.name) + " has two properties " + excerpt(property.name));
    element.properties.push_back(property);
  }

  template <typename Named>
  static bool has_name(const std::vector<Named>& those, const std::string& name)
  {
    return std::any_of(those.begin(), those.end(), [&](const Named& one) { return one.name == name; });
  }

  Ply_type type(const std::string_view name) const
  {
    static const std::map<std::string_view, Ply_type> types = {
        {"char", Ply_type::INT8},      {"int8", Ply_type::INT8},       {"uchar", Ply_type::UINT8},
        {"uint8", Ply_type::UINT8},    {"short", Ply_type::INT16},     {"int16", Ply_type::INT16},
        {"ushort", Ply_type::UINT16},  {"uint16", Ply_type::UINT16},   {"int", Ply_type::INT32},
        {"int32", Ply_type::INT32},    {"uint", Ply_type::UINT32},     {"uint32", Ply_type::UINT32},
        {"float", Ply_type::FLOAT32},  {"float32", Ply_type::FLOAT32}, {"double", Ply_type::FLOAT64},
        {"float64", Ply_type::FLOAT64}};
    const auto found = types.find(name);
    if (found == types.end())
      fail("no property of a known type: " + excerpt(name));
    return found->second;
  }

  const std::size_t m_size; // of the file
  Text_reader m_reader;
  Ply_header m_header;
};

} // namespace

Ply_header read_ply_header(const std::string& text, const std::size_t size) { return Header_reader(text, size).read(); }

} // namespace hde_remesh
