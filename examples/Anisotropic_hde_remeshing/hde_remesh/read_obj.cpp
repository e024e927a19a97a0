// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// OBJ: the vertices and the faces; the normals of vertices without faces, if there are as many. All else is passed over: textures,
// groups, points, lines, curves.

#include "readers.h"
#include "rounding.h"

#include <cctype>
#include <charconv>
#include <string_view>
#include <vector>

namespace hde_remesh {

namespace {

class Obj_reader
{
public:
  explicit Obj_reader(const std::string& text) : m_reader(text, Text_reader::WITH_CONTINUATIONS) {}

  Soup read()
  {
    while (m_reader.next_line())
    {
      const std::string_view keyword = m_reader.word([] { return std::string(); });
      if (keyword == "v")
        read_point();
      else if (keyword == "vn" && m_soup.faces.empty())
        read_normal();
      else if (keyword == "f")
        read_face();
      else if (!begins_with_letters(keyword))
        m_reader.fail("v, f or another keyword of OBJ", keyword);
    }
    check_faces();
    if (!m_soup.is_of_points() || m_soup.normals.size() != m_soup.points.size())
      m_soup.normals.clear();
    m_soup.rounding = rounding_of_text(m_soup.points, m_reader);
    return std::move(m_soup);
  }

private:
  // no line that has lost its keyword, or the blank behind it
  static bool begins_with_letters(const std::string_view keyword)
  {
    const auto is_letter = [](const char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    return is_letter(keyword[0]) && (keyword.size() == 1 || keyword[1] == '_' || is_letter(keyword[1]));
  }

  void read_point() // a weight or a colour may follow
  {
    const auto expected = [this] { return "a coordinate of vertex " + std::to_string(m_soup.points.size() + 1); };
    double c[3];
    for (double& x : c)
    {
      if (m_reader.is_line_done())
        m_reader.fail(expected(), "the end of the line");
      x = m_reader.finite_number(m_reader.word(expected), expected);
    }
    m_soup.points.emplace_back(c[0], c[1], c[2]);
  }

  // of meshes no one asks for it
  void read_normal()
  {
    double n[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 3 && !m_reader.is_line_done(); ++k)
      Text_reader::to_number(m_reader.word([] { return std::string(); }), n[k]);
    m_soup.normals.emplace_back(n[0], n[1], n[2]);
  }

  // vertex, vertex/texture, vertex//normal or vertex/texture/normal; below zero, counted back from the last one
  void read_face()
  {
    const auto expected = [this] { return "a vertex of face " + std::to_string(m_soup.faces.size()); };
    std::vector<std::size_t>& face = m_soup.faces.emplace_back();
    m_lines.push_back(m_reader.line_number());
    if (m_reader.is_line_done())
      m_reader.fail(expected(), "the end of the line");
    while (!m_reader.is_line_done())
    {
      const std::string_view word = m_reader.word(expected), number = word.substr(0, word.find('/'));
      long long v = 0;
      const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), v);
      if (error != std::errc() || end != number.data() + number.size() || v == 0)
        m_reader.fail(expected() + ", a whole number but 0", word);
      const auto number_of_points = static_cast<long long>(m_soup.points.size());
      if (v < -number_of_points)
        m_reader.fail(expected() + " among the " + std::to_string(number_of_points) + " before it", word);
      face.push_back(static_cast<std::size_t>(v > 0 ? v - 1 : number_of_points + v));
    }
  }

  // a vertex may come after its faces
  void check_faces() const
  {
    for (std::size_t i = 0; i < m_soup.faces.size(); ++i)
      for (const std::size_t v : m_soup.faces[i])
        if (v >= m_soup.points.size())
          throw Unreadable("line " + std::to_string(m_lines[i]) + ": expected a vertex of face " +
                           ordinal(i, m_soup.faces.size()) + " from 1 to " + std::to_string(m_soup.points.size()) + ", found " +
                           std::to_string(v + 1));
  }

  Text_reader m_reader;
  Soup m_soup;
  std::vector<std::size_t> m_lines; // of the faces
};

} // namespace

Soup read_obj(const std::string& text) { return Obj_reader(text).read(); }

} // namespace hde_remesh
