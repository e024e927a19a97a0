// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "ply_header.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <vector>

namespace hde_remesh {

namespace {

const std::vector<std::string> types = {"char", "int8",  "uchar", "uint8",  "short", "int16",   "ushort", "uint16",
                                        "int",  "int32", "uint",  "uint32", "float", "float32", "double", "float64"};

bool is_type(const std::string& word) { return std::find(types.begin(), types.end(), word) != types.end(); }

bool is_whole_number(const std::string& word)
{
  return !word.empty() && word.size() < 19 && word.find_first_not_of("0123456789") == std::string::npos;
}

// `property TYPE NAME` or `property list TYPE TYPE NAME`
bool is_property(const std::vector<std::string>& words)
{
  if (words.size() == 3)
    return is_type(words[1]);
  return words.size() == 5 && words[1] == "list" && is_type(words[2]) && is_type(words[3]);
}

// of one line, after others; `size` of the file in bytes, which has one at least for every element
std::string problem_of_line(const std::vector<std::string>& words, const std::size_t size, bool& has_element)
{
  const std::string& keyword = words.front();
  if (keyword == "element")
  {
    has_element = true;
    if (words.size() != 3 || !is_whole_number(words[2]))
      return "an element needs a name and a number";
    return std::stoull(words[2]) <= size ? "" : "the file is too short for " + words[2] + " of " + words[1];
  }
  if (keyword == "property")
    return !has_element ? "a property comes before any element" : is_property(words) ? "" : "no property of a known type";
  static const std::vector<std::string> others = {"ply", "format", "comment", "obj_info"};
  return std::find(others.begin(), others.end(), keyword) != others.end()
             ? ""
             : "'" + keyword.substr(0, 40) + "' begins no line of a header";
}

} // namespace

std::string problem_of_ply_header(const std::string& text)
{
  std::istringstream lines(text);
  bool has_element = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
      words.push_back(word);
    if (words.empty())
      continue;
    if (number == 1 && words.front() != "ply")
      return "line 1: a PLY file begins with 'ply'";
    if (words.front() == "end_header")
      return "";
    const std::string problem = problem_of_line(words, text.size(), has_element);
    if (!problem.empty())
      return "line " + std::to_string(number) + ": " + problem;
  }
  return "the header does not end";
}

} // namespace hde_remesh
