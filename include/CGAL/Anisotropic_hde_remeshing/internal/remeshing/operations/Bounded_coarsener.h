// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_COARSENER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_COARSENER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Measured_contractions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Sampled_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Sample_owners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/samples/Shape_price.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Contracts edges, the cheapest first, as long as no sample and no face gets further than a distance.
template <typename ConcurrencyTag, typename Mesh, typename Guard>
class Bounded_coarsener
{
  typedef Sample_owners<ConcurrencyTag, Mesh> Owners;

  static constexpr std::size_t size_of_batch = 512;
  static constexpr double smallest_share_of_batch = 0.02; // contractions within the distance; with fewer, the search ends

public:
  Bounded_coarsener(const Mesh& mesh, const Owners& owners, const Shape_price& price,
                    Sampled_operations<ConcurrencyTag, Mesh, Guard>& operations, Interruption& interruption)
    : m_mesh(mesh), m_owners(owners), m_price(price), m_operations(operations), m_interruption(interruption)
  {
  }

  // Contractions that are independent of each other. Returns how many.
  std::size_t operator()(const double largest_distance)
  {
    Measured_contractions<ConcurrencyTag, Mesh> measured(m_mesh, m_owners, m_price);
    const std::vector<Edge_index> edges = measured.candidates((std::numeric_limits<std::size_t>::max)());
    std::vector<Measured_contraction> contractions;
    for (std::size_t first = 0; first < edges.size() && !m_interruption.is_requested(); first += size_of_batch)
    {
      const std::size_t last = (std::min)(first + size_of_batch, edges.size());
      const std::vector<Measured_contraction> found = measured.measure(
          edges, first, last, (std::numeric_limits<double>::infinity)(), largest_distance * largest_distance, m_interruption);
      contractions.insert(contractions.end(), found.begin(), found.end());
      if (double(found.size()) < smallest_share_of_batch * double(last - first))
        break;
    }
    if (m_interruption.is_requested())
      return 0; // not all have been measured
    std::sort(contractions.begin(), contractions.end());
    m_operations.begin();
    contractions.erase(std::remove_if(contractions.begin(), contractions.end(),
                                      [&](const Measured_contraction& c) { return !m_operations.take_ring(c.halfedge); }),
                       contractions.end());
    std::size_t number = 0;
    for (const Measured_contraction& c : contractions)
    {
      if (m_interruption.poll())
        break;
      if (m_operations.accepts(c))
      {
        m_operations.contract(c);
        ++number;
      }
    }
    return number;
  }

private:
  const Mesh& m_mesh;
  const Owners& m_owners;
  const Shape_price& m_price;
  Sampled_operations<ConcurrencyTag, Mesh, Guard>& m_operations;
  Interruption& m_interruption;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_BOUNDED_COARSENER_H
