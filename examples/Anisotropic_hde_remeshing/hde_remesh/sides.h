// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The edges of a soup: the sides of its faces, sorted.

#ifndef HDE_REMESH_SIDES_H
#define HDE_REMESH_SIDES_H

#include "Soup.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace hde_remesh {

// a side of a face: its ends, in the order of the face, and its corners there, which are numbered through all faces
struct Side
{
  std::size_t source, target, face, corner, next_corner;

  std::pair<std::size_t, std::size_t> ends() const { return std::minmax(source, target); }
};

inline std::vector<Side> sides_of(const Soup& soup)
{
  std::vector<Side> result;
  std::size_t corner = 0;
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
  {
    const std::vector<std::size_t>& face = soup.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const std::size_t next = (k + 1) % face.size();
      result.push_back({face[k], face[next], f, corner + k, corner + next});
    }
    corner += face.size();
  }
  return result; // as many as corners
}

// Calls `use` with the numbers of the sides of each edge, in their order; `ends` are those of a side.
template <typename Ends, typename Use>
void for_each_edge(const std::vector<Side>& sides, const Ends& ends, const Use& use)
{
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> keys;
  keys.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const std::pair<std::size_t, std::size_t> pair = ends(sides[i]);
    keys.emplace_back(pair.first, pair.second, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> of_edge;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    of_edge.push_back(std::get<2>(keys[i]));
    if (i + 1 < keys.size() && std::get<0>(keys[i]) == std::get<0>(keys[i + 1]) &&
        std::get<1>(keys[i]) == std::get<1>(keys[i + 1]))
      continue;
    use(of_edge);
    of_edge.clear();
  }
}

template <typename Use>
void for_each_edge(const std::vector<Side>& sides, const Use& use)
{
  for_each_edge(
      sides, [](const Side& side) { return side.ends(); }, use);
}

// sets that are merged of single numbers; the least one stands for a set
class Sets
{
public:
  explicit Sets(const std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), std::size_t(0)); }

  std::size_t root(std::size_t i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  void join(std::size_t a, std::size_t b)
  {
    a = root(a);
    b = root(b);
    m_parent[(std::max)(a, b)] = (std::min)(a, b);
  }

private:
  std::vector<std::size_t> m_parent;
};

} // namespace hde_remesh

#endif // HDE_REMESH_SIDES_H
