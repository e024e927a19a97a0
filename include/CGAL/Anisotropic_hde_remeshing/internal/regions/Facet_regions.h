// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACET_REGIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACET_REGIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_plane.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/has_long_facets.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The facets of a mesh, each of one or more faces in a plane, as regions with a crease between any two of them. They are what is
// exact in a mesh of exact facets: by an embedding the vertices move in them and along their edges, and corners stay.
template <typename TriangleMesh, typename VertexPointMap>
class Facet_regions
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor Face;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;

  static constexpr double smallest_turn = 1e-3;   // radians, between two facets; less is rounding
  static constexpr double smallest_height = 1e-9; // of a face, over its longest edge; a lower one has no normal of its own
  static constexpr double planarity = 5e-6;       // of the points, over the diagonal: the rounding of six digits
  static constexpr double smallest_corner = 1e-3; // radians; where an edge of facets turns by less it is straight

public:
  Facet_regions(const TriangleMesh& tmesh, const VertexPointMap vpm)
    : m_tmesh(tmesh), m_vpm(vpm), m_index(get(dynamic_face_property_t<std::size_t>(), tmesh))
  {
    Bbox_3 box;
    for (const Face f : faces(tmesh))
    {
      put(m_index, f, m_corners.size());
      m_faces.push_back(f);
      m_corners.push_back(corners_of_face(f, tmesh, vpm));
      for (const Vector& p : m_corners.back())
        box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
    }
    m_diagonal = diagonal_of(box);
    number_facets();
  }

  // whether there is a plane for each facet; there is none where a face has no area
  bool are_planar() const { return m_planes.size() == m_number_of_facets; }

  // one for each facet, in the order of their numbers
  const std::vector<Region_plane>& planes() const { return m_planes; }

  double area() const
  {
    double result = 0;
    for (std::size_t i = 0; i < m_faces.size(); ++i)
      result += normal(i).norm() / 2;
    return result;
  }

  // of the bounding box
  double diagonal() const { return m_diagonal; }

  template <typename EdgeIsCreaseMap, typename FaceRegionMap>
  void mark(const EdgeIsCreaseMap edge_is_crease, const FaceRegionMap face_region) const
  {
    for (const auto e : edges(m_tmesh))
    {
      const Halfedge h = halfedge(e, m_tmesh);
      put(edge_is_crease, e, !is_border(e, m_tmesh) && facet_of(h) != facet_of(opposite(h, m_tmesh)));
    }
    for (std::size_t i = 0; i < m_faces.size(); ++i)
      put(face_region, m_faces[i], m_facets[i]);
  }

  // The number of faces with all corners of the facets and no other vertices. With V vertices, B of them on boundaries, and the Euler
  // characteristic c, a triangle mesh has 2 V - B - 2 c faces.
  double least_number_of_faces() const
  {
    double vertices_of_mesh = 0, corners = 0, boundary_corners = 0;
    for (const auto v : vertices(m_tmesh))
    {
      if (halfedge(v, m_tmesh) == Graph_traits::null_halfedge())
        continue;
      ++vertices_of_mesh;
      std::vector<Vector> ways; // along edges of facets
      bool is_on_boundary = false;
      for (const Halfedge h : halfedges_around_target(v, m_tmesh))
      {
        const Halfedge o = opposite(h, m_tmesh);
        const bool is_boundary = is_border(h, m_tmesh) || is_border(o, m_tmesh);
        is_on_boundary = is_on_boundary || is_boundary;
        if (is_boundary || facet_of(h) != facet_of(o))
          ways.push_back(to_vector(value_of(m_vpm, source(h, m_tmesh))) - to_vector(value_of(m_vpm, v)));
      }
      if (ways.empty() || (ways.size() == 2 && angle_between(ways[0], -ways[1]) < smallest_corner))
        continue;
      ++corners;
      boundary_corners += is_on_boundary ? 1 : 0;
    }
    const double number_of_edges = double(std::distance(edges(m_tmesh).begin(), edges(m_tmesh).end())),
                 characteristic = vertices_of_mesh - number_of_edges + double(m_faces.size());
    return (std::max)(2 * corners - boundary_corners - 2 * characteristic, 0.);
  }

private:
  typedef typename boost::property_map<TriangleMesh, dynamic_face_property_t<std::size_t>>::const_type Index_map;

  // requires that it is no border
  std::size_t facet_of(const Halfedge h) const { return m_facets[index_of(h)]; }
  std::size_t index_of(const Halfedge h) const { return get(m_index, face(h, m_tmesh)); }

  Vector normal(const std::size_t i) const
  {
    return (m_corners[i][1] - m_corners[i][0]).cross(m_corners[i][2] - m_corners[i][0]);
  }

  bool has_normal(const std::size_t i) const { return normal(i).norm() > smallest_height * longest_square(m_corners[i]); }

  // Joins faces that lie in one plane. A face without a normal is one with that beyond its longest edge.
  void number_facets()
  {
    Disjoint_sets sets(m_faces.size());
    for (std::size_t i = 0; i < m_faces.size(); ++i)
    {
      const bool is_flat = !has_normal(i);
      const Halfedge longest = is_flat ? longest_edge(i) : Graph_traits::null_halfedge();
      for (const Halfedge h : halfedges_around_face(halfedge(m_faces[i], m_tmesh), m_tmesh))
      {
        const Halfedge o = opposite(h, m_tmesh);
        if (is_border(o, m_tmesh))
          continue;
        const std::size_t j = index_of(o);
        if (is_flat ? h == longest : has_normal(j) && angle_between(normal(i), normal(j)) < smallest_turn)
          sets.union_set(i, j);
      }
    }
    m_facets.resize(m_faces.size());
    for (std::size_t i = 0; i < m_faces.size(); ++i)
      m_facets[i] = sets.find_set(i);
    find_planes();
  }

  Halfedge longest_edge(const std::size_t i) const
  {
    Halfedge result = halfedge(m_faces[i], m_tmesh);
    double longest = -1;
    for (const Halfedge h : halfedges_around_face(halfedge(m_faces[i], m_tmesh), m_tmesh))
    {
      const double length =
          (to_vector(value_of(m_vpm, source(h, m_tmesh))) - to_vector(value_of(m_vpm, target(h, m_tmesh)))).squaredNorm();
      if (length > longest)
      {
        longest = length;
        result = h;
      }
    }
    return result;
  }

  // The planes of the facets, which are numbered in the order of their first faces. Faces of a facet that bends, by less than
  // rounding from one to the next, are facets of their own.
  void find_planes()
  {
    std::vector<std::vector<std::size_t>> faces_of(m_faces.size());
    for (std::size_t i = 0; i < m_faces.size(); ++i)
      faces_of[m_facets[i]].push_back(i);
    std::vector<std::vector<std::size_t>> parts;
    for (std::size_t i = 0; i < m_faces.size(); ++i)
    {
      const std::vector<std::size_t>& part = faces_of[m_facets[i]];
      if (part.front() != i)
        continue;
      if (add_plane(part))
        parts.push_back(part);
      else
        for (const std::size_t j : part)
        {
          add_plane({j});
          parts.push_back({j});
        }
    }
    m_number_of_facets = parts.size();
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (const std::size_t i : parts[k])
        m_facets[i] = k;
  }

  // that of these faces, if they are in one
  bool add_plane(const std::vector<std::size_t>& part)
  {
    std::vector<Vector> points;
    std::vector<Facet> facets;
    for (const std::size_t i : part)
    {
      facets.push_back({points.size(), points.size() + 1, points.size() + 2});
      points.insert(points.end(), m_corners[i].begin(), m_corners[i].end());
    }
    const std::optional<Region_plane> plane = plane_of(points, facets, planarity * m_diagonal);
    if (plane)
      m_planes.push_back(*plane);
    return plane.has_value();
  }

  const TriangleMesh& m_tmesh;
  const VertexPointMap m_vpm;
  Index_map m_index; // by face
  std::vector<Face> m_faces;
  std::vector<std::array<Vector, 3>> m_corners;
  std::vector<std::size_t> m_facets; // by index
  std::vector<Region_plane> m_planes;
  std::size_t m_number_of_facets = 0;
  double m_diagonal = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACET_REGIONS_H
