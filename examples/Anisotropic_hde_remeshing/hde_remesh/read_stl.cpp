// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// STL, as text, in small letters or capitals, or binary. Points that are equal are one.

#include "Byte_reader.h"
#include "readers.h"
#include "rounding.h"

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace hde_remesh {

namespace {

class Facets
{
public:
  explicit Facets(Soup& soup) : m_soup(soup) {}

  void add(const std::array<Point_3, 3>& corners)
  {
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    for (const Point_3& p : corners)
    {
      const Key key = {p.x() + 0., p.y() + 0., p.z() + 0.}; // -0. is 0.
      const auto [place, is_new] = m_numbers.emplace(key, m_soup.points.size());
      if (is_new)
        m_soup.points.push_back(p);
      face.push_back(place->second);
    }
  }

private:
  typedef std::array<double, 3> Key;

  Soup& m_soup;
  std::unordered_map<Key, std::size_t, boost::hash<Key>> m_numbers; // no one asks for their order
};

constexpr std::size_t header_size = 80, data_begin = 84, facet_size = 50;

std::size_t announced_number(const std::string& text)
{
  return Byte_reader(text, false, header_size).number<std::uint32_t>([] { return "the number of facets"; });
}

// A header may begin with any word, but the size of the file tells. Some writers leave a few bytes behind the last facet.
bool is_binary(const std::string& text)
{
  if (has_size_of_binary_stl(text))
    return true;
  Text_reader reader(text, Text_reader::PLAIN);
  if (!reader.next_line())
    return true;
  std::string word(reader.words().front().substr(0, 5));
  std::transform(word.begin(), word.end(), word.begin(), [](const unsigned char c) { return std::tolower(c); });
  return word != "solid" || text.find('\0') != std::string::npos;
}

// whether a file with room for so many facets may have been one with the number of its header
bool is_plausible(const std::size_t number, const std::size_t room)
{
  static constexpr std::size_t most_that_are_lost = 1000; // for each that is there
  return number > room && number / most_that_are_lost <= room;
}

Soup read_binary_stl(const std::string& text)
{
  const std::size_t size = text.size();
  if (text.find('\0') == std::string::npos && text.find('\n') != std::string::npos)
    throw Unreadable("it begins without 'solid', and has none of the zeros of a binary one", Unreadable::BEGINNING);
  if (size < data_begin)
    throw Unreadable("byte " + std::to_string(size) +
                         ": expected 'solid', or a header of 80 bytes and the number of facets, but the file ends",
                     Unreadable::END);
  const std::size_t number = announced_number(text), room = (size - data_begin) / facet_size;
  if (number != room)
    throw Unreadable("byte 80: expected the number of facets that follow, " + std::to_string(room) + ", found " +
                         std::to_string(number),
                     is_plausible(number, room) ? Unreadable::END : Unreadable::BEGINNING);
  Soup soup;
  Facets facets(soup);
  Byte_reader bytes(text, false, data_begin);
  for (std::size_t i = 0; i < number; ++i)
  {
    const auto expected = [&] { return "a finite coordinate of face " + ordinal(i, number); };
    for (int k = 0; k < 3; ++k) // the normal, which nobody uses
      bytes.number<float>(expected);
    std::array<Point_3, 3> corners;
    for (Point_3& p : corners)
    {
      const double x = bytes.finite_number<float>(expected), y = bytes.finite_number<float>(expected),
                   z = bytes.finite_number<float>(expected);
      p = Point_3(x, y, z);
    }
    facets.add(corners);
    bytes.number<std::uint16_t>(expected);
  }
  soup.rounding = rounding_of_floats(soup.points);
  return soup;
}

class Stl_text_reader
{
public:
  explicit Stl_text_reader(const std::string& text) : m_reader(text, Text_reader::PLAIN), m_facets(m_soup) {}

  Soup read()
  {
    m_reader.next_line();
    m_reader.skip_line(); // solid, and perhaps a name
    bool is_in_solid = true;
    while (!m_reader.is_done())
    {
      const std::string word = keyword("facet");
      if (word == "facet")
        read_facet();
      else if (word == "endsolid" || word == "solid")
      {
        is_in_solid = word == "solid";
        m_reader.skip_line();
      }
      else
        m_reader.fail("facet or endsolid", m_last_word);
    }
    if (is_in_solid)
      m_soup.notes.push_back("the file has no endsolid: perhaps it was cut off");
    m_soup.rounding = (std::max)(rounding_of_text(m_soup.points, m_reader), rounding_of_floats(m_soup.points));
    return std::move(m_soup);
  }

private:
  // in small letters; `end` and what follows it are one
  std::string keyword(const char* expected)
  {
    const auto next = [&]
    {
      m_last_word = m_reader.word([expected] { return std::string(expected); });
      std::string word(m_last_word);
      std::transform(word.begin(), word.end(), word.begin(), [](const unsigned char c) { return std::tolower(c); });
      return word;
    };
    const std::string word = next();
    return word == "end" ? word + next() : word;
  }

  void expect(const char* expected)
  {
    if (keyword(expected) != expected)
      m_reader.fail(expected, m_last_word);
  }

  void read_facet()
  {
    std::string word = keyword("outer loop");
    for (int k = 0; k < 4 && word != "outer"; ++k) // the normal, which nobody uses
      word = keyword("outer loop");
    if (word != "outer")
      m_reader.fail("outer loop", m_last_word);
    expect("loop");
    std::array<Point_3, 3> corners;
    for (Point_3& p : corners)
    {
      expect("vertex");
      const auto expected = [this] { return "a coordinate of face " + std::to_string(m_soup.faces.size() + 1); };
      double c[3];
      for (double& x : c)
        x = m_reader.finite_number(m_reader.word(expected), expected);
      p = Point_3(c[0], c[1], c[2]);
    }
    expect("endloop");
    expect("endfacet");
    m_facets.add(corners);
  }

  Text_reader m_reader;
  Soup m_soup;
  Facets m_facets;
  std::string_view m_last_word;
};

} // namespace

bool has_size_of_binary_stl(const std::string& text)
{
  return text.size() >= data_begin && text.size() == data_begin + facet_size * announced_number(text);
}

Soup read_stl(const std::string& text) { return is_binary(text) ? read_binary_stl(text) : Stl_text_reader(text).read(); }

} // namespace hde_remesh
