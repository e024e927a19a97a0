// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_SORTED_EDGES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_SORTED_EDGES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// a key and an edge; edges are sorted by the key first, then by the index
typedef std::pair<double, Edge_index> Keyed_edge;

// the key of an edge that is left out
constexpr double no_key = std::numeric_limits<double>::infinity();

// The edges that may be touched and whose `key(edge)` is not `no_key`, sorted by it. `key` is called concurrently.
template <typename ConcurrencyTag, typename Mesh, typename Key>
std::vector<Keyed_edge> sorted_edges(const Mesh& mesh, const Key& key, Interruption& interruption)
{
  std::vector<double> keys(edge_capacity(mesh), no_key);
  parallel_for<ConcurrencyTag>(
      keys.size(),
      [&](const std::size_t i)
      {
        const Edge_index e(static_cast<Edge_index::size_type>(i));
        if (!mesh.is_removed(e) && mesh.arc(mesh.halfedge(e)).curve != Curve_arc::untouchable)
          keys[i] = key(e);
      },
      256, interruption);
  std::vector<Keyed_edge> result;
  if (interruption.is_requested())
    return result; // not all have keys
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i] != no_key)
      result.emplace_back(keys[i], Edge_index(static_cast<Edge_index::size_type>(i)));
  parallel_sort<ConcurrencyTag>(result);
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_SORTED_EDGES_H
