// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_WRAPPED_H
#define HDE_REMESH_WRAPPED_H

#include <cstddef>
#include <sstream>
#include <string>

namespace hde_remesh {

constexpr std::size_t columns_of_text = 100; // of all that is printed, but for names of files

// Behind a beginning of a line the words of the text, in lines of at most 100 columns. All lines but the first begin with blanks.
inline std::string wrapped(const std::string& beginning, const std::string& text, const std::size_t indent)
{
  std::string result, line = beginning;
  bool has_words = false;
  std::istringstream words(text);
  for (std::string word; words >> word; has_words = true)
  {
    if (has_words && line.size() + 1 + word.size() > columns_of_text)
    {
      result += line + '\n';
      line.assign(indent, ' ');
      has_words = false;
    }
    line += (has_words ? " " : "") + word;
  }
  return result + line + '\n';
}

} // namespace hde_remesh

#endif // HDE_REMESH_WRAPPED_H
