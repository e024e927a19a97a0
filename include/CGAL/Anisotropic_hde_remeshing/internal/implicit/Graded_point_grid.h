// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_GRADED_POINT_GRID_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_GRADED_POINT_GRID_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Points with sizes that vary gradually: whether one is near a place. There is a grid for each power of two. A point is in the grid
// of its size, and a place looks into the grids of sizes like its own. The cells are wide, so that it looks into few of them in the
// grids of smaller sizes. Coordinates are below 1.
class Graded_point_grid
{
  static constexpr int smallest_level = -50; // of which the cells are 1e-15
  static constexpr int levels_around = 2;
  static constexpr int width_of_cells = 2; // by levels above that of the size

public:
  void insert(const Vector& p, const double size)
  {
    const int level = level_of(size);
    m_levels[level][key(cell(p, level))].push_back(m_points.size());
    m_points.push_back(p);
  }

  // whether there is a point, by its index, within `radius` that meets the condition; `radius` is about `size`
  template <typename Condition>
  bool has_near(const Vector& p, const double radius, const double size, const Condition& condition) const
  {
    for (auto level = m_levels.lower_bound(level_of(size) - levels_around);
         level != m_levels.end() && level->first <= level_of(size) + levels_around; ++level)
    {
      const Cell low = cell(p - Vector::Constant(radius), level->first),
                 high = cell(p + Vector::Constant(radius), level->first);
      Cell at;
      for (at.x = low.x; at.x <= high.x; ++at.x)
        for (at.y = low.y; at.y <= high.y; ++at.y)
          for (at.z = low.z; at.z <= high.z; ++at.z)
          {
            const auto found = level->second.find(key(at));
            if (found != level->second.end() &&
                std::any_of(found->second.begin(), found->second.end(),
                            [&](const std::size_t i)
                            { return (m_points[i] - p).squaredNorm() < radius * radius && condition(i); }))
              return true;
          }
    }
    return false;
  }

private:
  struct Cell
  {
    std::int64_t x, y, z;
  };

  static int level_of(const double size)
  {
    int exponent = 0;
    std::frexp(size, &exponent);
    return (std::max)(exponent, smallest_level);
  }

  static Cell cell(const Vector& p, const int level)
  {
    const auto index = [&](const Eigen::Index k)
    { return std::int64_t(std::floor(std::ldexp(p[k], -(level + width_of_cells)))); };
    return Cell{index(0), index(1), index(2)};
  }

  // Cells may have the same key. Then a look into one finds the points of the other, too, and their distances tell.
  static std::uint64_t key(const Cell& c)
  {
    return (std::uint64_t(c.x) * 0x9E3779B97F4A7C15u) ^ (std::uint64_t(c.y) * 0xC2B2AE3D27D4EB4Fu) ^
           (std::uint64_t(c.z) * 0x165667B19E3779F9u);
  }

  std::vector<Vector> m_points;
  std::map<int, std::unordered_map<std::uint64_t, std::vector<std::size_t>>> m_levels;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_GRADED_POINT_GRID_H
