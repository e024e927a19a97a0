// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_PRUNE_CREASES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_PRUNE_CREASES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Face_directions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Takes back the creases that are only noise: those about specks, and short darts. A dart is a crease with the same region on
// both sides. Measured: at 60 degrees noise of scans has regions of at most 5 faces and 2% of the mesh in size, and darts of at
// most 7% of it. Regions of machine parts that have as few faces are larger. Most of their darts are longer.
template <typename TriangleMesh, typename VertexPointMap>
class Crease_pruning
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename Graph_traits::face_descriptor Face;
  typedef typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<std::size_t>>::const_type Vertex_number_map;
  typedef Face_directions<TriangleMesh, VertexPointMap> Directions;

  // A speck has at most so many faces, and its box is smaller than this share of the size of its component.
  static constexpr std::size_t most_faces_of_speck = 8;
  static constexpr double size_of_speck = 0.03;
  // the least length of a dart that is kept, as a share of the size of its component
  static constexpr double least_length_of_dart = 0.08;

public:
  Crease_pruning(const TriangleMesh& tmesh, const Directions& directions) : m_tmesh(tmesh), m_directions(directions) {}

  // `region` numbers the regions between the creases, below `number_of_regions`. Returns the number of specks that are joined
  // to others.
  template <typename FaceRegionMap, typename EdgeIsCreaseMap>
  std::size_t operator()(const FaceRegionMap region, const std::size_t number_of_regions,
                         const std::vector<Edge>& found_by_angle, const EdgeIsCreaseMap is_crease) const
  {
    Disjoint_sets joined(number_of_regions);
    const std::size_t number_of_specks = join_specks(region, number_of_regions, found_by_angle, is_crease, joined);
    drop_short_darts(region, found_by_angle, is_crease, joined);
    return number_of_specks;
  }

private:
  struct Region
  {
    std::size_t number_of_faces = 0;
    Bbox_3 box;
  };

  Face left(const Edge e) const { return face(halfedge(e, m_tmesh), m_tmesh); }
  Face right(const Edge e) const { return face(opposite(halfedge(e, m_tmesh), m_tmesh), m_tmesh); }

  // Takes the creases from the weakest to the sharpest, and opens those at which a region is a speck. So a bump of many facets
  // becomes one region before it is joined to what is around.
  template <typename FaceRegionMap, typename EdgeIsCreaseMap>
  std::size_t join_specks(const FaceRegionMap region, const std::size_t number_of_regions,
                          const std::vector<Edge>& found_by_angle, const EdgeIsCreaseMap is_crease, Disjoint_sets& joined) const
  {
    std::vector<Region> regions(number_of_regions);
    for (const Face f : faces(m_tmesh))
    {
      Region& r = regions[get(region, f)];
      ++r.number_of_faces;
      r.box += m_directions.box(f);
    }
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < found_by_angle.size(); ++i)
      order.emplace_back(m_directions.angle(found_by_angle[i]), i);
    std::sort(order.begin(), order.end());
    std::size_t number_of_specks = 0;
    for (const auto& angle_and_index : order)
    {
      const Edge e = found_by_angle[angle_and_index.second];
      const std::size_t a = joined.find_set(get(region, left(e))), b = joined.find_set(get(region, right(e)));
      const double size = size_of_speck * m_directions.component_size(left(e));
      if (a == b || !(is_speck(regions[a], size) || is_speck(regions[b], size)))
        continue;
      const Region both{regions[a].number_of_faces + regions[b].number_of_faces, regions[a].box + regions[b].box};
      joined.union_set(a, b);
      regions[joined.find_set(a)] = both;
      put(is_crease, e, false);
      ++number_of_specks;
    }
    return number_of_specks;
  }

  static bool is_speck(const Region& region, const double size)
  {
    return region.number_of_faces <= most_faces_of_speck && diagonal_of(region.box) < size;
  }

  template <typename FaceRegionMap, typename EdgeIsCreaseMap>
  void drop_short_darts(const FaceRegionMap region, const std::vector<Edge>& found_by_angle, const EdgeIsCreaseMap is_crease,
                        Disjoint_sets& joined) const
  {
    const Vertex_number_map number = get(dynamic_vertex_property_t<std::size_t>(), m_tmesh);
    std::size_t number_of_vertices = 0;
    for (const auto v : vertices(m_tmesh))
      put(number, v, number_of_vertices++);
    std::vector<Edge> darts;
    for (const Edge e : found_by_angle)
      if (get(is_crease, e) && joined.find_set(get(region, left(e))) == joined.find_set(get(region, right(e))))
        darts.push_back(e);
    Disjoint_sets network(number_of_vertices);
    for (const Edge e : darts)
      network.union_set(get(number, source(e, m_tmesh)), get(number, target(e, m_tmesh)));
    std::vector<double> lengths(number_of_vertices, 0.);
    const auto length_at = [&](const Edge e) -> double& { return lengths[network.find_set(get(number, source(e, m_tmesh)))]; };
    for (const Edge e : darts)
      length_at(e) += m_directions.length(e);
    for (const Edge e : darts)
      if (length_at(e) < least_length_of_dart * m_directions.component_size(left(e)))
        put(is_crease, e, false);
  }

  const TriangleMesh& m_tmesh;
  const Directions& m_directions;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_PRUNE_CREASES_H
