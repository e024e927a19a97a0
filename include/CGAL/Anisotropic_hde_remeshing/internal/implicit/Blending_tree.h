// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_BLENDING_TREE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_BLENDING_TREE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A tree of planes that blend their two sides by a quintic smoothstep over a slab. The products of the weights along the
// paths to the leaves are an exact partition of unity of class C^2 on all of space: no point is uncovered, and nothing needs
// to be normalised. A leaf is a patch; its data are the points of its cell, inflated by the half-widths of the slabs that
// bound it, where it counts, and beyond by the overlap, which gives its interpolant a neighbourhood. The planes are
// orthogonal to the longest principal axis of their points, hence to the surface where it is nearly flat: slabs along the
// coordinate axes would cut it obliquely and hold many more points.
class Blending_tree
{
  struct Node
  {
    Vector normal = Vector::Zero(); // of the split plane
    double position = 0;
    double half_width = 0; // of the slab
    bool is_leaf = true;
    std::size_t left = 0; // index of the left child, the right one follows; of a leaf, its number

    double distance(const Vector& p) const { return normal.dot(p) - position; }
  };

  static constexpr double offset_overlap = 1; // in units of the local spacing
  // of the points of a cell: where sampling is uneven, a slab as wide as a coarse region asks would swallow a dense one
  static constexpr double largest_share_of_slab = 0.4;

public:
  struct Leaf
  {
    std::vector<std::size_t> points;     // those it interpolates, by increasing index
    std::vector<char> has_offset;        // of `points`: whether it interpolates their off-surface points, too
    std::vector<std::size_t> own_points; // those in its own cell; every point is in one
  };

  Blending_tree() = default;

  // `blending` and `overlap` are in units of the local spacing; `maximum_leaf_size` splits further where uneven sampling
  // inflates a leaf, as long as that makes it smaller.
  Blending_tree(const Surface_sample& sample, const std::size_t number_of_leaves, const double blending,
                const double overlap, const std::size_t maximum_leaf_size)
    : m_blending(blending), m_overlap(overlap), m_maximum_leaf_size(maximum_leaf_size)
  {
    Points all{std::vector<std::size_t>(sample.size()), std::vector<char>(sample.size(), 1),
               std::vector<double>(sample.size(), -1)};
    std::iota(all.indices.begin(), all.indices.end(), std::size_t(0));
    std::vector<std::size_t> own = all.indices;
    m_nodes.emplace_back();
    subdivide(sample, 0, own, all, number_of_leaves);
  }

  const std::vector<Leaf>& leaves() const { return m_leaves; }

  // the points are needed for the solve only
  void release_points()
  {
    std::vector<Leaf>().swap(m_leaves);
  }

  // the blend at `p` of `leaf_value(number of the leaf)`, which returns Value_and_gradient
  template <typename Leaf_value>
  Value_and_gradient blend(const Vector& p, const Leaf_value& leaf_value, std::size_t node_index = 0) const
  {
    while (!m_nodes[node_index].is_leaf)
    {
      const Node& node = m_nodes[node_index];
      const double distance = node.distance(p);
      if (std::abs(distance) < node.half_width)
        return blend_sides(blend(p, leaf_value, node.left), blend(p, leaf_value, node.left + 1), node, distance);
      node_index = node.left + (distance > 0 ? 1 : 0);
    }
    return leaf_value(m_nodes[node_index].left);
  }

private:
  static Value_and_gradient blend_sides(const Value_and_gradient& left, const Value_and_gradient& right,
                                        const Node& node, const double distance)
  {
    const double t = 0.5 + 0.5 * distance / node.half_width;
    const double weight = t * t * t * (10 + t * (6 * t - 15));
    const double slope = 30 * t * t * (1 - t) * (1 - t) * 0.5 / node.half_width;
    Value_and_gradient result;
    result.value = left.value + weight * (right.value - left.value);
    result.gradient = left.gradient + weight * (right.gradient - left.gradient);
    result.gradient += slope * (right.value - left.value) * node.normal;
    return result;
  }

  struct Points
  {
    std::vector<std::size_t> indices;
    std::vector<char> has_offset;
    std::vector<double> beyond; // how far outside the zone of influence, in units of the local spacing; negative inside

    std::size_t size() const { return indices.size(); }
  };

  void subdivide(const Surface_sample& sample, const std::size_t node_index, std::vector<std::size_t>& own, Points& data, const std::size_t number_of_leaves)
  {
    const bool is_too_large = data.size() > m_maximum_leaf_size && own.size() > 1;
    if ((number_of_leaves > 1 && own.size() > 1) || is_too_large)
    {
      const Node node = split(sample, own, number_of_leaves);
      std::vector<std::size_t> own_of[2];
      Points data_of[2];
      distribute_own_points(sample, node, own, own_of);
      distribute_data(sample, node, data, data_of);
      const bool is_worth_it = !own_of[0].empty() && !own_of[1].empty() &&
                               (number_of_leaves > 1 ||
                                10 * (std::max)(data_of[0].size(), data_of[1].size()) < 9 * data.size());
      if (is_worth_it)
      {
        std::vector<std::size_t>().swap(own);
        data = Points();
        const std::size_t left = m_nodes.size();
        m_nodes[node_index] = node;
        m_nodes[node_index].left = left;
        m_nodes.resize(left + 2);
        subdivide(sample, left, own_of[0], data_of[0], (number_of_leaves + 1) / 2);
        subdivide(sample, left + 1, own_of[1], data_of[1], (std::max)(number_of_leaves / 2, std::size_t(1)));
        return;
      }
    }
    m_nodes[node_index].is_leaf = true;
    m_nodes[node_index].left = m_leaves.size();
    trim(data);
    m_leaves.push_back(Leaf{std::move(data.indices), std::move(data.has_offset), std::move(own)});
  }

  // A leaf that is too large after all keeps the points of its zone of influence and those nearest to it.
  void trim(Points& data) const
  {
    if (data.size() <= m_maximum_leaf_size)
      return;
    std::vector<double> sorted = data.beyond;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(m_maximum_leaf_size), sorted.end());
    const double farthest = (std::max)(sorted[m_maximum_leaf_size], 0.);
    std::size_t next = 0;
    for (std::size_t k = 0; k < data.size(); ++k)
      if (data.beyond[k] <= farthest)
      {
        data.indices[next] = data.indices[k];
        data.has_offset[next++] = data.has_offset[k];
      }
    data.indices.resize(next);
    data.has_offset.resize(next);
  }

  // the plane across the longest principal axis of the points that divides them in the ratio of the leaves to come
  Node split(const Surface_sample& sample, const std::vector<std::size_t>& own, const std::size_t number_of_leaves) const
  {
    Node node;
    node.is_leaf = false;
    node.normal = longest_axis(sample, own);
    std::vector<std::pair<double, std::size_t>> coordinates;
    coordinates.reserve(own.size());
    for (const std::size_t i : own)
      coordinates.emplace_back(node.normal.dot(sample.points[i]), i);
    const std::size_t leaves = (std::max)(number_of_leaves, std::size_t(2));
    const std::size_t middle =
        (std::min)((std::max)(own.size() * ((leaves + 1) / 2) / leaves, std::size_t(1)), own.size() - 1);
    std::nth_element(coordinates.begin(), coordinates.begin() + middle, coordinates.end());
    const auto last_of_left = *std::max_element(coordinates.begin(), coordinates.begin() + middle);
    node.position = 0.5 * (last_of_left.first + coordinates[middle].first);
    const double spacing = spacing_near_plane(sample, own, node, {last_of_left.second, coordinates[middle].second});
    node.half_width = (std::min)(m_blending * spacing, widest_slab(coordinates, node.position));
    return node;
  }

  static Vector longest_axis(const Surface_sample& sample, const std::vector<std::size_t>& own)
  {
    Vector mean = Vector::Zero();
    for (const std::size_t i : own)
      mean += sample.points[i] / double(own.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const std::size_t i : own)
      covariance += (sample.points[i] - mean) * (sample.points[i] - mean).transpose();
    const double trace = covariance.trace();
    if (!(trace > 0))
      return Vector::UnitX();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance / trace);
    return axes.eigenvectors().col(2);
  }

  // the half-width of the slab that holds `largest_share_of_slab` of the points
  static double widest_slab(std::vector<std::pair<double, std::size_t>>& coordinates, const double position)
  {
    for (auto& coordinate : coordinates)
      coordinate.first = std::abs(coordinate.first - position);
    const auto quantile = coordinates.begin() + std::ptrdiff_t(largest_share_of_slab * double(coordinates.size()));
    std::nth_element(coordinates.begin(), quantile, coordinates.end());
    return quantile->first;
  }

  // the median of the spacings of the points near the plane
  static double spacing_near_plane(const Surface_sample& sample, const std::vector<std::size_t>& own, const Node& node,
                                   const std::pair<std::size_t, std::size_t>& nearest)
  {
    std::vector<double> spacings{sample.spacings[nearest.first], sample.spacings[nearest.second]};
    for (const std::size_t i : own)
      if (std::abs(node.distance(sample.points[i])) < 2 * sample.spacings[i])
        spacings.push_back(sample.spacings[i]);
    const auto median = spacings.begin() + spacings.size() / 2;
    std::nth_element(spacings.begin(), median, spacings.end());
    return *median;
  }

  static void distribute_own_points(const Surface_sample& sample, const Node& node, const std::vector<std::size_t>& from,
                                    std::vector<std::size_t> (&to)[2])
  {
    for (const std::size_t i : from)
      to[node.distance(sample.points[i]) > 0 ? 1 : 0].push_back(i);
  }

  // The overlap is measured in the spacing of the point itself: next to a coarse region a dense one adds few points. Off-
  // surface points are needed where the patch counts and a little beyond: farther out they cost more than they help.
  void distribute_data(const Surface_sample& sample, const Node& node, const Points& from, Points (&to)[2]) const
  {
    for (std::size_t k = 0; k < from.size(); ++k)
    {
      const std::size_t i = from.indices[k];
      const double distance = node.distance(sample.points[i]);
      for (int side = 0; side < 2; ++side)
      {
        const double beyond = (side == 0 ? distance : -distance) - node.half_width;
        if (beyond > m_overlap * sample.spacings[i])
          continue;
        to[side].indices.push_back(i);
        to[side].has_offset.push_back(from.has_offset[k] && beyond <= offset_overlap * sample.spacings[i]);
        to[side].beyond.push_back((std::max)(from.beyond[k], beyond / sample.spacings[i]));
      }
    }
  }

  double m_blending = 1, m_overlap = 0;
  std::size_t m_maximum_leaf_size = 0;
  std::vector<Node> m_nodes;
  std::vector<Leaf> m_leaves;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_BLENDING_TREE_H
