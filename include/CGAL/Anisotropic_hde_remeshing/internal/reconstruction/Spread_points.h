// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_SPREAD_POINTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_SPREAD_POINTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/points_on_zero_set.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Points that can be asked whether one of them is near. Points that look the other way do not count: they are on another sheet.
class Spread_points
{
  typedef std::array<double, 3> Cell; // whole numbers, which do not overflow

public:
  explicit Spread_points(const double distance) : m_distance(distance) {}

  void add(const Oriented_point& p)
  {
    m_cells[cell_of(p.point)].push_back(m_points.size());
    m_points.push_back(p);
  }

  bool has_near(const Oriented_point& p) const
  {
    const Cell cell = cell_of(p.point);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
        {
          const auto found = m_cells.find(Cell{cell[0] + i, cell[1] + j, cell[2] + k});
          if (found == m_cells.end())
            continue;
          for (const std::size_t q : found->second)
            if ((m_points[q].point - p.point).squaredNorm() < m_distance * m_distance && m_points[q].normal.dot(p.normal) >= 0)
              return true;
        }
    return false;
  }

  const std::vector<Oriented_point>& points() const { return m_points; }

private:
  Cell cell_of(const Vector& p) const
  {
    return Cell{std::floor(p[0] / m_distance), std::floor(p[1] / m_distance), std::floor(p[2] / m_distance)};
  }

  double m_distance;
  std::vector<Oriented_point> m_points;
  std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> m_cells;
};

// those that are no nearer to another one, the first ones first
inline std::vector<Oriented_point> well_spread(const std::vector<Oriented_point>& points, const double distance)
{
  Spread_points result(distance);
  for (const Oriented_point& p : points)
    if (!result.has_near(p))
      result.add(p);
  return result.points();
}

// Takes one point in each cell of a grid for each of six directions of normals: about as many points as the surface has place for,
// found without a search.
class Cell_filter
{
public:
  explicit Cell_filter(const double size) : m_size(size) {}

  // whether it is the first one like that
  bool accepts(const Oriented_point& p)
  {
    Eigen::Index axis = 0;
    p.normal.cwiseAbs().maxCoeff(&axis);
    const double direction = p.normal[axis] < 0 ? -1. - double(axis) : 1. + double(axis);
    return m_taken
        .insert({std::floor(p.point[0] / m_size), std::floor(p.point[1] / m_size), std::floor(p.point[2] / m_size), direction})
        .second;
  }

private:
  double m_size;
  std::unordered_set<std::array<double, 4>, boost::hash<std::array<double, 4>>> m_taken;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_SPREAD_POINTS_H
