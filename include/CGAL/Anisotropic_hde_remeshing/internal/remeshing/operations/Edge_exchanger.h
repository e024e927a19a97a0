// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_EXCHANGER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_EXCHANGER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Measured_contractions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Measured_splits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Sampled_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Exchanges vertices: a contraction where the least is lost for a split where the most is gained, as long as that pays. So
// vertices move to where they are needed, and their number stays.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Edge_exchanger
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;

  static constexpr double contractions_measured = 3, splits_measured = 4; // over those wanted
  static constexpr std::size_t size_of_batch = 256;
  static constexpr double smallest_share_of_batch = 0.05; // contractions that pay; with fewer, the search ends

public:
  Edge_exchanger(const Mesh& mesh, const Input_surface& input, const Owners& owners, const Shape_price& price,
                 Sampled_operations<ConcurrencyTag, Mesh, Guard>& operations, Interruption& interruption)
    : m_mesh(mesh), m_input(input), m_owners(owners), m_price(price), m_operations(operations), m_interruption(interruption)
  {
  }

  // exchanges at most `largest_number` vertices; returns how many
  std::size_t operator()(const std::size_t largest_number)
  {
    const std::vector<Measured_split> splits = measured_splits(largest_number);
    const std::vector<Measured_contraction> contractions = paying_contractions(largest_number, splits);
    if (m_interruption.is_requested())
      return 0; // not all have been measured
    // every split has its contraction, and no two of all have a vertex in common
    m_operations.begin();
    std::vector<std::pair<Measured_contraction, Measured_split>> pairs;
    std::size_t next = 0;
    for (const Measured_contraction& c : contractions)
    {
      if (pairs.size() == largest_number)
        break;
      if (!m_operations.take_ring(c.halfedge))
        continue;
      while (next < splits.size() && splits[next].gain >= c.cost && !m_operations.take_quad(splits[next].edge))
        ++next;
      if (next == splits.size() || splits[next].gain < c.cost)
        break;
      pairs.emplace_back(c, splits[next]);
      ++next;
    }
    std::size_t number = 0;
    for (const auto& pair : pairs)
    {
      if (m_interruption.poll())
        break;
      const Halfedge_index h = m_mesh.halfedge(pair.second.edge);
      const Vector& point = pair.second.point;
      if (m_operations.accepts(pair.first) && m_operations.accepts_split(h, point))
      {
        m_operations.contract(pair.first);
        m_operations.split(h, point);
        ++number;
      }
    }
    return number;
  }

private:
  std::vector<Measured_split> measured_splits(const std::size_t largest_number)
  {
    const Measured_splits<ConcurrencyTag, Mesh> measured(m_mesh, m_input, m_owners, m_price);
    return measured.measure(measured.candidates(std::size_t(splits_measured * double(largest_number))), m_interruption);
  }

  // Measures contractions in batches, the most promising first, as long as they find a split that is worth more.
  std::vector<Measured_contraction> paying_contractions(const std::size_t largest_number,
                                                        const std::vector<Measured_split>& splits)
  {
    std::vector<Measured_contraction> result;
    if (splits.empty())
      return result;
    Measured_contractions<ConcurrencyTag, Mesh> measured(m_mesh, m_owners, m_price);
    const std::vector<Edge_index> edges = measured.candidates(std::size_t(contractions_measured * double(largest_number)));
    double limit = splits.front().gain;
    for (std::size_t first = 0; first < edges.size() && !m_interruption.is_requested(); first += size_of_batch)
    {
      const std::size_t last = (std::min)(first + size_of_batch, edges.size());
      const std::vector<Measured_contraction> found =
          measured.measure(edges, first, last, limit, (std::numeric_limits<double>::infinity)(), m_interruption);
      if (double(found.size()) < smallest_share_of_batch * double(last - first))
        break;
      result.insert(result.end(), found.begin(), found.end());
      std::sort(result.begin(), result.end());
      limit = largest_cost_that_pays(result, splits);
    }
    return result;
  }

  // Half as many splits as pay now will find a partner at least: so no contraction can cost more than the next one gains.
  static double largest_cost_that_pays(const std::vector<Measured_contraction>& contractions,
                                       const std::vector<Measured_split>& splits)
  {
    std::size_t number = 0;
    while (number < contractions.size() && number < splits.size() && splits[number].gain >= contractions[number].cost)
      ++number;
    return splits[(std::min)(number / 2, splits.size() - 1)].gain;
  }

  const Mesh& m_mesh;
  const Input_surface& m_input;
  const Owners& m_owners;
  const Shape_price& m_price;
  Sampled_operations<ConcurrencyTag, Mesh, Guard>& m_operations;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_EDGE_EXCHANGER_H
