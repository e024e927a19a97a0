// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_TREE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_TREE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Grid_counts.h>

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

// A binary tree of boxes over the input, from counts in a grid alone. Its leaves are the cells: each has a function of its own, which
// is built from the input in and near it. Beside each plane is a slab, in which the functions of both sides are blended. A piece
// is the subtree of a node: the faces with their centroids in it are remeshed at once. So the cells of a piece are successive,
// and so are pieces that lie side by side.
class Cell_tree
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  // of the distance from the plane to the end of the smaller side, so that a slab does not reach through a cell
  static constexpr double largest_share_of_slab = 0.25;
  // Half of a slab in lengths of edges near the plane. Patches inside a function are blended over 0.6. The functions of two cells
  // differ less, so the width is a matter of smoothness only: second derivatives of their difference grow with its inverse square.
  static constexpr double half_width_in_lengths = 2;

  struct Node
  {
    double position = 0, half_width = 0;
    int axis = 0;
    bool is_leaf = true;
    std::size_t left = 0; // the right child follows it; of a leaf: the number of the cell

    double distance(const Vector& p) const { return p[axis] - position; }
  };

  typedef Grid_counts::Voxel Voxel;
  typedef std::vector<Voxel>::iterator Iterator;

public:
  Cell_tree() = default;

  // Cells have at most `faces_of_cell` faces, pieces at most `faces_of_piece`; more only where one voxel has more.
  Cell_tree(const Grid_counts& counts, const std::uint64_t faces_of_piece, const std::uint64_t faces_of_cell)
    : m_faces_of_piece(faces_of_piece), m_faces_of_cell((std::min)(faces_of_cell, faces_of_piece))
  {
    std::vector<Voxel> voxels = counts.voxels();
    m_nodes.emplace_back();
    split(counts, 0, voxels.begin(), voxels.end(), none);
  }

  std::size_t number_of_cells() const { return m_piece_of_cell.size(); }
  std::size_t number_of_pieces() const { return m_number_of_pieces; }
  std::size_t piece_of_cell(const std::size_t cell) const { return m_piece_of_cell[cell]; }

  // the cells of a piece: from the first number to before the second
  std::pair<std::size_t, std::size_t> cells_of_piece(const std::size_t piece) const
  {
    const auto range = std::equal_range(m_piece_of_cell.begin(), m_piece_of_cell.end(), piece);
    return {std::size_t(range.first - m_piece_of_cell.begin()), std::size_t(range.second - m_piece_of_cell.begin())};
  }

  std::size_t cell_at(const Vector& p) const
  {
    std::size_t i = 0;
    while (!m_nodes[i].is_leaf)
      i = m_nodes[i].left + (m_nodes[i].distance(p) > 0 ? 1 : 0);
    return m_nodes[i].left;
  }

  // calls visit(cell) for the cells whose functions count somewhere in the box, by increasing number
  template <typename Visitor>
  void visit_cells(const Space_box& box, const Visitor& visit, const std::size_t node_index = 0) const
  {
    const Node& node = m_nodes[node_index];
    if (node.is_leaf)
    {
      visit(node.left);
      return;
    }
    if (box.low[node.axis] - node.position < node.half_width)
      visit_cells(box, visit, node.left);
    if (box.high[node.axis] - node.position > -node.half_width)
      visit_cells(box, visit, node.left + 1);
  }

  // the blend at `p` of `cell_jet(cell)`, which returns a Jet of any order; as Blending_tree does it
  template <typename Cell_jet>
  auto blend(const Vector& p, const Cell_jet& cell_jet, std::size_t node_index = 0) const -> decltype(cell_jet(std::size_t(0)))
  {
    constexpr int order = decltype(cell_jet(std::size_t(0)))::order;
    while (!m_nodes[node_index].is_leaf)
    {
      const Node& node = m_nodes[node_index];
      const double distance = node.distance(p);
      if (std::abs(distance) < node.half_width)
      {
        const Jet<order> weight =
            smoothstep(plane_distance<order>(p, Vector::Unit(node.axis), node.position - node.half_width, 2 * node.half_width));
        return interpolated(blend(p, cell_jet, node.left), blend(p, cell_jet, node.left + 1), weight);
      }
      node_index = node.left + (distance > 0 ? 1 : 0);
    }
    return cell_jet(m_nodes[node_index].left);
  }

  // calls visit(axis, position, half-width) for the slab of every plane
  template <typename Visitor>
  void visit_slabs(const Visitor& visit) const
  {
    for (const Node& node : m_nodes)
      if (!node.is_leaf)
        visit(node.axis, node.position, node.half_width);
  }

private:
  void split(const Grid_counts& counts, const std::size_t node_index, const Iterator begin, const Iterator end,
             std::size_t piece)
  {
    std::uint64_t number_of_faces = 0;
    for (Iterator i = begin; i != end; ++i)
      number_of_faces += i->number_of_faces;
    Node node;
    Iterator middle = end;
    if (number_of_faces > m_faces_of_cell)
      middle = find_plane(counts, begin, end, number_of_faces, node);
    const bool is_leaf = middle == end;
    if (piece == none && (number_of_faces <= m_faces_of_piece || is_leaf))
      piece = m_number_of_pieces++;
    node.is_leaf = is_leaf;
    node.left = is_leaf ? m_piece_of_cell.size() : m_nodes.size();
    m_nodes[node_index] = node;
    if (is_leaf)
    {
      m_piece_of_cell.push_back(piece);
      return;
    }
    m_nodes.resize(m_nodes.size() + 2);
    split(counts, node.left, begin, middle, piece);
    split(counts, node.left + 1, middle, end, piece);
  }

  // Finds the plane between voxels that halves the faces best, across the longest side where it can be. Returns where the right side
  // begins, or the end if all faces are in one voxel.
  Iterator find_plane(const Grid_counts& counts, const Iterator begin, const Iterator end, const std::uint64_t number_of_faces,
                      Node& node) const
  {
    std::array<std::int32_t, 3> low = begin->index, high = begin->index;
    for (Iterator i = begin; i != end; ++i)
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = (std::min)(low[axis], i->index[axis]);
        high[axis] = (std::max)(high[axis], i->index[axis]);
      }
    int axis = 0;
    for (int other = 1; other < 3; ++other)
      if (high[other] - low[other] > high[axis] - low[axis])
        axis = other;
    if (high[axis] == low[axis])
      return end;
    std::vector<std::uint64_t> histogram(std::size_t(high[axis] - low[axis]) + 1, 0);
    for (Iterator i = begin; i != end; ++i)
      histogram[std::size_t(i->index[axis] - low[axis])] += i->number_of_faces;
    std::uint64_t below = histogram[0], best = below;
    std::size_t plane = 1;
    for (std::size_t k = 2; k < histogram.size(); ++k)
    {
      below += histogram[k - 1];
      if ((std::max)(below, number_of_faces - below) < (std::max)(best, number_of_faces - best))
      {
        best = below;
        plane = k;
      }
    }
    const std::int32_t first_of_right = low[axis] + std::int32_t(plane);
    node.axis = axis;
    node.position = counts.coordinate(axis, first_of_right);
    const double smaller = double((std::min)(first_of_right - low[axis], high[axis] + 1 - first_of_right)) * counts.side();
    node.half_width = (std::min)(half_width_in_lengths * length_near_plane(begin, end, axis, first_of_right),
                                 largest_share_of_slab * smaller);
    return std::stable_partition(begin, end, [&](const Voxel& voxel) { return voxel.index[axis] < first_of_right; });
  }

  // the mean length of the edges in the two nearest layers of voxels that have faces
  static double length_near_plane(const Iterator begin, const Iterator end, const int axis, const std::int32_t first_of_right)
  {
    std::int32_t left = (std::numeric_limits<std::int32_t>::min)(), right = (std::numeric_limits<std::int32_t>::max)();
    for (Iterator i = begin; i != end; ++i)
      if (i->index[axis] < first_of_right)
        left = (std::max)(left, i->index[axis]);
      else
        right = (std::min)(right, i->index[axis]);
    double sum = 0, number = 0;
    for (Iterator i = begin; i != end; ++i)
      if (i->index[axis] == left || i->index[axis] == right)
      {
        sum += i->sum_of_lengths;
        number += double(i->number_of_faces);
      }
    return sum / number;
  }

  std::uint64_t m_faces_of_piece = 0, m_faces_of_cell = 0;
  std::vector<Node> m_nodes;
  std::vector<std::size_t> m_piece_of_cell;
  std::size_t m_number_of_pieces = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_TREE_H
