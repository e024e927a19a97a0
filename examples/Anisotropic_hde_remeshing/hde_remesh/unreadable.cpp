// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "unreadable.h"

#include "ply_header.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

namespace hde_remesh {

namespace {

const char* const blanks = " \t\r\v\f";

// the words of a line, without a comment
std::vector<std::string> words_of(const std::string& line)
{
  std::vector<std::string> words;
  const std::size_t end = (std::min)(line.find('#'), line.size());
  std::size_t begin = line.find_first_not_of(blanks);
  while (begin < end)
  {
    const std::size_t after = (std::min)((std::min)(line.find_first_of(blanks, begin), line.size()), end);
    words.push_back(line.substr(begin, after - begin));
    begin = line.find_first_not_of(blanks, after);
  }
  return words;
}

bool is_finite_number(const std::string& word)
{
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0' && std::isfinite(value);
}

// the words of a line that have to be numbers
std::vector<std::string> numbers_of(const std::vector<std::string>& words, const Format format)
{
  if (words.empty())
    return {};
  const auto words_from = [&words](const std::size_t first, const std::size_t number)
  {
    const std::size_t begin = (std::min)(first, words.size()), end = (std::min)(first + number, words.size());
    return std::vector<std::string>(words.begin() + begin, words.begin() + end);
  };
  switch (format)
  {
  case Format::OBJ: // coordinates, and the vertex of each "vertex/texture/normal"
    if (words.front() == "f")
    {
      std::vector<std::string> vertices = words_from(1, words.size());
      for (std::string& word : vertices)
        word = word.substr(0, word.find('/'));
      return vertices;
    }
    return words.front() == "v" ? words_from(1, 3) : std::vector<std::string>();
  case Format::STL:
    return words.front() == "vertex" ? words_from(1, 3) : std::vector<std::string>();
  default:
    return words;
  }
}

// where the numbers of a text begin: after the header, which has words of its own; nowhere in a binary file
std::size_t begin_of_numbers(const std::string& text, const Format format)
{
  const auto line_after = [&text](const std::size_t position)
  {
    const std::size_t end = text.find('\n', position);
    return end == std::string::npos ? text.size() : end + 1;
  };
  if (format == Format::PLY)
  {
    const std::size_t header = text.find("end_header");
    const bool is_text = header != std::string::npos && text.find("format ascii") < header;
    return is_text ? line_after(header) : text.size();
  }
  if (format != Format::OFF)
    return 0;
  const std::size_t keyword = text.find("OFF");
  const std::size_t first_line_end = line_after(0);
  if (text.substr(0, first_line_end).find("BINARY") != std::string::npos)
    return text.size();
  // the counts may follow the keyword in its line, where nothing goes wrong unseen
  return keyword < first_line_end ? first_line_end : 0;
}

std::string problem_of_text(const std::string& text, const Format format)
{
  const std::size_t begin = begin_of_numbers(text, format);
  std::size_t line_number = 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + begin, '\n'));
  std::istringstream lines(text.substr(begin));
  for (std::string line; std::getline(lines, line); ++line_number)
    for (const std::string& word : numbers_of(words_of(line), format))
      if (!is_finite_number(word))
        return "line " + std::to_string(line_number) + ": '" + word.substr(0, 40) + "' is not a finite number";
  return "";
}

const std::size_t stl_header_size = 84, stl_facet_size = 50;

bool is_binary_stl(const std::string& text)
{
  if (text.size() < stl_header_size)
    return false;
  std::uint32_t number = 0;
  std::memcpy(&number, text.data() + 80, sizeof(number));
  return text.size() == stl_header_size + stl_facet_size * static_cast<std::size_t>(number);
}

// CGAL merges the equal points of an STL file by sorting them, which goes wrong unseen with one that is not a number.
std::string problem_of_binary_stl(const std::string& text)
{
  for (std::size_t position = stl_header_size; position < text.size(); position += stl_facet_size)
    for (int i = 3; i < 12; ++i) // the first three are the normal, which nobody uses
    {
      float value = 0;
      std::memcpy(&value, text.data() + position + i * sizeof(value), sizeof(value));
      if (!std::isfinite(value))
        return "face " + std::to_string((position - stl_header_size) / stl_facet_size + 1) + " has the coordinate " +
               std::to_string(value);
    }
  return "";
}

} // namespace

std::string problem_of_numbers(const std::string& text, const Format format)
{
  if (format == Format::STL && is_binary_stl(text))
    return problem_of_binary_stl(text);
  if (format == Format::PLY)
  {
    std::string problem = problem_of_ply_header(text);
    if (!problem.empty())
      return problem;
  }
  return problem_of_text(text, format);
}

} // namespace hde_remesh
