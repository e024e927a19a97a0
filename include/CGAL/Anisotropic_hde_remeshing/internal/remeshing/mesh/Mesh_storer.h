// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MESH_STORER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MESH_STORER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Input_location.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Map_transaction.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/New_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/load_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/new_elements.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Replaces the remeshed faces of the caller's mesh. Three kinds of elements keep their descriptors: all outside of these faces,
// the fixed vertices, and the edges that must not be touched. If memory runs out or one of the caller's property maps throws,
// the caller's mesh is as it was before, except for the garbage of a Surface_mesh. To this end, all that may throw is done
// while the old elements are there, and overwritten values are put back. `LocationMap` may be internal_np::Param_not_found.
template <typename ConcurrencyTag, typename Mesh, typename TriangleMesh, typename VertexPointMap, typename Constraints,
          typename LocationMap>
class Mesh_storer
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename Graph_traits::face_descriptor Face;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  typedef std::decay_t<decltype(std::declval<const Constraints&>().edge_is_constrained)> Edge_is_constrained_map;
  typedef std::decay_t<decltype(std::declval<const Constraints&>().face_patch)> Face_patch_map;
  typedef std::vector<std::pair<Vertex, Input_location>> Located_vertices;

  template <typename Map, typename Key>
  static constexpr bool is_own_map = Is_own_map<TriangleMesh, Map, Key>::value;
  static constexpr bool has_locations = !std::is_same<LocationMap, internal_np::Param_not_found>::value;

public:
  // `locations` of the vertices of the working mesh, and those of the vertices that have no part in the remeshing
  Mesh_storer(const Mesh& mesh, const Mesh_origin<TriangleMesh>& origin, TriangleMesh& tmesh, const VertexPointMap vpm,
              const Constraints& constraints, const LocationMap location_map, const std::vector<Input_location>& locations,
              const Located_vertices& locations_of_rest)
    : m_mesh(mesh),
      m_origin(origin),
      m_tmesh(tmesh),
      m_vpm(vpm),
      m_edge_is_constrained(constraints.edge_is_constrained),
      m_face_patch(constraints.face_patch),
      m_location_map(location_map),
      m_locations(locations),
      m_locations_of_rest(locations_of_rest),
      m_vertices(vertex_capacity(mesh)),
      m_halfedges(mesh.num_halfedges(), Graph_traits::null_halfedge())
  {
  }

  // `is_all_replaced`: no element has to keep its descriptor
  void operator()(const bool is_all_replaced)
  {
    if (!is_all_replaced)
      keep_elements();
    list_new_elements(is_all_replaced);
    if constexpr (is_surface_mesh(static_cast<const TriangleMesh*>(nullptr)))
      if (is_all_replaced && (has_own_maps() || !m_tmesh.has_garbage())) // collecting it would change the maps' keys
        return renew();
    replace(is_all_replaced);
  }

private:
  struct Old_elements
  {
    std::vector<Edge> edges;
    std::vector<Vertex> vertices;
  };

  bool is_untouchable(const Edge_index e) const { return m_mesh.arc(m_mesh.halfedge(e)).curve == Curve_arc::untouchable; }

  static std::size_t index(const Halfedge_index h) { return std::size_t(h); }

  // replaces all elements of a Surface_mesh at once
  void renew()
  {
    const New_points<Point, Mesh> points(m_mesh, m_origin.unit, m_new_vertices);
    Map_transaction<VertexPointMap, Vertex> written(m_vpm);
    write_foreign_maps(points, written);
    const New_elements<TriangleMesh> added =
        replace_elements(m_new_vertices.size(), m_new_edges.size(), m_new_faces.size(), m_tmesh);
    written.commit();
    set_vertices(added.vertices);
    if constexpr (is_own_map<VertexPointMap, Vertex>)
      for_each(added.vertices.size(), true, [&](const std::size_t i) { put(m_vpm, added.vertices[i], points[i]); });
    if constexpr (has_locations)
      if constexpr (is_own_map<LocationMap, Vertex>)
        put_locations();
    connect(added, true);
  }

  // replaces the elements one after the other
  void replace(const bool is_all_replaced)
  {
    const auto patches = patches_of_input(is_all_replaced);
    const Old_elements gone = list_old_elements(is_all_replaced);
    const New_elements<TriangleMesh> added =
        add_elements(m_new_vertices.size(), m_new_edges.size(), m_new_faces.size(), m_tmesh);
    set_vertices(added.vertices);
    try
    {
      write_maps(added, gone, patches, is_all_replaced);
    }
    catch (...)
    {
      remove_elements(added, m_tmesh);
      throw;
    }
    remove(gone);
    connect(added, is_all_replaced);
  }

  // Writes the maps of the new elements and of the kept ones. The old elements are still there. Old edges are marked no more: a set
  // would keep them, and a new edge may get the descriptor of an old one some day.
  template <typename Patches>
  void write_maps(const New_elements<TriangleMesh>& added, const Old_elements& gone, const Patches& patches,
                  const bool is_all_replaced)
  {
    const New_points<Point, Mesh> points(m_mesh, m_origin.unit, m_new_vertices);
    for (std::size_t i = 0; i < added.vertices.size(); ++i)
      put(m_vpm, added.vertices[i], points[i]);
    Map_transaction<Edge_is_constrained_map, Edge> written(m_edge_is_constrained);
    Map_transaction<VertexPointMap, Vertex> moved(m_vpm);
    if (!is_all_replaced)
    {
      move_kept_vertices(moved);
      for (const Edge e : gone.edges)
        if (get(m_edge_is_constrained, e))
          written.write(e, false);
      for (std::size_t i = 0; i < added.edges.size(); ++i)
        put(m_edge_is_constrained, added.edges[i], m_mesh.is_on_curve(m_new_edges[i]) && !m_mesh.is_border(m_new_edges[i]));
      std::size_t i = 0;
      for (const Face_index f : m_mesh.faces())
        put(m_face_patch, added.faces[i++], patches[m_mesh.input_face(f)]);
      write_kept_edges(written);
    }
    if constexpr (has_locations)
      put_locations();
    written.commit();
    moved.commit();
  }

  // Corners of borders keep their descriptors, but may have moved onto the surface. All other points are not written, as they may be
  // those of an exact kernel.
  void move_kept_vertices(Map_transaction<VertexPointMap, Vertex>& moved)
  {
    std::vector<Vertex_index> vertices;
    for (const Vertex_index v : m_mesh.vertices())
      if (m_mesh.point(v).is_fixed && m_mesh.point(v).is_on_curve &&
          to_vector(value_of(m_vpm, m_vertices[v])) / m_origin.unit != m_mesh.point(v).point)
        vertices.push_back(v);
    const New_points<Point, Mesh> points(m_mesh, m_origin.unit, vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      moved.write(m_vertices[vertices[i]], points[i]);
  }

  // Marks the protected creases as constrained, because the caller may not have marked them. Edges on the border of the
  // remeshed faces are not touched.
  void write_kept_edges(Map_transaction<Edge_is_constrained_map, Edge>& written)
  {
    for (const Edge_index e : m_mesh.edges())
      if (is_untouchable(e) && !m_mesh.is_border(e))
      {
        const Edge kept = edge(m_halfedges[index(m_mesh.halfedge(e))], m_tmesh);
        if (!get(m_edge_is_constrained, kept))
          written.write(kept, true);
      }
  }

  // Writes the property maps that the mesh does not keep itself. The keys are the numbers that the new vertices will have.
  void write_foreign_maps(const New_points<Point, Mesh>& points, Map_transaction<VertexPointMap, Vertex>& written)
  {
    if constexpr (!is_own_map<VertexPointMap, Vertex>)
      for (std::size_t i = 0; i < m_new_vertices.size(); ++i)
      {
        const Vertex v = numbered_vertex(i);
        if (i < num_vertices(m_tmesh))
          written.write(v, points[i]);
        else
          put(m_vpm, v, points[i]);
      }
    if constexpr (has_locations)
      if constexpr (!is_own_map<LocationMap, Vertex>)
        for (std::size_t i = 0; i < m_new_vertices.size(); ++i)
          put(m_location_map, numbered_vertex(i), m_locations[m_new_vertices[i]]);
  }

  static Vertex numbered_vertex(const std::size_t i) { return Vertex(static_cast<typename TriangleMesh::size_type>(i)); }

  // Whether all property maps to write are those that the mesh keeps itself. Writing them practically never throws.
  static constexpr bool has_own_maps()
  {
    if constexpr (!has_locations)
      return is_own_map<VertexPointMap, Vertex>;
    else
      return is_own_map<VertexPointMap, Vertex> && is_own_map<LocationMap, Vertex>;
  }

  void put_locations()
  {
    for (const Vertex_index v : m_mesh.vertices())
      put(m_location_map, m_vertices[v], m_locations[v]);
    for (const auto& located : m_locations_of_rest)
      put(m_location_map, located.first, located.second);
  }

  void set_vertices(const std::vector<Vertex>& added)
  {
    for (std::size_t i = 0; i < added.size(); ++i)
      m_vertices[m_new_vertices[i]] = added[i];
  }

  // The patches of the remeshed faces, by their numbers: their descriptors will be gone.
  auto patches_of_input(const bool is_all_replaced) const
  {
    typedef Value_of_map<Face_patch_map, Face> Patch;
    std::vector<Patch> result;
    if (!is_all_replaced)
      for (const Face f : m_origin.faces)
        result.push_back(get(m_face_patch, f));
    return result;
  }

  void keep_elements()
  {
    for (const Vertex_index v : m_mesh.vertices())
      if (m_mesh.point(v).is_fixed)
        m_vertices[v] = m_origin.vertices[m_mesh.point(v).input_vertex];
    for (const Edge_index e : m_mesh.edges())
      if (is_untouchable(e))
      {
        const Halfedge_index h = m_mesh.halfedge(e);
        const Halfedge kept = halfedge(m_vertices[m_mesh.source(h)], m_vertices[m_mesh.target(h)], m_tmesh).first;
        m_halfedges[index(h)] = kept;
        m_halfedges[index(m_mesh.opposite(h))] = opposite(kept, m_tmesh);
      }
  }

  // Lists the edges and vertices of the replaced faces, except those that are kept. It also fills m_border with the border
  // halfedges that stay.
  Old_elements list_old_elements(const bool is_all_replaced)
  {
    if (is_all_replaced)
      return Old_elements{{edges(m_tmesh).begin(), edges(m_tmesh).end()}, {vertices(m_tmesh).begin(), vertices(m_tmesh).end()}};
    enum : char
    {
      STAYS,
      GOES
    };
    const auto edge_state = get(dynamic_edge_property_t<char>(), m_tmesh);
    const auto vertex_state = get(dynamic_vertex_property_t<char>(), m_tmesh);
    for (const Edge e : edges(m_tmesh))
      put(edge_state, e, char(STAYS));
    for (const Vertex v : vertices(m_tmesh))
      put(vertex_state, v, char(STAYS));
    for (const Face f : m_origin.faces)
      for (const Halfedge h : halfedges_around_face(halfedge(f, m_tmesh), m_tmesh))
      {
        put(edge_state, edge(h, m_tmesh), char(GOES));
        put(vertex_state, target(h, m_tmesh), char(GOES));
      }
    for (const Edge_index e : m_mesh.edges())
      if (is_untouchable(e))
        put(edge_state, edge(m_halfedges[index(m_mesh.halfedge(e))], m_tmesh), char(STAYS));
    for (const Vertex_index v : m_mesh.vertices())
      if (m_mesh.point(v).is_fixed)
        put(vertex_state, m_vertices[v], char(STAYS));

    Old_elements gone;
    for (const Edge e : edges(m_tmesh))
      if (get(edge_state, e) == GOES)
        gone.edges.push_back(e);
    for (const Vertex v : vertices(m_tmesh))
      if (get(vertex_state, v) == GOES)
        gone.vertices.push_back(v);
    std::vector<Halfedge> border;
    for (const Halfedge h : halfedges(m_tmesh))
      if (is_border(h, m_tmesh) && get(edge_state, edge(h, m_tmesh)) == STAYS)
        border.push_back(h);
    m_border.reserve(border.size() + m_border.capacity());
    m_border.assign(border.begin(), border.end());
    return gone;
  }

  void remove(const Old_elements& gone)
  {
    for (const Face f : m_origin.faces)
      remove_face(f, m_tmesh);
    for (const Edge e : gone.edges)
      remove_edge(e, m_tmesh);
    for (const Vertex v : gone.vertices)
      remove_vertex(v, m_tmesh);
  }

  bool is_kept(const Vertex_index v, const bool is_all_replaced) const { return !is_all_replaced && m_mesh.point(v).is_fixed; }

  bool is_kept(const Edge_index e) const { return m_halfedges[index(m_mesh.halfedge(e))] != Graph_traits::null_halfedge(); }

  // also reserves memory for the border halfedges of the new elements
  void list_new_elements(const bool is_all_replaced)
  {
    std::size_t number_of_border_edges = 0;
    for (const Vertex_index v : m_mesh.vertices())
      if (!is_kept(v, is_all_replaced))
        m_new_vertices.push_back(v);
    for (const Edge_index e : m_mesh.edges())
      if (!is_kept(e))
      {
        m_new_edges.push_back(e);
        number_of_border_edges += m_mesh.is_border(e) ? 1 : 0;
      }
    m_new_faces.assign(m_mesh.faces().begin(), m_mesh.faces().end());
    m_border.reserve(number_of_border_edges);
  }

  // Several threads write the elements of a Surface_mesh. The caller's property maps may not allow that. Where all elements are
  // replaced, no such map is written.
  template <typename Function>
  void for_each(const std::size_t n, const bool is_all_replaced, const Function& f) const
  {
    typedef typename boost::property_map<TriangleMesh, vertex_point_t>::type Own_point_map;
    if constexpr (is_surface_mesh(static_cast<const TriangleMesh*>(nullptr)) &&
                  std::is_same<VertexPointMap, Own_point_map>::value)
      if (is_all_replaced)
      {
        parallel_for<ConcurrencyTag>(n, f, 4096);
        return;
      }
    for (std::size_t i = 0; i < n; ++i)
      f(i);
  }

  template <typename Point>
  static constexpr bool is_surface_mesh(const Surface_mesh<Point>*)
  {
    return true;
  }
  static constexpr bool is_surface_mesh(const void*) { return false; }

  // connects all new elements; nothing here throws
  void connect(const New_elements<TriangleMesh>& added, const bool is_all_replaced)
  {
    connect_edges(added.edges, is_all_replaced);
    connect_faces(added.faces, is_all_replaced);
    close_border();
  }

  void connect_edges(const std::vector<Edge>& added, const bool is_all_replaced)
  {
    for_each(added.size(), is_all_replaced,
             [&](const std::size_t i)
             {
               const Halfedge_index h = m_mesh.halfedge(m_new_edges[i]), g = m_mesh.opposite(h);
               m_halfedges[index(h)] = halfedge(added[i], m_tmesh);
               m_halfedges[index(g)] = opposite(m_halfedges[index(h)], m_tmesh);
               for (const Halfedge_index side : {h, g})
                 set_target(m_halfedges[index(side)], m_vertices[m_mesh.target(side)], m_tmesh);
             });
    for (std::size_t i = 0; i < added.size(); ++i)
    {
      const Edge_index e = m_new_edges[i];
      const bool is_on_border = m_mesh.is_border(e);
      if (is_on_border)
        for (const Halfedge_index side : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
          if (m_mesh.is_border(side))
          {
            set_face(m_halfedges[index(side)], Graph_traits::null_face(), m_tmesh);
            m_border.push_back(m_halfedges[index(side)]);
          }
    }
  }

  void connect_faces(const std::vector<Face>& added, const bool is_all_replaced)
  {
    for_each(added.size(), is_all_replaced,
             [&](const std::size_t i)
             {
               Halfedge_index h = m_mesh.halfedge(m_new_faces[i]);
               set_halfedge(added[i], m_halfedges[index(h)], m_tmesh);
               for (int k = 0; k < 3; ++k, h = m_mesh.next(h))
               {
                 set_face(m_halfedges[index(h)], added[i], m_tmesh);
                 set_next(m_halfedges[index(h)], m_halfedges[index(m_mesh.next(h))], m_tmesh);
               }
             });
    for (const Vertex_index v : m_mesh.vertices())
      set_halfedge(m_vertices[v], m_halfedges[index(m_mesh.halfedge(v))], m_tmesh);
  }

  // Finds the successor of each border halfedge. A manifold vertex has only one border halfedge that leaves it: the walk over
  // the faces around the vertex ends there. The border halfedge that ends at the vertex becomes the vertex's own, as in a mesh
  // that CGAL builds.
  void close_border() const
  {
    for (const Halfedge h : m_border)
    {
      Halfedge out = opposite(h, m_tmesh);
      while (!is_border(out, m_tmesh))
        out = opposite(prev(out, m_tmesh), m_tmesh);
      set_next(h, out, m_tmesh);
      set_halfedge(target(h, m_tmesh), h, m_tmesh);
    }
  }

  const Mesh& m_mesh;
  const Mesh_origin<TriangleMesh>& m_origin;
  TriangleMesh& m_tmesh;
  VertexPointMap m_vpm; // maps to write are not const: `put` of some maps takes no other
  Edge_is_constrained_map m_edge_is_constrained;
  Face_patch_map m_face_patch;
  LocationMap m_location_map;
  const std::vector<Input_location>& m_locations;
  const Located_vertices& m_locations_of_rest;
  std::vector<Vertex> m_vertices;
  std::vector<Halfedge> m_halfedges;        // of the caller's mesh, by halfedges of the working mesh
  std::vector<Vertex_index> m_new_vertices; // elements that the caller's mesh does not have yet
  std::vector<Edge_index> m_new_edges;
  std::vector<Face_index> m_new_faces;
  std::vector<Halfedge> m_border; // border halfedges that may get another next halfedge
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MESH_STORER_H
