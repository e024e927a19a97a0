// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_CELL_SET_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_CELL_SET_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <unordered_set>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

struct Hash_of_cell
{
  std::size_t operator()(std::uint64_t x) const
  {
    x = (x ^ (x >> 31)) * 0x9E3779B97F4A7C15u;
    return std::size_t(x ^ (x >> 29));
  }
};

// Numbers of cells. Most cells that are asked for are not there: a bit tells that without a search.
class Cell_set
{
  static constexpr std::size_t number_of_bits = 1 << 16; // they fit into the cache

public:
  void insert(const std::uint64_t cell)
  {
    m_cells.insert(cell);
    m_is_any.set(bit(cell));
  }

  bool contains(const std::uint64_t cell) const { return m_is_any[bit(cell)] && m_cells.count(cell) > 0; }
  bool empty() const { return m_cells.empty(); }

private:
  static std::size_t bit(const std::uint64_t cell) { return Hash_of_cell()(cell) % number_of_bits; }

  std::bitset<number_of_bits> m_is_any;
  std::unordered_set<std::uint64_t, Hash_of_cell> m_cells;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_CELL_SET_H
