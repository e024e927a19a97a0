// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// PLY: x, y and z of the vertices, the faces, and a further property of the vertices. Of vertices without faces the normals and all
// further numbers are read. All else is passed over.

#include "Byte_reader.h"
#include "ply_header.h"
#include "readers.h"
#include "rounding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

// The numbers of a text. An element stands in a line, unless there are fewer lines than elements.
class Text_numbers
{
public:
  Text_numbers(const std::string& text, const Ply_header& header)
    : m_reader(text, Text_reader::PLAIN, header.end, header.number_of_lines)
  {
    std::size_t number_of_elements = 0;
    for (const Ply_element& element : header.elements)
      number_of_elements += element.properties.empty() ? 0 : element.number;
    m_is_by_lines = m_reader.number_of_lines_left() >= number_of_elements;
  }

  void begin_element(const Ply_element& element, const std::size_t i)
  {
    if (!m_is_by_lines || element.properties.empty())
      return;
    if (!m_reader.is_line_done())
      m_reader.fail("the end of the line before " + element.name + " " + ordinal(i, element.number), m_reader.word(none));
    if (!m_reader.next_line())
      m_reader.fail(element.name + " " + ordinal(i, element.number), "");
  }

  template <typename Expected>
  double number(Ply_type, const Expected& expected)
  {
    const std::string_view word = next_word(expected);
    double value = 0;
    if (!Text_reader::to_number(word, value))
      m_reader.fail("a number, " + expected(), word);
    return value;
  }

  template <typename Expected>
  double coordinate(const Ply_type type, const Expected& expected)
  {
    const std::string_view word = next_word(expected);
    const double value = m_reader.finite_number(word, expected);
    if (type != Ply_type::FLOAT32)
      return value;
    if (std::abs(value) > double((std::numeric_limits<float>::max)()))
      m_reader.fail("a number that is no larger than a float, " + expected(), word);
    return static_cast<double>(static_cast<float>(value)); // as the header has it
  }

  [[noreturn]] void fail(const std::string& expected, const double found) const
  {
    throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": expected " + expected + ", found " +
                     in_short(found));
  }

  static std::string in_short(const double number)
  {
    return number == std::floor(number) && std::abs(number) < 1e15 ? std::to_string(static_cast<long long>(number))
                                                                   : std::to_string(number);
  }

  void expect_end(const std::string& expected)
  {
    if (!m_reader.is_line_done() || m_reader.next_line())
      m_reader.fail(expected, m_reader.word(none));
  }

  double rounding(const std::vector<Point_3>& points, const Ply_type type) const
  {
    const double of_type = type == Ply_type::FLOAT32 ? rounding_of_floats(points) : rounding_of_doubles(points);
    return (std::max)(of_type, rounding_of_text(points, m_reader));
  }

private:
  static std::string none() { return ""; }

  template <typename Expected>
  std::string_view next_word(const Expected& expected)
  {
    if (m_is_by_lines && m_reader.is_line_done())
      m_reader.fail(expected(), "the end of the line");
    return m_reader.word(expected);
  }

  Text_reader m_reader;
  bool m_is_by_lines;
};

// the numbers of a binary file
class Binary_numbers
{
public:
  Binary_numbers(const std::string& text, const Ply_header& header)
    : m_text(text), m_bytes(text, header.format == Ply_format::BINARY_BIG_ENDIAN, header.end)
  {
  }

  void begin_element(const Ply_element&, std::size_t) {}

  template <typename Expected>
  double number(const Ply_type type, const Expected& expected)
  {
    m_begin = m_bytes.position();
    switch (type)
    {
    case Ply_type::INT8:
      return m_bytes.number<std::int8_t>(expected);
    case Ply_type::UINT8:
      return m_bytes.number<std::uint8_t>(expected);
    case Ply_type::INT16:
      return m_bytes.number<std::int16_t>(expected);
    case Ply_type::UINT16:
      return m_bytes.number<std::uint16_t>(expected);
    case Ply_type::INT32:
      return m_bytes.number<std::int32_t>(expected);
    case Ply_type::UINT32:
      return m_bytes.number<std::uint32_t>(expected);
    case Ply_type::FLOAT32:
      return static_cast<double>(m_bytes.number<float>(expected));
    case Ply_type::FLOAT64:
      break;
    }
    return m_bytes.number<double>(expected);
  }

  template <typename Expected>
  double coordinate(const Ply_type type, const Expected& expected)
  {
    const double value = number(type, expected);
    if (!std::isfinite(value))
      fail("a finite number, " + expected(), value);
    return value;
  }

  [[noreturn]] void fail(const std::string& expected, const double found) const
  {
    Byte_reader::fail_at(m_begin, expected + ", found " + Text_numbers::in_short(found));
  }

  // blanks do no harm
  void expect_end(const std::string& expected) const
  {
    const std::size_t place = m_text.find_first_not_of(" \t\r\n", m_bytes.position());
    if (place != std::string::npos)
      Byte_reader::fail_at(place, expected);
  }

  double rounding(const std::vector<Point_3>& points, const Ply_type type) const
  {
    return type == Ply_type::FLOAT32 ? rounding_of_floats(points) : rounding_of_binary_doubles(points);
  }

private:
  const std::string& m_text;
  Byte_reader m_bytes;
  std::size_t m_begin = 0; // of the last number
};

bool has_number(const Ply_element& element, const std::string& name)
{
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const Ply_property& property) { return property.name == name && !property.size_type; });
}

bool has_faces(const Ply_header& header)
{
  return std::any_of(header.elements.begin(), header.elements.end(),
                     [](const Ply_element& element) { return element.name == "face" && element.number > 0; });
}

template <typename Numbers>
class Data_reader
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

public:
  // `wanted` is a further property of the vertices, if it is not empty
  Data_reader(const std::string& text, const Ply_header& header, const std::string& wanted)
    : m_header(header), m_numbers(text, header), m_wanted(wanted)
  {
    if (!has_faces(header))
      prepare_points();
  }

  void read()
  {
    for (const Ply_element& element : m_header.elements)
      for (std::size_t i = 0; i < element.number; ++i)
      {
        m_numbers.begin_element(element, i);
        if (element.name == "vertex")
          read_vertex(element, i);
        else
          read_other(element, i);
      }
    m_numbers.expect_end("the end of the file after the elements of the header");
    check_faces();
    m_soup.rounding = m_numbers.rounding(m_soup.points, m_type_of_coordinates);
  }

  // once
  std::pair<Soup, std::vector<double>> take() { return {std::move(m_soup), std::move(m_values)}; }

private:
  // What becomes of the numbers of a point: those of its normal, and all but the coordinates in an array each.
  void prepare_points()
  {
    for (const Ply_element& element : m_header.elements)
      if (element.name == "vertex")
      {
        const auto has = [&](const std::string& name) { return has_number(element, name); };
        m_has_normals = has("nx") && has("ny") && has("nz");
        for (const Ply_property& property : element.properties)
        {
          const std::string& name = property.name;
          const bool is_number = !property.size_type, is_coordinate = name == "x" || name == "y" || name == "z",
                     is_of_normal = m_has_normals && (name == "nx" || name == "ny" || name == "nz");
          m_arrays.push_back(is_number && !is_coordinate && !is_of_normal ? m_soup.vertex_arrays.size() : none);
          if (m_arrays.back() != none)
            m_soup.vertex_arrays.push_back(Array{name, {}, property.type == Ply_type::UINT8});
        }
      }
  }

  void keep_of_point(const Ply_property& property, const std::size_t place, const double value, double (&normal)[3])
  {
    if (place < m_arrays.size() && m_arrays[place] != none)
      m_soup.vertex_arrays[m_arrays[place]].values.push_back(value);
    else if (m_has_normals && property.name.size() == 2 && property.name[0] == 'n')
      normal[property.name[1] - 'x'] = value;
  }

  void read_vertex(const Ply_element& element, const std::size_t i)
  {
    double c[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
    for (std::size_t place = 0; place < element.properties.size(); ++place)
    {
      const Ply_property& property = element.properties[place];
      const auto expected = [&] { return property.name + " of vertex " + ordinal(i, element.number); };
      const std::size_t axis =
          property.size_type || property.name.size() != 1 ? std::string::npos : std::string("xyz").find(property.name);
      if (property.size_type)
        skip_list(property, expected);
      else if (axis != std::string::npos)
      {
        c[axis] = m_numbers.coordinate(property.type, expected);
        m_type_of_coordinates = property.type;
        if (property.name == m_wanted)
          m_values.push_back(c[axis]);
      }
      else
      {
        const double value = m_numbers.number(property.type, expected);
        if (property.name == m_wanted)
          m_values.push_back(value);
        keep_of_point(property, place, value, normal);
      }
    }
    m_soup.points.emplace_back(c[0], c[1], c[2]);
    if (m_has_normals)
      m_soup.normals.emplace_back(normal[0], normal[1], normal[2]);
  }

  // only the faces are kept of it
  void read_other(const Ply_element& element, const std::size_t i)
  {
    for (const Ply_property& property : element.properties)
    {
      const auto expected = [&] { return property.name + " of " + element.name + " " + ordinal(i, element.number); };
      const bool is_face = element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
      if (!property.size_type)
        m_numbers.number(property.type, expected);
      else if (is_face)
        read_face(property, expected);
      else
        skip_list(property, expected);
    }
  }

  template <typename Expected>
  std::size_t size_of_list(const Ply_property& property, const Expected& expected)
  {
    const double size = m_numbers.number(*property.size_type, [&] { return "the size of " + expected(); });
    if (!(size >= 0) || size != std::floor(size))
      m_numbers.fail("the size of " + expected() + ", 0 or more", size);
    return static_cast<std::size_t>((std::min)(size, 1e18));
  }

  template <typename Expected>
  void skip_list(const Ply_property& property, const Expected& expected)
  {
    for (std::size_t k = size_of_list(property, expected); k > 0; --k)
      m_numbers.number(property.type, expected);
  }

  // an index may be no larger than numbers that are read as they are
  template <typename Expected>
  void read_face(const Ply_property& property, const Expected& expected)
  {
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    for (std::size_t k = size_of_list(property, expected); k > 0; --k)
    {
      const double v = m_numbers.number(property.type, expected);
      if (!(v >= 0 && v < 1e15) || v != std::floor(v))
        m_numbers.fail(expected() + ", the number of a vertex", v);
      face.push_back(static_cast<std::size_t>(v));
    }
  }

  // the vertices may come after them
  void check_faces() const
  {
    for (std::size_t i = 0; i < m_soup.faces.size(); ++i)
      for (const std::size_t v : m_soup.faces[i])
        if (v >= m_soup.points.size())
          throw Unreadable("face " + ordinal(i, m_soup.faces.size()) + ": expected the numbers of vertices below " +
                           std::to_string(m_soup.points.size()) + ", found " + std::to_string(v));
  }

  const Ply_header& m_header;
  Numbers m_numbers;
  std::string m_wanted;
  Soup m_soup;
  std::vector<double> m_values;
  Ply_type m_type_of_coordinates = Ply_type::FLOAT64;
  bool m_has_normals = false;        // of points
  std::vector<std::size_t> m_arrays; // of points, for each property of a vertex
};

// what the file must have
void check_header(const Ply_header& header)
{
  const auto has_list = [](const Ply_element& element, const std::string& name)
  {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Ply_property& property) { return property.name == name && property.size_type; });
  };
  const auto fail = [&header](const std::string& expected) {
    throw Unreadable("line " + std::to_string(header.number_of_lines) + ": expected " + expected + " in the header before it");
  };
  bool has_vertices = false;
  for (const Ply_element& element : header.elements)
    if (element.name == "vertex")
    {
      has_vertices = true;
      for (const char* name : {"x", "y", "z"})
        if (!has_number(element, name))
          fail(std::string("a property ") + name + " of the vertices");
    }
    else if (element.name == "face" && element.number > 0)
    {
      if (!has_list(element, "vertex_indices") && !has_list(element, "vertex_index"))
        fail("a list vertex_indices of the faces");
    }
    else if (element.name == "tristrips" && element.number > 0)
      fail("an element face in the place of tristrips");
  if (!has_vertices)
    fail("an element vertex");
}

// the soup, and the values of the wanted property
template <typename Numbers>
std::pair<Soup, std::vector<double>> read_data(const std::string& text, const Ply_header& header, const std::string& wanted)
{
  Data_reader<Numbers> reader(text, header, wanted);
  reader.read();
  return reader.take();
}

std::pair<Soup, std::vector<double>> read_ply(const std::string& text, const std::string& wanted)
{
  const Ply_header header = read_ply_header(text);
  check_header(header);
  return header.format == Ply_format::ASCII ? read_data<Text_numbers>(text, header, wanted)
                                            : read_data<Binary_numbers>(text, header, wanted);
}

} // namespace

Soup read_ply(const std::string& text) { return read_ply(text, "").first; }

std::vector<double> read_ply_property(const std::string& text, const std::string& name) { return read_ply(text, name).second; }

} // namespace hde_remesh
