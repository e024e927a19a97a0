// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "nearest_word.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hde_remesh {

std::size_t edit_distance(const std::string& first, const std::string& second)
{
  typedef std::vector<std::size_t> Row; // the distances of a beginning of the first word to all beginnings of the second
  Row row(second.size() + 1), before, before_that;
  for (std::size_t j = 0; j <= second.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= first.size(); ++i)
  {
    before_that = std::exchange(before, row);
    row[0] = i;
    for (std::size_t j = 1; j <= second.size(); ++j)
    {
      row[j] = (std::min)({before[j] + 1, row[j - 1] + 1, before[j - 1] + (first[i - 1] == second[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && first[i - 1] == second[j - 2] && first[i - 2] == second[j - 1])
        row[j] = (std::min)(row[j], before_that[j - 2] + 1);
    }
  }
  return row.back();
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& words)
{
  const auto begins_so = [&word](const std::string& other) { return other.compare(0, word.size(), word) == 0; };
  if (word.size() > 2 && std::count_if(words.begin(), words.end(), begins_so) == 1)
    return *std::find_if(words.begin(), words.end(), begins_so);
  std::string nearest;
  std::size_t least = 0;
  for (const std::string& other : words)
  {
    const std::size_t distance = edit_distance(word, other);
    if (3 * distance <= other.size() && (nearest.empty() || distance < least))
    {
      nearest = other;
      least = distance;
    }
  }
  return nearest;
}

} // namespace hde_remesh
