// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// OFF, with or without the keyword, the number of edges, normals, colours and texture coordinates, as text or binary. One element
// a line, or, if there are fewer lines than elements, a stream of numbers. Normals are read of vertices without faces.

#include "Byte_reader.h"
#include "readers.h"
#include "rounding.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string_view>

namespace hde_remesh {

namespace {

class Off_reader
{
public:
  explicit Off_reader(const std::string& text) : m_text(text), m_reader(text, Text_reader::WITH_COMMENTS) {}

  Soup read()
  {
    read_keyword();
    if (!m_reader.is_line_done() && m_reader.words()[m_number_of_words] == "BINARY")
      return read_binary();
    read_counts();
    m_is_by_lines = goes_by_lines();
    for (std::size_t i = 0; i < m_number_of_points; ++i)
      read_point(i);
    for (std::size_t i = 0; i < m_number_of_faces; ++i)
      read_face(i);
    if (!m_reader.is_done())
      m_reader.fail("the end of the file after " + std::to_string(m_number_of_faces) + " faces",
                    m_reader.word([] { return std::string(); }));
    m_soup.rounding = rounding_of_text(m_soup.points, m_reader);
    return std::move(m_soup);
  }

private:
  // [ST][C][N]OFF, perhaps with the first count behind it. A file may begin with the counts, too.
  void read_keyword()
  {
    const auto expected = [] { return std::string("OFF"); };
    const std::string_view word = m_reader.word(expected);
    std::size_t number;
    if (Text_reader::to_whole_number(word, number))
    {
      m_number_of_points = number;
      m_number_of_counts = 1;
      m_number_of_words = 1;
      return;
    }
    std::string keyword(word);
    std::transform(keyword.begin(), keyword.end(), keyword.begin(), [](const unsigned char c) { return std::toupper(c); });
    const std::size_t end = keyword.find("OFF");
    if (end == std::string::npos)
      m_reader.fail(expected(), word);
    read_kind(keyword.substr(0, end), word);
    m_number_of_words = 1;
    if (end + 3 == word.size())
      return;
    m_number_of_points = m_reader.whole_number(word.substr(end + 3), [] { return "the number of vertices after OFF"; });
    m_number_of_counts = 1;
  }

  void read_kind(std::string prefix, const std::string_view word)
  {
    const auto take = [&prefix](const std::string& part)
    {
      const bool has_part = prefix.compare(0, part.size(), part) == 0;
      prefix.erase(0, has_part ? part.size() : 0);
      return has_part;
    };
    m_has_texture = take("ST");
    m_has_colours = take("C");
    m_has_normals = take("N");
    if (!prefix.empty())
      m_reader.fail("OFF with three coordinates for each vertex", word);
  }

  std::string expected_count() const { return m_number_of_counts == 0 ? "the number of vertices" : "the number of faces"; }

  void read_counts()
  {
    for (; m_number_of_counts < 2; ++m_number_of_counts)
    {
      const auto expected = [this] { return expected_count(); };
      const std::size_t number = m_reader.whole_number(m_reader.word(expected), expected);
      (m_number_of_counts == 0 ? m_number_of_points : m_number_of_faces) = number;
    }
    // no one needs the number of edges, and some leave it out
    const auto expected = [] { return std::string("the number of edges"); };
    double number_of_edges = 0;
    Text_reader after = m_reader;
    if (!m_reader.is_line_done())
    {
      const std::string_view word = m_reader.word(expected);
      if (!Text_reader::to_number(word, number_of_edges))
        m_reader.fail(expected(), word);
    }
    else if (after.next_line() && after.words().size() == 1)
      m_reader.word(expected);
    check_size(m_number_of_points, "vertices");
    check_size(m_number_of_faces, "faces");
  }

  bool goes_by_lines() const
  {
    Text_reader after = m_reader;
    return m_reader.is_line_done() && after.next_line() && after.words().size() > 1 &&
           m_reader.number_of_lines_left() >= m_number_of_points + m_number_of_faces;
  }

  // each has a byte at least
  void check_size(const std::size_t number, const char* what) const
  {
    if (number > m_text.size())
      throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": the file is too short for " +
                       std::to_string(number) + " " + what);
  }

  // the words of an element stand in one line, if the file goes by lines
  void begin_element(const std::string& what, const std::size_t least_number_of_words)
  {
    if (!m_is_by_lines)
      return;
    if (!m_reader.next_line())
      m_reader.fail(what, "");
    if (m_reader.words().size() < least_number_of_words)
      throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": expected " + what + " in one line, " +
                       std::to_string(least_number_of_words) + " numbers at least, found " +
                       std::to_string(m_reader.words().size()));
  }

  void read_point(const std::size_t i)
  {
    const auto expected = [&] { return "a coordinate of vertex " + ordinal(i, m_number_of_points); };
    if (m_is_by_lines)
      begin_element("the coordinates of vertex " + ordinal(i, m_number_of_points), 3);
    double c[3];
    for (double& x : c)
      x = m_reader.finite_number(m_reader.word(expected), expected);
    m_soup.points.emplace_back(c[0], c[1], c[2]);
    const bool is_normal_read = is_normal_wanted();
    if (is_normal_read)
      read_normal(i);
    if (m_is_by_lines)
      m_reader.skip_line();
    else
      skip_attributes(i, is_normal_read);
  }

  // only points need it
  bool is_normal_wanted() const { return m_has_normals && m_number_of_faces == 0; }

  void read_normal(const std::size_t i)
  {
    const auto expected = [&] { return "a part of the normal of vertex " + ordinal(i, m_number_of_points); };
    if (m_is_by_lines && m_reader.words().size() < 6)
      throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": expected a normal of vertex " +
                       ordinal(i, m_number_of_points) + " in the same line");
    double n[3];
    for (double& x : n)
    {
      const std::string_view word = m_reader.word(expected);
      if (!Text_reader::to_number(word, x))
        m_reader.fail(expected(), word);
    }
    m_soup.normals.emplace_back(n[0], n[1], n[2]);
  }

  void skip_attributes(const std::size_t i, const bool is_normal_read)
  {
    const auto expected = [&] { return "an attribute of vertex " + ordinal(i, m_number_of_points); };
    if (m_has_colours)
      m_reader.fail("vertices with colours in a line each", m_reader.is_line_done() ? "none" : m_reader.word(expected));
    for (int k = 0; k < (m_has_normals && !is_normal_read ? 3 : 0) + (m_has_texture ? 2 : 0); ++k)
      m_reader.word(expected);
  }

  void read_face(const std::size_t i)
  {
    const auto expected_size = [&] { return "the number of vertices of face " + ordinal(i, m_number_of_faces); };
    if (m_is_by_lines)
      begin_element("face " + ordinal(i, m_number_of_faces), 1);
    const std::size_t size = m_reader.whole_number(m_reader.word(expected_size), expected_size);
    if (size == 0 || size > m_text.size())
      m_reader.fail(expected_size(), std::to_string(size));
    if (m_is_by_lines && m_reader.words().size() <= size)
      throw Unreadable("line " + std::to_string(m_reader.line_number()) + ": expected " + std::to_string(size) +
                       " vertices of face " + ordinal(i, m_number_of_faces) + ", found " +
                       std::to_string(m_reader.words().size() - 1));
    const auto expected = [&]
    { return "a vertex of face " + ordinal(i, m_number_of_faces) + ", a number below " + std::to_string(m_number_of_points); };
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    for (std::size_t k = 0; k < size; ++k)
    {
      const std::string_view word = m_reader.word(expected);
      face.push_back(m_reader.whole_number(word, expected));
      if (face.back() >= m_number_of_points)
        m_reader.fail(expected(), word);
    }
    if (m_is_by_lines) // a colour may follow
      m_reader.skip_line();
  }

  // big endian, as Geomview writes it
  Soup read_binary()
  {
    Byte_reader bytes(m_text, true, m_reader.position());
    m_number_of_points = count_of(bytes, "the number of vertices");
    m_number_of_faces = count_of(bytes, "the number of faces");
    bytes.number<std::int32_t>([] { return "the number of edges"; });
    for (std::size_t i = 0; i < m_number_of_points; ++i)
      read_point(i, bytes);
    for (std::size_t i = 0; i < m_number_of_faces; ++i)
      read_face(i, bytes);
    if (bytes.number_left() > 0)
      bytes.fail("the end of the file after " + std::to_string(m_number_of_faces) + " faces");
    m_soup.rounding = rounding_of_floats(m_soup.points);
    return std::move(m_soup);
  }

  // of elements that follow, of which each has a byte at least
  static std::size_t count_of(Byte_reader& bytes, const char* what)
  {
    const std::int32_t number = bytes.number<std::int32_t>([what] { return std::string(what); });
    if (number < 0 || static_cast<std::size_t>(number) > bytes.number_left())
      Byte_reader::fail_at(bytes.position() - 4, std::string(what) + " that follow, found " + std::to_string(number));
    return static_cast<std::size_t>(number);
  }

  void read_point(const std::size_t i, Byte_reader& bytes)
  {
    double c[3];
    for (double& x : c)
      x = bytes.finite_number<float>([&] { return "a coordinate of vertex " + ordinal(i, m_number_of_points); });
    m_soup.points.emplace_back(c[0], c[1], c[2]);
    const auto attribute = [&]
    { return double(bytes.number<float>([&] { return "an attribute of vertex " + ordinal(i, m_number_of_points); })); };
    double n[3] = {0, 0, 0};
    for (int k = 0; k < (m_has_normals ? 3 : 0); ++k)
      n[k] = attribute();
    if (is_normal_wanted())
      m_soup.normals.emplace_back(n[0], n[1], n[2]);
    for (int k = (m_has_colours ? 4 : 0) + (m_has_texture ? 2 : 0); k > 0; --k)
      attribute();
  }

  void read_face(const std::size_t i, Byte_reader& bytes)
  {
    const auto expected = [&] { return "a vertex of face " + ordinal(i, m_number_of_faces); };
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    for (std::size_t k = count_of(bytes, "the number of vertices of a face"); k > 0; --k)
    {
      const std::int32_t v = bytes.number<std::int32_t>(expected);
      if (v < 0 || static_cast<std::size_t>(v) >= m_number_of_points)
        Byte_reader::fail_at(bytes.position() - 4, expected() + ", found " + std::to_string(v));
      face.push_back(static_cast<std::size_t>(v));
    }
    for (std::size_t k = count_of(bytes, "the number of colours of a face"); k > 0; --k)
      bytes.number<float>([] { return "a colour of a face"; });
  }

  const std::string& m_text;
  Text_reader m_reader;
  Soup m_soup;
  bool m_has_texture = false, m_has_colours = false, m_has_normals = false, m_is_by_lines = false;
  std::size_t m_number_of_points = 0, m_number_of_faces = 0;
  int m_number_of_counts = 0;        // of which the keyword has one behind it, if there is no blank
  std::size_t m_number_of_words = 0; // of the line of the keyword, which are read
};

} // namespace

Soup read_off(const std::string& text) { return Off_reader(text).read(); }

} // namespace hde_remesh
