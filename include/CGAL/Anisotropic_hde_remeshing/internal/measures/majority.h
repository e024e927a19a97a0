// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_MAJORITY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_MAJORITY_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The value that most of the elements have, of those that are as many the one that comes first. `value_of_element` tells the value of
// each; values are compared by `==` only. There must be an element.
template <typename Value, typename Elements, typename ValueOfElement>
Value majority(const Elements& elements, const ValueOfElement& value_of_element)
{
  std::vector<std::pair<Value, std::size_t>> counts;
  auto last = *elements.begin();
  std::size_t last_position = 0;
  for (const auto& element : elements)
  {
    if (counts.empty() || element != last) // most follow one of the same
    {
      const Value value = value_of_element(element);
      last = element;
      last_position = 0;
      while (last_position < counts.size() && !(counts[last_position].first == value))
        ++last_position;
      if (last_position == counts.size())
        counts.emplace_back(value, 0);
    }
    ++counts[last_position].second;
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < counts.size(); ++i)
    if (counts[i].second > counts[best].second)
      best = i;
  return counts[best].first;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_MAJORITY_H
