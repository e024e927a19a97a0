// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_KERNEL_SUM_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_KERNEL_SUM_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

// Inlines all calls of a function, down to the last. In programs with many kernels GCC would otherwise leave operators of
// Eigen's arrays as calls. That makes the inner loop four times slower.
#if defined(__GNUC__)
#  define CGAL_AHR_FLATTEN __attribute__((flatten))
#else
#  define CGAL_AHR_FLATTEN
#endif

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

template <typename RadialFunction, typename = void>
struct Has_compact_support : std::false_type
{
};
template <typename RadialFunction>
struct Has_compact_support<RadialFunction, std::void_t<decltype(std::declval<const RadialFunction&>().support_radius())>>
  : std::true_type
{
};

template <typename RadialFunction, typename = void>
struct Has_second_derivative : std::false_type
{
};
template <typename RadialFunction>
struct Has_second_derivative<RadialFunction, std::void_t<decltype(std::declval<const RadialFunction&>()(1.).second)>>
  : std::true_type
{
};

// Boxes about ranges of a sequence of blocks of centres, in preorder. They serve to skip the blocks beyond the support of a
// kernel.
class Block_tree
{
  struct Node
  {
    Eigen::Array3d low, high;
    std::size_t block = 0; // of a leaf
    std::size_t skip = 0;  // the node after the subtree; for a leaf, the next node
    bool is_leaf = true;
  };

public:
  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;

  Block_tree() = default;

  // sorts the indices of the centres so that each `lanes` of them are close together
  Block_tree(const Points& centres, std::vector<Eigen::Index>& order, const std::size_t lanes) : m_lanes(lanes)
  {
    subdivide(centres, order, 0, order.size());
  }

  template <typename Visitor>
  void visit_blocks(const Vector& p, const double squared_radius, const Visitor& visit) const
  {
    for (std::size_t i = 0; i < m_nodes.size();)
    {
      const Node& node = m_nodes[i];
      const Eigen::Array3d outside = (node.low - p.array()).max(p.array() - node.high).max(0.);
      if (outside.matrix().squaredNorm() >= squared_radius)
      {
        i = node.skip;
        continue;
      }
      if (node.is_leaf)
        visit(Eigen::Index(node.block));
      ++i;
    }
  }

  std::size_t memory_bytes() const { return m_nodes.size() * sizeof(Node); }

private:
  void subdivide(const Points& centres, std::vector<Eigen::Index>& order, const std::size_t begin, const std::size_t end)
  {
    const std::size_t this_node = m_nodes.size();
    m_nodes.emplace_back();
    Eigen::Array3d low = centres.col(order[begin]), high = low;
    for (std::size_t k = begin; k < end; ++k)
    {
      low = low.min(centres.col(order[k]).array());
      high = high.max(centres.col(order[k]).array());
    }
    m_nodes[this_node].low = low;
    m_nodes[this_node].high = high;
    m_nodes[this_node].block = begin / m_lanes;
    if (end - begin > m_lanes)
    {
      m_nodes[this_node].is_leaf = false;
      Eigen::Index axis;
      (high - low).maxCoeff(&axis);
      const std::size_t blocks = (end - begin + m_lanes - 1) / m_lanes, middle = begin + blocks / 2 * m_lanes;
      std::nth_element(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(middle),
                       order.begin() + std::ptrdiff_t(end),
                       [&](const Eigen::Index i, const Eigen::Index j)
                       { return std::make_pair(centres(axis, i), i) < std::make_pair(centres(axis, j), j); });
      subdivide(centres, order, begin, middle);
      subdivide(centres, order, middle, end);
    }
    m_nodes[this_node].skip = m_nodes.size();
  }

  std::size_t m_lanes = 1;
  std::vector<Node> m_nodes;
};

// sum_j alpha_j phi(|y - y_j|) with its derivatives, several centres at a time: the inner loop of the package
template <typename RadialFunction>
class Kernel_sum
{
  // the number of centres that one step of the loop takes: two registers of AVX, four of SSE2
  static constexpr Eigen::Index lanes = 8;
  typedef Eigen::Array<double, lanes, 1> Lanes;

  // blocks of x, y, z, weight, `lanes` numbers each
  typedef Eigen::Array<double, lanes, Eigen::Dynamic> Blocks;

  static constexpr bool has_support = Has_compact_support<RadialFunction>::value;

  template <int order>
  struct Sums
  {
    Lanes value = Lanes::Zero(), squared_distance = Lanes::Constant((std::numeric_limits<double>::max)());
    Lanes gradient[order >= 1 ? 3 : 1];
    Lanes hessian[order >= 2 ? 6 : 1];

    Sums()
    {
      for (Lanes& sum : gradient)
        sum.setZero();
      for (Lanes& sum : hessian)
        sum.setZero();
    }
  };

public:
  typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;

  Kernel_sum() = default;

  Kernel_sum(const Points& centres, const Eigen::VectorXd& weights, const RadialFunction& function) : m_function(function)
  {
    std::vector<Eigen::Index> order(std::size_t(centres.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    if constexpr (has_support)
      m_tree = Block_tree(centres, order, std::size_t(lanes));
    const Eigen::Index number_of_blocks = (centres.cols() + lanes - 1) / lanes;
    m_blocks = Blocks::Zero(lanes, 4 * number_of_blocks);
    for (Eigen::Index i = 0; i < lanes * number_of_blocks; ++i)
    {
      // padding: the last centre again, with weight 0
      const Eigen::Index column = 4 * (i / lanes), lane = i % lanes,
                         centre = order[std::size_t((std::min)(i, centres.cols() - 1))];
      for (Eigen::Index k = 0; k < 3; ++k)
        m_blocks(lane, column + k) = centres(k, centre);
      m_blocks(lane, column + 3) = i < centres.cols() ? weights[centre] : 0.;
    }
  }

  const RadialFunction& function() const { return m_function; }

  // `squared_distance` becomes that to the nearest centre, if this is within the support
  template <int order>
  CGAL_AHR_FLATTEN Jet<order> evaluate(const Vector& y, double& squared_distance) const
  {
    static_assert(order < 2 || Has_second_derivative<RadialFunction>::value,
                  "second derivatives of the function need a radial function that returns them, as Rbf_jet<T, 2>");
    Sums<order> sums;
    if constexpr (has_support)
    {
      const double support = m_function.support_radius();
      m_tree.visit_blocks(y, support * support,
                          [&](const Eigen::Index block) { add_block<true>(m_function, 4 * block, y, sums); });
    }
    else
      for (Eigen::Index column = 0; column < m_blocks.cols(); column += 4)
        add_block<true>(m_function, column, y, sums);
    squared_distance = sums.squared_distance.minCoeff();
    return total(sums);
  }

  // the sum of another function over the same centres, padding included, with weights 1
  template <int order, typename Other_function>
  CGAL_AHR_FLATTEN Jet<order> evaluate_unweighted(const Vector& y, const Other_function& other) const
  {
    Sums<order> sums;
    for (Eigen::Index column = 0; column < m_blocks.cols(); column += 4)
      add_block<false>(other, column, y, sums);
    return total(sums);
  }

  std::size_t memory_bytes() const { return sizeof(double) * std::size_t(m_blocks.size()) + m_tree.memory_bytes(); }

private:
  template <bool is_weighted, typename Function, int order>
  void add_block(const Function& function, const Eigen::Index column, const Vector& y, Sums<order>& sums) const
  {
    const Lanes difference[3] = {y[0] - m_blocks.col(column), y[1] - m_blocks.col(column + 1), y[2] - m_blocks.col(column + 2)};
    const Lanes squared_radius = difference[0] * difference[0] + difference[1] * difference[1] + difference[2] * difference[2];
    sums.squared_distance = sums.squared_distance.min(squared_radius);
    const auto phi = function(squared_radius); // all is inlined: what the order does not need is not computed
    const auto weighted = [&](const Lanes& x) -> Lanes
    {
      if constexpr (is_weighted)
        return m_blocks.col(column + 3) * x;
      else
        return x;
    };
    sums.value += weighted(phi.value);
    if constexpr (order >= 1)
    {
      const Lanes first = weighted(phi.first);
      for (int i = 0; i < 3; ++i)
        sums.gradient[i] += first * difference[i];
      if constexpr (order >= 2 && Has_second_derivative<Function>::value)
      {
        const Lanes second = weighted(phi.second);
        for (int i = 0, k = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++k)
          {
            sums.hessian[k] += second * difference[i] * difference[j];
            if (i == j)
              sums.hessian[k] += first;
          }
      }
    }
  }

  template <int order>
  static Jet<order> total(const Sums<order>& sums)
  {
    Jet<order> result;
    result.value = sums.value.sum();
    if constexpr (order >= 1)
      result.gradient = Vector(sums.gradient[0].sum(), sums.gradient[1].sum(), sums.gradient[2].sum());
    if constexpr (order >= 2)
      for (int i = 0, k = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++k)
          result.hessian(i, j) = result.hessian(j, i) = sums.hessian[k].sum();
    return result;
  }

  Blocks m_blocks;
  Block_tree m_tree; // empty unless the function has compact support
  RadialFunction m_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_KERNEL_SUM_H
