// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_NEAR_SHEETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_NEAR_SHEETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Cell_set.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Indexed_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Triangle_groups.h>

#include <Eigen/Geometry>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Where sheets of a surface are so near to each other that the faces of a mesh of it are likely to intersect: nearer than the surface
// rises above the edges. Such places are cells of a grid. A triangle asks in a grid with cells of its own size.
class Near_sheets
{
  static constexpr double largest_cosine = -0.2; // of the normals of sheets that look away from each other
  static constexpr double cosine_of_same = 0.7;  // of those of sheets one above the other
  static constexpr double share_above = 0.6;     // of the way to a point: its height above a sheet
  // Distances of a mesh: over the heights expected at the place, over the root mean square of all heights, and over the length.
  static constexpr double share_of_height = 1, share_of_mean = 0.75, share_of_length = 0.025;
  static constexpr double largest_rounding = 1e-6;           // over the length: as near is the sheet of the point itself
  static constexpr double largest_number_of_cells = 1 << 12; // along the diagonal: a needle has no more points

public:
  // every place
  Near_sheets() = default;

  // `heights` has for each triangle how high the surface rises above the edges of the mesh, and `length` is that of its edges
  template <typename ConcurrencyTag>
  Near_sheets(const std::vector<Indexed_triangle>& triangles, const Triangle_groups<ConcurrencyTag>& groups,
              const std::vector<double>& heights, const double length)
  {
    set_grids(triangles, length);
    const double mean = mean_height(triangles, heights);
    const std::vector<Sample> samples = highest_samples(triangles, heights);
    std::vector<boost::container::small_vector<Vector, 2>> places(samples.size()); // that are near to another sheet
    parallel_for<ConcurrencyTag>(
        samples.size(),
        [&](const std::size_t i)
        {
          const Sample& s = samples[i];
          const double distance = (std::max)({share_of_height * s.height, share_of_mean * mean, share_of_length * m_size});
          Vector other;
          if (find_sheet(s, distance, triangles, groups, other))
            places[i] = {s.point, other};
        });
    for (const auto& of_sample : places)
      for (const Vector& p : of_sample)
        add_cell(cell(p));
  }

  bool empty() const { return !m_near.empty() && m_near.front().empty(); }

  // whether another sheet may be near the triangle
  bool contains(const Indexed_triangle& t) const
  {
    if (m_near.empty())
      return true;
    if (m_near.front().empty())
      return false;
    const Vector low = t.points[0].cwiseMin(t.points[1]).cwiseMin(t.points[2]),
                 high = t.points[0].cwiseMax(t.points[1]).cwiseMax(t.points[2]);
    std::size_t level = 0;
    for (double size = m_size; level + 1 < m_near.size() && size < (high - low).maxCoeff(); size *= 2)
      ++level;
    const Cell first = parent(cell(low), level), last = parent(cell(high), level);
    Cell c;
    for (c[0] = first[0]; c[0] <= last[0]; ++c[0])
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1])
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2])
          if (m_near[level].contains(key(c)))
            return true;
    return false;
  }

  // makes the places of the triangle and those around some of them
  void add(const Indexed_triangle& t)
  {
    if (m_near.empty())
      return;
    for_each_point(t,
                   [&](const Vector& p)
                   {
                     const Cell middle = cell(p);
                     Cell c;
                     for (c[0] = middle[0] - 1; c[0] <= middle[0] + 1; ++c[0])
                       for (c[1] = middle[1] - 1; c[1] <= middle[1] + 1; ++c[1])
                         for (c[2] = middle[2] - 1; c[2] <= middle[2] + 1; ++c[2])
                           add_cell(c);
                   });
  }

private:
  typedef std::int64_t Index;
  typedef Eigen::Matrix<Index, 3, 1> Cell;
  struct Sample
  {
    Vector point, normal;
    double height;
  };

  void set_grids(const std::vector<Indexed_triangle>& triangles, const double length)
  {
    Eigen::AlignedBox3d box;
    for (const Indexed_triangle& t : triangles)
      for (const Vector& p : t.points)
        box.extend(p);
    const double diagonal = triangles.empty() ? 0 : box.diagonal().norm();
    m_low = triangles.empty() ? Vector::Zero() : box.min();
    m_size = (std::max)({length, diagonal / largest_number_of_cells, (std::numeric_limits<double>::min)()});
    std::size_t number_of_grids = 1;
    while (std::ldexp(m_size, int(number_of_grids)) < diagonal)
      ++number_of_grids;
    m_near.resize(number_of_grids);
  }

  static double mean_height(const std::vector<Indexed_triangle>& triangles, const std::vector<double>& heights)
  {
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      const double a = triangles[i].normal().norm();
      sum += a * heights[i] * heights[i];
      area += a;
    }
    return area > 0 ? std::sqrt(sum / area) : 0;
  }

  // in each cell the point where the surface rises most
  std::vector<Sample> highest_samples(const std::vector<Indexed_triangle>& triangles, const std::vector<double>& heights) const
  {
    std::unordered_map<std::uint64_t, std::size_t, Hash_of_cell> indices;
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      const Vector normal = triangles[i].normal();
      const double area = normal.norm();
      if (!(area > 0))
        continue;
      for_each_point(triangles[i],
                     [&](const Vector& p)
                     {
                       const auto added = indices.emplace(key(cell(p)), samples.size());
                       if (added.second)
                         samples.push_back(Sample{p, normal / area, heights[i]});
                       else if (samples[added.first->second].height < heights[i])
                         samples[added.first->second] = Sample{p, normal / area, heights[i]};
                     });
    }
    return samples;
  }

  // whether there is another sheet within the distance, and where it is
  template <typename ConcurrencyTag>
  bool find_sheet(const Sample& s, const double distance, const std::vector<Indexed_triangle>& triangles,
                  const Triangle_groups<ConcurrencyTag>& groups, Vector& other) const
  {
    const double rounding = largest_rounding * m_size;
    double least = distance * distance;
    bool is_found = false;
    groups.for_each_near(s.point, distance,
                         [&](const std::size_t i)
                         {
                           const Indexed_triangle& t = triangles[i];
                           const Vector normal = t.normal();
                           const double cosine = normal.dot(s.normal) / normal.norm();
                           if (!(cosine < largest_cosine || cosine > cosine_of_same))
                             return;
                           const auto closest = closest_on_triangle(s.point, t.points[0], t.points[1], t.points[2]);
                           if (!(closest.squared_distance < least))
                             return;
                           const Vector p = closest.barycentric[0] * t.points[0] + closest.barycentric[1] * t.points[1] +
                                            closest.barycentric[2] * t.points[2];
                           if (cosine > 0 && !(std::abs((p - s.point).dot(s.normal)) >
                                               (std::max)(share_above * std::sqrt(closest.squared_distance), rounding)))
                             return;
                           least = closest.squared_distance;
                           other = p;
                           is_found = true;
                         });
    return is_found;
  }

  // calls `visit(point)` for points of the triangle that are not further from each other than cells are large
  template <typename Visit>
  void for_each_point(const Indexed_triangle& t, const Visit& visit) const
  {
    const std::array<double, 3> lengths = {(t.points[1] - t.points[0]).norm(), (t.points[2] - t.points[1]).norm(),
                                           (t.points[0] - t.points[2]).norm()};
    const std::size_t first = std::size_t(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const Vector &a = t.point(first), &b = t.point(first + 1), &c = t.point(first + 2);
    const double height = lengths[first] > 0 ? t.normal().norm() / lengths[first] : 0;
    const double rows = std::ceil((std::max)(height / m_size, 1.));
    for (double row = 0; row < rows; ++row)
    {
      const double up = (row + 1. / 3) / rows; // one row: through the centroid
      const double points = std::ceil((std::max)((1 - up) * lengths[first] / m_size, 1.));
      for (double i = 0; i < points; ++i)
        visit(up * c + (1 - up) * (a + (i + 0.5) / points * (b - a)));
    }
  }

  Cell cell(const Vector& p) const // of the smallest ones
  {
    return ((p - m_low) / m_size).array().floor().max(-1.).min(largest_number_of_cells + 1).matrix().cast<Index>();
  }

  static Cell parent(const Cell& c, const std::size_t level)
  {
    return c.unaryExpr([level](const Index i) { return i >> level; });
  }

  static std::uint64_t key(const Cell& c)
  {
    static constexpr int bits = 21; // of an index
    return std::uint64_t(c[0] + 2) | std::uint64_t(c[1] + 2) << bits | std::uint64_t(c[2] + 2) << 2 * bits;
  }

  // in all grids
  void add_cell(const Cell& c)
  {
    for (std::size_t level = 0; level < m_near.size(); ++level)
      m_near[level].insert(key(parent(c, level)));
  }

  Vector m_low = Vector::Zero();
  double m_size = 0;            // of the smallest cells; those of each further grid are twice as large
  std::vector<Cell_set> m_near; // by grid; no grid: every place
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_NEAR_SHEETS_H
