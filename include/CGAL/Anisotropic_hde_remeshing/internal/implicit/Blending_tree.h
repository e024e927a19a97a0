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

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A tree of planes. Each plane blends its two sides by a quintic smoothstep over a slab. The products of the weights along the
// paths to the leaves are an exact partition of unity of class C^2 on all of space: no point is uncovered, and nothing needs to
// be normalised. A leaf is a patch. It counts in its cell, inflated by the half-widths of the slabs that bound it. Its data are
// the points there, and those beyond as far as the overlap: these give its interpolant a neighbourhood. The planes are
// orthogonal to the longest principal axis of their points. So they are orthogonal to the surface where it is nearly flat.
// Slabs along the coordinate axes would cut the surface obliquely and hold many more points.
class Blending_tree
{
  struct Node
  {
    Vector normal = Vector::Zero(); // of the split plane
    double position = 0;
    double half_width = 0; // of the slab
    bool is_leaf = true;
    std::size_t left = 0; // index of the left child, the right one follows; for a leaf, its number
    std::size_t parent = 0;

    double distance(const Vector& p) const { return normal.dot(p) - position; }
  };

  // least difference of the eigenvalues of the covariance for two axes to differ in length; the sum of the eigenvalues is 1
  static constexpr double least_difference_of_axes = 1e-6;
  static constexpr double offset_overlap = 0.8; // in units of the local spacing
  // The largest share of the points of a cell that are in its slab. Where sampling is uneven, a slab as wide as a coarse region
  // asks for would swallow a dense region.
  static constexpr double largest_share_of_slab = 0.4;

public:
  struct Leaf
  {
    std::vector<std::size_t> points;     // those it interpolates, by increasing index
    std::vector<char> has_offset;        // of `points`: whether it interpolates their off-surface points, too
    std::vector<std::size_t> own_points; // those in its own cell; every point is in one
    std::size_t node = 0;
  };

  Blending_tree() = default;

  // `blending` and `overlap` are in units of the local spacing. Uneven sampling may inflate a leaf: one that is larger than
  // `maximum_leaf_size` is split further, as long as that makes it smaller. The cells of a level are split in parallel.
  template <typename ConcurrencyTag>
  Blending_tree(const ConcurrencyTag, const Surface_sample& sample, const std::size_t number_of_leaves, const double blending,
                const double overlap, const std::size_t maximum_leaf_size, Interruption& interruption)
    : m_blending(blending), m_overlap(overlap), m_maximum_leaf_size(maximum_leaf_size)
  {
    m_nodes.emplace_back();
    std::vector<Cell> level(1), next_level;
    level[0].number_of_leaves = number_of_leaves;
    level[0].data = all_points(sample);
    level[0].own = level[0].data.indices;
    while (!level.empty())
    {
      std::vector<Split_cell> split_cells(level.size());
      parallel_for<ConcurrencyTag>(
          level.size(), [&](const std::size_t i) { split_cells[i] = split(sample, level[i]); }, 1, interruption);
      interruption.check();
      next_level.clear();
      for (std::size_t i = 0; i < level.size(); ++i)
        if (split_cells[i].is_split)
          append_children(level[i].node, split_cells[i], next_level);
        else
          append_leaf(level[i]);
      level.swap(next_level);
    }
  }

  const std::vector<Leaf>& leaves() const { return m_leaves; }

  // adds a new point, the last one of the sample, to the leaves; calls visit(number) for each of them
  template <typename Visitor>
  void add_point(const Surface_sample& sample, const std::size_t i, const Visitor& visit)
  {
    add_point(sample, i, 0, true, true, visit);
  }

  // the points are needed for the solve only
  void release_points() { std::vector<Leaf>().swap(m_leaves); }

  // the points of a leaf with another overlap, to solve its patch once more with a wider view
  Leaf widened_leaf(const Surface_sample& sample, const std::size_t number, const double overlap) const
  {
    std::vector<std::size_t> path; // from the leaf to the root
    for (std::size_t node = m_leaves[number].node; node != 0; node = m_nodes[node].parent)
      path.push_back(node);
    Points data = all_points(sample);
    for (auto child = path.rbegin(); child != path.rend(); ++child)
    {
      const Node& parent = m_nodes[m_nodes[*child].parent];
      data = points_of_side(sample, parent, data, *child == parent.left ? 0 : 1, overlap);
    }
    trim(data);
    Leaf result = m_leaves[number];
    result.points = std::move(data.indices);
    result.has_offset = std::move(data.has_offset);
    return result;
  }

  // the blend at `p` of `leaf_jet(number of the leaf)`, which returns a Jet of any order
  template <typename Leaf_jet>
  auto blend(const Vector& p, const Leaf_jet& leaf_jet, std::size_t node_index = 0) const -> decltype(leaf_jet(std::size_t(0)))
  {
    constexpr int order = decltype(leaf_jet(std::size_t(0)))::order;
    while (!m_nodes[node_index].is_leaf)
    {
      const Node& node = m_nodes[node_index];
      const double distance = node.distance(p);
      if (std::abs(distance) < node.half_width)
      {
        const Jet<order> weight =
            smoothstep(plane_distance<order>(p, node.normal, node.position - node.half_width, 2 * node.half_width));
        return interpolated(blend(p, leaf_jet, node.left), blend(p, leaf_jet, node.left + 1), weight);
      }
      node_index = node.left + (distance > 0 ? 1 : 0);
    }
    return leaf_jet(m_nodes[node_index].left);
  }

  // the number of the leaf in whose cell `p` lies
  std::size_t leaf_at(const Vector& p) const
  {
    std::size_t node_index = 0;
    while (!m_nodes[node_index].is_leaf)
      node_index = m_nodes[node_index].left + (m_nodes[node_index].distance(p) > 0 ? 1 : 0);
    return m_nodes[node_index].left;
  }

  // calls visit(number) for the leaves that count at `p`
  template <typename Visitor>
  void visit_leaves(const Vector& p, const Visitor& visit, std::size_t node_index = 0) const
  {
    while (!m_nodes[node_index].is_leaf)
    {
      const Node& node = m_nodes[node_index];
      const double distance = node.distance(p);
      if (std::abs(distance) < node.half_width)
        visit_leaves(p, visit, node.left);
      node_index = node.left + (distance > -node.half_width ? 1 : 0);
    }
    visit(m_nodes[node_index].left);
  }

  // calls visit(normal, position, half-width) for the slab of every inner node
  template <typename Visitor>
  void visit_slabs(const Visitor& visit) const
  {
    for (const Node& node : m_nodes)
      if (!node.is_leaf)
        visit(node.normal, node.position, node.half_width);
  }

  std::size_t memory_bytes() const { return m_nodes.size() * sizeof(Node); }

private:
  struct Points
  {
    std::vector<std::size_t> indices;
    std::vector<char> has_offset;
    std::vector<double> beyond; // how far outside the zone of influence, in units of the local spacing; negative inside

    std::size_t size() const { return indices.size(); }
  };

  static Points all_points(const Surface_sample& sample)
  {
    Points all{std::vector<std::size_t>(sample.size()), std::vector<char>(sample.size(), 1),
               std::vector<double>(sample.size(), -1)};
    std::iota(all.indices.begin(), all.indices.end(), std::size_t(0));
    return all;
  }

  // a node that is not known yet to be a leaf
  struct Cell
  {
    std::size_t node = 0, number_of_leaves = 1;
    std::vector<std::size_t> own;
    Points data;
  };

  // the plane and the sides of a cell, if it is worth splitting
  struct Split_cell
  {
    bool is_split = false;
    Node node;
    std::array<Cell, 2> sides;
  };

  // takes the points out of the cell if it splits it
  Split_cell split(const Surface_sample& sample, Cell& cell) const
  {
    Split_cell result;
    const bool is_too_large = cell.data.size() > m_maximum_leaf_size;
    if ((cell.number_of_leaves <= 1 && !is_too_large) || cell.own.size() <= 1)
      return result;
    result.node = split_plane(sample, cell.own, cell.number_of_leaves);
    for (const std::size_t i : cell.own)
      result.sides[rounded(result.node.normal.dot(sample.points[i])) > result.node.position ? 1 : 0].own.push_back(i);
    for (int side = 0; side < 2; ++side)
      result.sides[side].data = points_of_side(sample, result.node, cell.data, side, m_overlap);
    const std::size_t larger = (std::max)(result.sides[0].data.size(), result.sides[1].data.size());
    result.is_split = !result.sides[0].own.empty() && !result.sides[1].own.empty() &&
                      (cell.number_of_leaves > 1 || 10 * larger < 9 * cell.data.size());
    if (!result.is_split)
      return Split_cell();
    result.sides[0].number_of_leaves = (cell.number_of_leaves + 1) / 2;
    result.sides[1].number_of_leaves = (std::max)(cell.number_of_leaves / 2, std::size_t(1));
    cell.own = std::vector<std::size_t>();
    cell.data = Points();
    return result;
  }

  void append_children(const std::size_t node, Split_cell& split_cell, std::vector<Cell>& cells)
  {
    split_cell.node.left = m_nodes.size();
    split_cell.node.parent = m_nodes[node].parent;
    m_nodes[node] = split_cell.node;
    m_nodes.resize(m_nodes.size() + 2);
    for (std::size_t side = 0; side < 2; ++side)
    {
      Cell& cell = split_cell.sides[side];
      cell.node = m_nodes[node].left + side;
      m_nodes[cell.node].parent = node;
      cells.push_back(std::move(cell));
    }
  }

  void append_leaf(Cell& cell)
  {
    m_nodes[cell.node].is_leaf = true;
    m_nodes[cell.node].left = m_leaves.size();
    trim(cell.data);
    m_leaves.push_back(Leaf{std::move(cell.data.indices), std::move(cell.data.has_offset), std::move(cell.own), cell.node});
  }

  // A leaf that is still too large keeps the points of its zone of influence, and the nearest points outside.
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

  // the plane across the longest principal axis of the points; it divides them in the ratio of the leaves to come
  Node split_plane(const Surface_sample& sample, const std::vector<std::size_t>& own, const std::size_t number_of_leaves) const
  {
    Node node;
    node.is_leaf = false;
    node.normal = longest_axis(sample, own);
    std::vector<std::pair<double, std::size_t>> coordinates;
    coordinates.reserve(own.size());
    for (const std::size_t i : own)
      coordinates.emplace_back(rounded(node.normal.dot(sample.points[i])), i);
    const std::size_t leaves = (std::max)(number_of_leaves, std::size_t(2));
    const std::size_t middle = (std::min)((std::max)(own.size() * ((leaves + 1) / 2) / leaves, std::size_t(1)), own.size() - 1);
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
    // On symmetric shapes two axes may be equally long, and rounding would decide which one is found. Then a coordinate axis is
    // taken.
    if (axes.eigenvalues()[2] - axes.eigenvalues()[1] > least_difference_of_axes)
    {
      const Vector axis = axes.eigenvectors().col(2);
      Eigen::Index largest;
      axis.cwiseAbs().maxCoeff(&largest);
      return axis[largest] < 0 ? Vector(-axis) : axis;
    }
    Eigen::Index longest = 0;
    for (Eigen::Index k = 1; k < 3; ++k)
      if (covariance(k, k) > covariance(longest, longest) + least_difference_of_axes * trace)
        longest = k;
    return Vector::Unit(longest);
  }

  // The last bits of a coordinate depend on the unit and the place of the input. Without these bits the points of a symmetric
  // shape are divided in the same way everywhere. Coordinates are below 1.
  static double rounded(const double coordinate) { return std::nearbyint(std::ldexp(coordinate, 30)) * std::ldexp(1., -30); }

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

  // The overlap is measured in the spacing of the point itself. So a dense region next to a coarse one adds few points.
  // Off-surface points are needed where the patch counts and a little beyond. Farther out they cost more than they help.
  static Points points_of_side(const Surface_sample& sample, const Node& node, const Points& from, const int side,
                               const double overlap)
  {
    Points to;
    for (std::size_t k = 0; k < from.size(); ++k)
    {
      const std::size_t i = from.indices[k];
      const double distance = node.distance(sample.points[i]);
      const double beyond = ((side == 0 ? distance : -distance) - node.half_width) / sample.reach(i);
      if (!(beyond <= overlap + 1e-9)) // points of a grid may be exactly there
        continue;
      to.indices.push_back(i);
      to.has_offset.push_back(from.has_offset[k] && beyond <= offset_overlap);
      to.beyond.push_back((std::max)(from.beyond[k], beyond));
    }
    return to;
  }

  template <typename Visitor>
  void add_point(const Surface_sample& sample, const std::size_t i, const std::size_t node_index, const bool has_offset,
                 const bool is_own, const Visitor& visit)
  {
    const Node& node = m_nodes[node_index];
    if (node.is_leaf)
    {
      Leaf& leaf = m_leaves[node.left];
      leaf.points.push_back(i);
      leaf.has_offset.push_back(has_offset);
      if (is_own)
        leaf.own_points.push_back(i);
      visit(node.left);
      return;
    }
    const double distance = node.distance(sample.points[i]);
    for (const int side : {0, 1})
    {
      const double beyond = ((side == 0 ? distance : -distance) - node.half_width) / sample.reach(i);
      if (beyond <= m_overlap + 1e-9)
        add_point(sample, i, node.left + std::size_t(side), has_offset && beyond <= offset_overlap,
                  is_own && (distance > 0) == (side == 1), visit);
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
