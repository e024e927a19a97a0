// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_TRIANGLE_GRIDS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_TRIANGLE_GRIDS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Indexed_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/rounded_box.h>

#include <Eigen/Geometry>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Triangles that come and go, by their numbers, and those whose bounding boxes meet a box. Most are in one grid, larger ones in
// others with larger cells. A triangle is in the cells that it meets, eight at most. In an R-tree, to insert and to remove a triangle
// takes ten times as long.
class Triangle_grids
{
  typedef Eigen::Matrix<std::int64_t, 3, 1> Cell;
  // of a triangle in a cell; its box, rounded to the outside, is here, as most queries need no more
  struct Slot
  {
    Eigen::AlignedBox3f box;
    std::uint32_t entry;
  };
  typedef boost::container::small_vector<Slot, 6> Slots;
  struct Hash
  {
    std::size_t operator()(const std::uint64_t key) const { return std::size_t(key); } // keys are mixed already
  };
  struct Grid
  {
    double size_of_cells; // as large as the boxes at least
    std::size_t number_of_triangles = 0;
    std::unordered_map<std::uint64_t, Slots, Hash> cells;
  };

public:
  typedef Eigen::AlignedBox3d Box;

  static Box box_of(const Indexed_triangle& t)
  {
    return Box(t.points[0].cwiseMin(t.points[1]).cwiseMin(t.points[2]),
               t.points[0].cwiseMax(t.points[1]).cwiseMax(t.points[2]));
  }

  // `size` is that of most of the triangles to come
  void clear(const double size)
  {
    m_size = size > 0 ? size : 1;
    m_grids.clear();
    m_entries.clear();
    m_free.clear();
    m_slots.clear();
  }

  bool has(const std::size_t number) const { return number < m_slots.size() && m_slots[number] != none; }

  const Indexed_triangle& operator[](const std::size_t number) const { return m_entries[m_slots[number]].triangle; }

  // it must not be there yet
  void insert(const std::size_t number, const Indexed_triangle& triangle)
  {
    if (number >= m_slots.size())
      m_slots.resize(number + 1, none);
    if (m_free.empty())
    {
      m_free.push_back(std::uint32_t(m_entries.size()));
      m_entries.emplace_back();
    }
    const std::uint32_t slot = m_slots[number] = m_free.back();
    m_free.pop_back();
    const Box box = box_of(triangle);
    const int level = level_of(box);
    m_entries[slot] = Entry{triangle, box, number, level};
    Grid& grid = m_grids.try_emplace(level, Grid{m_size * std::pow(growth, level), 0, {}}).first->second;
    ++grid.number_of_triangles;
    const Slot in_cell{rounded_box(box.min(), box.max()), slot};
    for_each_cell(box, grid.size_of_cells, [&](const Cell& c) { grid.cells[key(c)].push_back(in_cell); });
  }

  // it must be there
  void remove(const std::size_t number)
  {
    const std::uint32_t slot = m_slots[number];
    const Entry& entry = m_entries[slot];
    const auto grid = m_grids.find(entry.level);
    for_each_cell(entry.box, grid->second.size_of_cells,
                  [&](const Cell& c)
                  {
                    const auto cell = grid->second.cells.find(key(c));
                    cell->second.erase(std::find_if(cell->second.begin(), cell->second.end(),
                                                    [slot](const Slot& s) { return s.entry == slot; }));
                    if (cell->second.empty())
                      grid->second.cells.erase(cell);
                  });
    if (--grid->second.number_of_triangles == 0)
      m_grids.erase(grid);
    m_free.push_back(slot);
    m_slots[number] = none;
  }

  // calls `visit(number, triangle, box)` once for each triangle whose box meets the box, in any order
  template <typename Visit>
  void for_each_near(const Box& box, const Visit& visit) const
  {
    const Eigen::AlignedBox3f rounded = rounded_box(box.min(), box.max());
    for (const auto& level : m_grids)
    {
      const Grid& grid = level.second;
      const Vector number_of_cells = (box.sizes() / grid.size_of_cells).array() + 1.;
      if (number_of_cells.prod() > double(grid.number_of_triangles))
        for_each_in_grid(grid, box, visit);
      else
        for_each_cell(box, grid.size_of_cells,
                      [&](const Cell& c)
                      {
                        const auto found = grid.cells.find(key(c));
                        if (found != grid.cells.end())
                          for_each_in_cell(found->second, c, grid.size_of_cells, box, rounded, visit);
                      });
    }
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  static constexpr double growth = 4; // of the cells from grid to grid

  struct Entry
  {
    Indexed_triangle triangle;
    Box box;
    std::size_t number;
    int level;
  };

  int level_of(const Box& box) const
  {
    int level = 0;
    for (double size = m_size; size < box.sizes().maxCoeff(); size *= growth)
      ++level;
    return level;
  }

  static Cell cell(const Vector& p, const double size)
  {
    const auto floor = [](const double x)
    {
      const std::int64_t i = std::int64_t(x);
      return i - (double(i) > x ? 1 : 0);
    };
    return Cell(floor(p[0] / size), floor(p[1] / size), floor(p[2] / size));
  }

  // Cells may have the same key: boxes tell.
  static std::uint64_t key(const Cell& c)
  {
    std::uint64_t x = std::uint64_t(c[0]) * 0x9E3779B97F4A7C15u ^ std::uint64_t(c[1]) * 0xC2B2AE3D27D4EB4Fu ^
                      std::uint64_t(c[2]) * 0x165667B19E3779F9u;
    return x ^ (x >> 32);
  }

  template <typename Visit>
  static void for_each_cell(const Box& box, const double size, const Visit& visit)
  {
    const Cell first = cell(box.min(), size), last = cell(box.max(), size);
    Cell c;
    for (c[0] = first[0]; c[0] <= last[0]; ++c[0])
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2])
          visit(c);
  }

  // a triangle in several cells is visited in the first one that it shares with the box
  template <typename Visit>
  void for_each_in_cell(const Slots& slots, const Cell& c, const double size, const Box& box,
                        const Eigen::AlignedBox3f& rounded, const Visit& visit) const
  {
    for (const Slot& slot : slots)
    {
      if (!slot.box.intersects(rounded))
        continue;
      const Entry& entry = m_entries[slot.entry];
      if (entry.box.intersects(box) && cell(entry.box.min().cwiseMax(box.min()), size) == c)
        visit(entry.number, entry.triangle, entry.box);
    }
  }

  template <typename Visit>
  void for_each_in_grid(const Grid& grid, const Box& box, const Visit& visit) const
  {
    for (const auto& cell_of_grid : grid.cells)
      for (const Slot& slot : cell_of_grid.second)
      {
        const Entry& entry = m_entries[slot.entry];
        if (entry.box.intersects(box) && key(cell(entry.box.min(), grid.size_of_cells)) == cell_of_grid.first)
          visit(entry.number, entry.triangle, entry.box);
      }
  }

  double m_size = 1;           // of the cells of the first grid
  std::map<int, Grid> m_grids; // by level
  std::vector<Entry> m_entries;
  std::vector<std::uint32_t> m_free;  // of the entries
  std::vector<std::uint32_t> m_slots; // the entries of the numbers
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_TRIANGLE_GRIDS_H
