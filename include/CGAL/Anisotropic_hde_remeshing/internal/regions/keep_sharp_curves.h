// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_KEEP_SHARP_CURVES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_KEEP_SHARP_CURVES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Face_directions.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Of the marked edges of a mesh, which are no boundary edges, keeps those of sharp curves marked. A curve goes from one end or
// branching to the next, or is closed. It is sharp if edges of at least `angle` degrees make up more than half of its length: a
// crease that fades out is a curve in whole, and a line drawn on a noisy surface is none. Returns whether any is left.
template <typename TriangleMesh, typename VertexPointMap, typename EdgeIsMarkedMap>
bool keep_sharp_curves(const TriangleMesh& tmesh, const VertexPointMap vpm, const double angle, const EdgeIsMarkedMap is_marked)
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor Edge;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)(), branching = none - 1;
  std::vector<Edge> marked;
  for (const Edge e : edges(tmesh))
    if (get(is_marked, e))
      marked.push_back(e);
  if (marked.empty())
    return false;

  // by vertex: the first marked edge, then whether there are more than two
  Disjoint_sets curves(marked.size());
  const auto first_edge = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  const auto second_edge = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  for (const auto v : vertices(tmesh))
  {
    put(first_edge, v, none);
    put(second_edge, v, none);
  }
  for (std::size_t i = 0; i < marked.size(); ++i)
    for (const auto v : {source(marked[i], tmesh), target(marked[i], tmesh)})
      if (get(first_edge, v) == none)
        put(first_edge, v, i);
      else
        put(second_edge, v, get(second_edge, v) == none ? i : branching);
  for (const auto v : vertices(tmesh))
    if (get(second_edge, v) < branching)
      curves.union_set(get(first_edge, v), get(second_edge, v));

  const Face_directions<TriangleMesh, VertexPointMap> directions(tmesh, vpm);
  std::vector<double> excess(marked.size(), 0.); // of the length of sharp edges over that of the others, by curve
  for (std::size_t i = 0; i < marked.size(); ++i)
    excess[curves.find_set(i)] += (directions.angle(marked[i]) >= angle ? 1 : -1) * directions.length(marked[i]);
  bool is_any_left = false;
  for (std::size_t i = 0; i < marked.size(); ++i)
  {
    const bool is_sharp = excess[curves.find_set(i)] > 0;
    put(is_marked, marked[i], is_sharp);
    is_any_left = is_any_left || is_sharp;
  }
  return is_any_left;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_KEEP_SHARP_CURVES_H
