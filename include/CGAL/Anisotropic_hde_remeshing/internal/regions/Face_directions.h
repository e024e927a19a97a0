// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACE_DIRECTIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACE_DIRECTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The normals of the faces and the angles at the edges. A face may be so thin that the rounding of its points turns it. It is
// then taken for a part of its neighbour across the longest edge, and has the normal of this neighbour.
template <typename TriangleMesh, typename VertexPointMap>
class Face_directions
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename Graph_traits::face_descriptor Face;
  typedef typename boost::property_map<TriangleMesh, dynamic_face_property_t<std::size_t>>::const_type Face_number_map;

  // the least height of a face that is not thin, as a share of the size of its component: files have six digits
  static constexpr double least_height = 3e-6;

public:
  Face_directions(const TriangleMesh& tmesh, const VertexPointMap vpm)
    : m_tmesh(tmesh),
      m_vpm(vpm),
      m_number(get(dynamic_face_property_t<std::size_t>(), tmesh)),
      m_component(get(dynamic_face_property_t<std::size_t>(), tmesh))
  {
    std::size_t number = 0;
    for (const Face f : faces(tmesh))
      put(m_number, f, number++);
    measure_components();
    compute_normals();
    lend_normals();
  }

  Vector point(const Halfedge h) const { return to_vector(value_of(m_vpm, target(h, m_tmesh))); }

  double length(const Edge e) const
  {
    const Halfedge h = halfedge(e, m_tmesh);
    return (point(h) - point(opposite(h, m_tmesh))).norm();
  }

  Bbox_3 box(const Face f) const
  {
    Bbox_3 result;
    for (const auto v : vertices_around_face(halfedge(f, m_tmesh), m_tmesh))
      result += value_of(m_vpm, v).bbox();
    return result;
  }

  // the diagonal of the box about the connected component of the mesh
  double component_size(const Face f) const { return m_component_sizes[get(m_component, f)]; }

  bool is_thin(const Face f) const { return m_is_thin[get(m_number, f)]; }

  // between the normals of the faces at an edge inside the mesh, in degrees
  double angle(const Edge e) const
  {
    const Halfedge h = halfedge(e, m_tmesh);
    return angle_between(normal(h), normal(opposite(h, m_tmesh))) * 180 / CGAL_PI;
  }

private:
  const Vector& normal(const Halfedge h) const { return m_normals[get(m_number, face(h, m_tmesh))]; }

  void measure_components()
  {
    const std::size_t n =
        Polygon_mesh_processing::connected_components(m_tmesh, m_component, CGAL::parameters::face_index_map(m_number));
    std::vector<Bbox_3> boxes(n);
    for (const Face f : faces(m_tmesh))
      boxes[get(m_component, f)] += box(f);
    std::transform(boxes.begin(), boxes.end(), std::back_inserter(m_component_sizes), diagonal_of);
  }

  void compute_normals()
  {
    for (const Face f : faces(m_tmesh))
    {
      const Halfedge first = halfedge(f, m_tmesh);
      Vector area = Vector::Zero();
      double longest_edge = 0;
      for (const Halfedge h : halfedges_around_face(first, m_tmesh))
      {
        const Vector along = point(h) - point(prev(h, m_tmesh));
        area += (point(prev(h, m_tmesh)) - point(first)).cross(along);
        longest_edge = (std::max)(longest_edge, along.norm());
      }
      m_is_thin.push_back(!(area.norm() > least_height * component_size(f) * longest_edge));
      m_normals.push_back(m_is_thin.back() ? Vector(Vector::Zero()) : area.normalized());
    }
  }

  // from face to thin face, across the longest edges first
  void lend_normals()
  {
    typedef std::tuple<double, std::size_t, Halfedge> Way; // into the face of the halfedge
    const auto is_after = [](const Way& a, const Way& b)
    { return std::make_pair(std::get<0>(a), std::get<1>(b)) < std::make_pair(std::get<0>(b), std::get<1>(a)); };
    std::priority_queue<Way, std::vector<Way>, decltype(is_after)> ways(is_after);
    const auto push_ways_from = [&](const Face f)
    {
      for (const Halfedge h : halfedges_around_face(halfedge(f, m_tmesh), m_tmesh))
      {
        const Halfedge into = opposite(h, m_tmesh);
        if (!is_border(into, m_tmesh) && is_thin(face(into, m_tmesh)) && normal(into).isZero(0))
          ways.emplace(length(edge(h, m_tmesh)), ways.size(), into);
      }
    };
    for (const Face f : faces(m_tmesh))
      if (!is_thin(f))
        push_ways_from(f);
    while (!ways.empty())
    {
      const Halfedge into = std::get<2>(ways.top());
      ways.pop();
      Vector& borrowed = m_normals[get(m_number, face(into, m_tmesh))];
      if (!borrowed.isZero(0))
        continue;
      borrowed = normal(opposite(into, m_tmesh));
      push_ways_from(face(into, m_tmesh));
    }
  }

  const TriangleMesh& m_tmesh;
  const VertexPointMap m_vpm;
  Face_number_map m_number, m_component;
  std::vector<double> m_component_sizes;
  std::vector<Vector> m_normals; // this and the next by number of the face
  std::vector<bool> m_is_thin;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACE_DIRECTIONS_H
