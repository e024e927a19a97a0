// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_TRIANGLE_GROUPS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_TRIANGLE_GROUPS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Indexed_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/rounded_box.h>

#include <Eigen/Geometry>
#include <boost/geometry/algorithms/covered_by.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Finds triangles whose bounding boxes meet. Triangles of about the same size and place are in a group, and the groups are in an
// R-tree: to look at all boxes of a group is faster than to have each of them in the tree. The triangles must outlive it.
template <typename ConcurrencyTag>
class Triangle_groups
{
  static constexpr std::size_t size_of_group = 16;
  static constexpr int bits = 18; // of a place along an axis

  typedef Eigen::AlignedBox3f Box; // rounded to the outside
  typedef boost::geometry::model::point<float, 3, boost::geometry::cs::cartesian> Corner;
  typedef boost::geometry::model::box<Corner> Box_in_tree;
  typedef std::pair<Box_in_tree, std::uint32_t> Entry;
  typedef boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> Tree;

public:
  typedef std::pair<std::size_t, std::size_t> Pair;

  explicit Triangle_groups(const std::vector<Indexed_triangle>& triangles) : m_triangles(triangles)
  {
    sort();
    m_groups.resize((m_order.size() + size_of_group - 1) / size_of_group);
    parallel_for<ConcurrencyTag>(
        m_groups.size(), [&](const std::size_t g) { fill(g); }, 64);
    std::vector<Entry> entries;
    for (std::size_t g = 0; g < m_groups.size(); ++g)
      entries.emplace_back(in_tree(m_groups[g].box), std::uint32_t(g));
    m_tree = Tree(entries); // packed
  }

  // calls `visit(i)` for the triangles whose boxes come as near to the point, along each axis
  template <typename Visit>
  void for_each_near(const Vector& p, const double distance, const Visit& visit) const
  {
    const Box box = rounded_box(p - Vector::Constant(distance), p + Vector::Constant(distance));
    for_each_group(box,
                   [&](const std::size_t g)
                   {
                     const Flags flags = m_groups[g].meeting(box);
                     for (std::size_t k = 0; k < size_of_group; ++k)
                       if (flags[k])
                         visit(std::size_t(m_order[g * size_of_group + k]));
                   });
  }

  // the pairs of triangles that intersect, in the order of their numbers, the smaller number first
  std::vector<Pair> intersecting_pairs(Interruption& interruption) const
  {
    std::vector<std::vector<Pair>> pairs(m_groups.size());
    parallel_for<ConcurrencyTag>(
        pairs.size(), [&](const std::size_t g) { add_pairs(g, pairs[g]); }, 16, interruption);
    std::vector<Pair> result;
    for (const std::vector<Pair>& of_group : pairs)
      result.insert(result.end(), of_group.begin(), of_group.end());
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  typedef std::array<char, size_of_group> Flags;

  // the boxes of its triangles; those that are not there meet no box
  struct Group
  {
    std::array<std::array<float, size_of_group>, 3> low, high;
    Box box;

    Box box_of(const std::size_t k) const
    {
      return Box(Eigen::Vector3f(low[0][k], low[1][k], low[2][k]), Eigen::Vector3f(high[0][k], high[1][k], high[2][k]));
    }

    Flags meeting(const Box& other) const
    {
      Flags result;
      result.fill(1);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const float least = other.min()[Eigen::Index(axis)], most = other.max()[Eigen::Index(axis)];
        for (std::size_t k = 0; k < size_of_group; ++k) // without branches
          result[k] = char(int(result[k]) & int(low[axis][k] <= most) & int(high[axis][k] >= least));
      }
      return result;
    }
  };

  std::size_t end_of_group(const std::size_t g) const { return (std::min)((g + 1) * size_of_group, m_order.size()); }

  static Box_in_tree in_tree(const Box& b)
  {
    return Box_in_tree(Corner(b.min()[0], b.min()[1], b.min()[2]), Corner(b.max()[0], b.max()[1], b.max()[2]));
  }

  static Box box_of(const Indexed_triangle& t)
  {
    return rounded_box(t.points[0].cwiseMin(t.points[1]).cwiseMin(t.points[2]),
                       t.points[0].cwiseMax(t.points[1]).cwiseMax(t.points[2]));
  }

  template <typename Visit>
  void for_each_group(const Box& box, const Visit& visit) const
  {
    m_tree.query(boost::geometry::index::intersects(in_tree(box)),
                 boost::make_function_output_iterator([&](const Entry& entry) { visit(std::size_t(entry.second)); }));
  }

  // orders the triangles by size and, with about the same size, along a curve through space
  void sort()
  {
    Box all;
    for (const Indexed_triangle& t : m_triangles)
      all.extend(box_of(t));
    const float length = m_triangles.empty() ? 1 : all.sizes().maxCoeff();
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(m_triangles.size());
    parallel_for<ConcurrencyTag>(
        keys.size(),
        [&](const std::size_t i)
        {
          const Box box = box_of(m_triangles[i]);
          int exponent = 0;
          std::frexp(box.sizes().maxCoeff() / length, &exponent);
          const std::uint64_t size = std::uint64_t((std::min)(1 - exponent, 63) / 2);
          keys[i] = {size << 3 * bits | place_on_curve((box.center() - all.min()) / length), std::uint32_t(i)};
        });
    parallel_sort<ConcurrencyTag>(keys);
    m_order.resize(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
      m_order[i] = keys[i].second;
  }

  // the bits of the coordinates one after the other (Morton's curve)
  static std::uint64_t place_on_curve(const Eigen::Vector3f& p)
  {
    std::uint64_t result = 0;
    for (int k = 0; k < 3; ++k)
    {
      const std::uint64_t place = std::uint64_t((std::min)((std::max)(p[k], 0.f), 1.f) * float((1 << bits) - 1));
      for (int bit = 0; bit < bits; ++bit)
        result |= (place >> bit & 1) << (3 * bit + k);
    }
    return result;
  }

  void fill(const std::size_t g)
  {
    Group& group = m_groups[g];
    for (int axis = 0; axis < 3; ++axis)
    {
      group.low[std::size_t(axis)].fill(std::numeric_limits<float>::infinity());
      group.high[std::size_t(axis)].fill(-std::numeric_limits<float>::infinity());
    }
    for (std::size_t i = g * size_of_group; i < end_of_group(g); ++i)
    {
      const Box box = box_of(m_triangles[m_order[i]]);
      for (int axis = 0; axis < 3; ++axis)
      {
        group.low[std::size_t(axis)][i % size_of_group] = box.min()[axis];
        group.high[std::size_t(axis)][i % size_of_group] = box.max()[axis];
      }
      group.box.extend(box);
    }
  }

  // of triangles of this group, and of this and later ones
  void add_pairs(const std::size_t g, std::vector<Pair>& pairs) const
  {
    const Group& group = m_groups[g];
    const auto add = [&](const std::size_t a, const std::size_t b)
    {
      if (do_triangles_intersect(m_triangles[m_order[a]], m_triangles[m_order[b]]))
        pairs.emplace_back((std::minmax)(std::size_t(m_order[a]), std::size_t(m_order[b])));
    };
    for_each_group(group.box,
                   [&](const std::size_t other)
                   {
                     if (other < g)
                       return;
                     const Flags in_group = group.meeting(m_groups[other].box);
                     for (std::size_t i = 0; i < size_of_group; ++i)
                     {
                       if (!in_group[i])
                         continue;
                       const Flags in_other = m_groups[other].meeting(group.box_of(i));
                       for (std::size_t k = other == g ? i + 1 : 0; k < size_of_group; ++k)
                         if (in_other[k])
                           add(g * size_of_group + i, other * size_of_group + k);
                     }
                   });
  }

  const std::vector<Indexed_triangle>& m_triangles;
  std::vector<std::uint32_t> m_order; // the numbers of the triangles, group by group
  std::vector<Group> m_groups;
  Tree m_tree; // of the groups
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_TRIANGLE_GROUPS_H
