// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// XYZ: a point a line, three coordinates, perhaps a normal or a colour, and any further numbers. A single number in the first line is
// that of the points. Comments begin with #.

#include "readers.h"
#include "rounding.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

class Xyz_reader
{
public:
  explicit Xyz_reader(const std::string& text) : m_reader(text, Text_reader::WITH_COMMENTS) {}

  Soup read()
  {
    if (!m_reader.next_line())
      m_reader.fail("the coordinates of a point", "");
    if (m_reader.words().size() == 1)
    {
      const auto expected = [] { return std::string("the number of points, or the three coordinates of one"); };
      m_number_of_points = m_reader.whole_number(m_reader.words().front(), expected);
      m_has_number = true;
      if (!m_reader.next_line())
        m_reader.fail("the coordinates of a point", "");
    }
    m_columns.resize(m_reader.words().size());
    do
      read_line();
    while (m_reader.next_line());
    if (m_has_number && m_soup.points.size() != m_number_of_points)
      m_reader.fail(std::to_string(m_number_of_points) + " points, as the first line has it",
                    std::to_string(m_soup.points.size()));
    sort_columns();
    m_soup.rounding = rounding_of_text(m_soup.points, m_reader);
    return std::move(m_soup);
  }

private:
  void read_line()
  {
    const std::size_t number = m_reader.words().size();
    if (number < 3 || number != m_columns.size())
      throw Unreadable(
          "line " + std::to_string(m_reader.line_number()) + ": expected " +
              (m_columns.size() < 3 ? "three coordinates" : std::to_string(m_columns.size()) + " numbers, as before") +
              ", found " + std::to_string(number),
          m_reader.line_number() == 1 ? Unreadable::BEGINNING : Unreadable::ELSEWHERE);
    const auto expected = [this] { return "a coordinate of point " + std::to_string(m_soup.points.size() + 1); };
    double c[3];
    for (double& x : c)
      x = m_reader.finite_number(m_reader.word(expected), expected);
    m_soup.points.emplace_back(c[0], c[1], c[2]);
    for (std::size_t k = 3; k < number; ++k)
    {
      double value = 0;
      const std::string_view word = m_reader.words()[k];
      if (!Text_reader::to_number(word, value))
        m_reader.fail("a number", word);
      m_columns[k].push_back(value);
    }
    m_reader.skip_line();
  }

  // The first three columns behind the coordinates are a normal, as CGAL has it, or a colour, if they are whole numbers as of bytes.
  void sort_columns()
  {
    std::size_t next = 3;
    if (m_columns.size() >= 6)
    {
      if (is_colour())
        for (const char* name : {"red", "green", "blue"})
          m_soup.vertex_arrays.push_back(Array{name, std::move(m_columns[next++]), true});
      else
      {
        for (std::size_t i = 0; i < m_soup.points.size(); ++i)
          m_soup.normals.emplace_back(m_columns[3][i], m_columns[4][i], m_columns[5][i]);
        next = 6;
      }
    }
    for (; next < m_columns.size(); ++next)
      m_soup.vertex_arrays.push_back(Array{"column_" + std::to_string(next + 1), std::move(m_columns[next])});
  }

  bool is_colour() const
  {
    bool has_more_than_one = false;
    for (std::size_t k = 3; k < 6; ++k)
      for (const double value : m_columns[k])
      {
        if (!(value >= 0 && value <= 255) || value != std::floor(value))
          return false;
        has_more_than_one = has_more_than_one || value > 1;
      }
    return has_more_than_one;
  }

  Text_reader m_reader;
  Soup m_soup;
  bool m_has_number = false;
  std::size_t m_number_of_points = 0;
  std::vector<std::vector<double>> m_columns; // from the fourth one on
};

} // namespace

Soup read_xyz(const std::string& text) { return Xyz_reader(text).read(); }

} // namespace hde_remesh
