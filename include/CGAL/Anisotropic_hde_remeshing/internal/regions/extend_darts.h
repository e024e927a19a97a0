// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_EXTEND_DARTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_EXTEND_DARTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A crease that fades out ends inside a region. This region is on both of its sides, and one smooth function would round the
// crease off. So the crease is extended from its tip to the next crease or boundary, along edges that are as sharp and as few
// as can be. Then it has a region on each side.
template <typename TriangleMesh, typename Directions>
class Dart_extension
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<std::size_t>>::const_type Vertex_number_map;

  // the share of its length that an edge costs less if it is as sharp as a crease
  static constexpr double bonus_of_sharpness = 0.9;
  // the largest cost of an extension, over the length of the dart: to cut more smooth surface than crease is not worth it
  static constexpr double largest_cost = 0.5;

public:
  Dart_extension(const TriangleMesh& tmesh, const Directions& directions, const double sharp_angle)
    : m_tmesh(tmesh),
      m_directions(directions),
      m_sharp_angle(sharp_angle),
      m_number(get(dynamic_vertex_property_t<std::size_t>(), tmesh))
  {
    std::size_t number = 0;
    for (const Vertex v : vertices(tmesh))
      put(m_number, v, number++);
    m_costs.assign(number, infinite);
    m_ways.assign(number, Graph_traits::null_halfedge());
  }

  // Marks the edges of the extensions as creases and returns them. `region` numbers the regions between the creases. Only
  // creases that were found by their angle may be darts.
  template <typename FaceRegionMap, typename EdgeIsCreaseMap>
  std::vector<Edge> operator()(const FaceRegionMap region, const std::vector<Edge>& found_by_angle,
                               const EdgeIsCreaseMap is_crease)
  {
    Disjoint_sets networks(m_costs.size());
    std::vector<Edge> darts;
    for (const Edge e : found_by_angle)
      if (get(is_crease, e) && is_dart(e, region))
      {
        darts.push_back(e);
        networks.union_set(get(m_number, source(e, m_tmesh)), get(m_number, target(e, m_tmesh)));
      }
    std::vector<double> lengths(m_costs.size(), 0.);
    for (const Edge e : darts)
      lengths[networks.find_set(get(m_number, source(e, m_tmesh)))] += m_directions.length(e);
    std::vector<Edge> result;
    for (const Edge e : darts)
      for (const Halfedge h : {halfedge(e, m_tmesh), opposite(halfedge(e, m_tmesh), m_tmesh)})
        if (is_tip(target(h, m_tmesh), is_crease))
        {
          const std::size_t network = networks.find_set(get(m_number, target(h, m_tmesh)));
          const auto is_goal = [&](const Vertex v) { return is_on_other_curve(v, is_crease, region, networks, network); };
          extend(target(h, m_tmesh), largest_cost * lengths[network], is_goal, is_crease, result);
        }
    return result;
  }

private:
  static constexpr double infinite = (std::numeric_limits<double>::max)();

  template <typename FaceRegionMap>
  bool is_dart(const Edge e, const FaceRegionMap region) const
  {
    const Halfedge h = halfedge(e, m_tmesh);
    return get(region, face(h, m_tmesh)) == get(region, face(opposite(h, m_tmesh), m_tmesh));
  }

  // where one crease ends
  template <typename EdgeIsCreaseMap>
  bool is_tip(const Vertex v, const EdgeIsCreaseMap is_crease) const
  {
    std::size_t degree = 0;
    for (const Halfedge h : halfedges_around_target(v, m_tmesh))
    {
      if (is_border(edge(h, m_tmesh), m_tmesh))
        return false;
      degree += get(is_crease, edge(h, m_tmesh)) ? 1 : 0;
    }
    return degree == 1;
  }

  // whether it is on the boundary, on a crease between two regions, or on a dart that is not of the network
  template <typename EdgeIsCreaseMap, typename FaceRegionMap>
  bool is_on_other_curve(const Vertex v, const EdgeIsCreaseMap is_crease, const FaceRegionMap region, Disjoint_sets& networks,
                         const std::size_t network) const
  {
    for (const Halfedge h : halfedges_around_target(v, m_tmesh))
    {
      const Edge e = edge(h, m_tmesh);
      if (is_border(e, m_tmesh))
        return true;
      if (get(is_crease, e) && (!is_dart(e, region) || networks.find_set(get(m_number, v)) != network))
        return true;
    }
    return false;
  }

  double cost(const Edge e) const
  {
    const double sharpness = (std::min)(m_directions.angle(e) / m_sharp_angle, 1.);
    return m_directions.length(e) * (1 - bonus_of_sharpness * sharpness);
  }

  // By Dijkstra's algorithm. That of Boost can be ended early by an exception only. The numbers of the vertices decide ties.
  template <typename IsGoal, typename EdgeIsCreaseMap>
  void extend(const Vertex tip, const double largest, const IsGoal& is_goal, const EdgeIsCreaseMap is_crease,
              std::vector<Edge>& result)
  {
    typedef std::pair<std::pair<double, std::size_t>, Vertex> Reached;
    const auto is_after = [](const Reached& a, const Reached& b) { return b.first < a.first; };
    std::priority_queue<Reached, std::vector<Reached>, decltype(is_after)> front(is_after);
    std::vector<std::size_t> touched;
    const auto reach = [&](const Vertex v, const double cost, const Halfedge way)
    {
      const std::size_t number = get(m_number, v);
      if (!(cost < m_costs[number]) || cost > largest)
        return;
      m_costs[number] = cost;
      m_ways[number] = way;
      touched.push_back(number);
      front.emplace(std::make_pair(cost, number), v);
    };
    reach(tip, 0, Graph_traits::null_halfedge());
    while (!front.empty())
    {
      const Vertex v = front.top().second;
      const auto [cost_of_v, number] = front.top().first;
      front.pop();
      if (cost_of_v > m_costs[number])
        continue;
      if (v != tip && is_goal(v))
      {
        for (Halfedge way = m_ways[number]; way != Graph_traits::null_halfedge();
             way = m_ways[get(m_number, source(way, m_tmesh))])
        {
          put(is_crease, edge(way, m_tmesh), true);
          result.push_back(edge(way, m_tmesh));
        }
        break;
      }
      for (const Halfedge h : halfedges_around_target(v, m_tmesh))
        if (!get(is_crease, edge(h, m_tmesh)))
          reach(source(h, m_tmesh), cost_of_v + cost(edge(h, m_tmesh)), opposite(h, m_tmesh));
    }
    for (const std::size_t number : touched)
      m_costs[number] = infinite;
  }

  const TriangleMesh& m_tmesh;
  const Directions& m_directions;
  const double m_sharp_angle;
  Vertex_number_map m_number;
  std::vector<double> m_costs;  // by number of the vertex; infinite between two searches
  std::vector<Halfedge> m_ways; // by number of the vertex: the last halfedge on the way to it
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_EXTEND_DARTS_H
