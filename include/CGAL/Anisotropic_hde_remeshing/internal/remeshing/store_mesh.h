// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_STORE_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_STORE_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/load_mesh.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// elements without connectivity
template <typename TriangleMesh>
struct New_elements
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor> edges;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> faces;
};

template <typename TriangleMesh>
void reserve_elements(std::size_t, std::size_t, std::size_t, TriangleMesh&)
{
}

// One that runs out of memory while it adds an element is left with property maps of different sizes.
template <typename Point>
void reserve_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                      const std::size_t number_of_faces, Surface_mesh<Point>& tmesh)
{
  typedef typename Surface_mesh<Point>::size_type size_type;
  tmesh.reserve(size_type(tmesh.num_vertices() + number_of_vertices), size_type(tmesh.num_edges() + number_of_edges),
                size_type(tmesh.num_faces() + number_of_faces));
}

// all of them, or none if one throws
template <typename TriangleMesh>
New_elements<TriangleMesh> add_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                                        const std::size_t number_of_faces, TriangleMesh& tmesh)
{
  New_elements<TriangleMesh> result;
  result.vertices.reserve(number_of_vertices);
  result.edges.reserve(number_of_edges);
  result.faces.reserve(number_of_faces);
  reserve_elements(number_of_vertices, number_of_edges, number_of_faces, tmesh);
  try
  {
    while (result.vertices.size() < number_of_vertices)
      result.vertices.push_back(add_vertex(tmesh));
    while (result.edges.size() < number_of_edges)
      result.edges.push_back(add_edge(tmesh));
    while (result.faces.size() < number_of_faces)
      result.faces.push_back(add_face(tmesh));
  }
  catch (...)
  {
    for (const auto f : result.faces)
      remove_face(f, tmesh);
    for (const auto e : result.edges)
      remove_edge(e, tmesh);
    for (const auto v : result.vertices)
      remove_vertex(v, tmesh);
    throw;
  }
  return result;
}

// in the place of all that there are
template <typename TriangleMesh>
New_elements<TriangleMesh> replace_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                                            const std::size_t number_of_faces, TriangleMesh& tmesh)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const std::vector<typename Graph_traits::vertex_descriptor> old_vertices(vertices(tmesh).begin(), vertices(tmesh).end());
  const std::vector<typename Graph_traits::edge_descriptor> old_edges(edges(tmesh).begin(), edges(tmesh).end());
  const std::vector<typename Graph_traits::face_descriptor> old_faces(faces(tmesh).begin(), faces(tmesh).end());
  const New_elements<TriangleMesh> result = add_elements(number_of_vertices, number_of_edges, number_of_faces, tmesh);
  for (const auto f : old_faces)
    remove_face(f, tmesh);
  for (const auto e : old_edges)
    remove_edge(e, tmesh);
  for (const auto v : old_vertices)
    remove_vertex(v, tmesh);
  return result;
}

// At once, in a fraction of the time. The property maps of the caller stay, among them perhaps the one of the points.
template <typename Point>
New_elements<Surface_mesh<Point>> replace_elements(const std::size_t number_of_vertices, const std::size_t number_of_edges,
                                                   const std::size_t number_of_faces, Surface_mesh<Point>& tmesh)
{
  typedef Surface_mesh<Point> Mesh;
  typedef typename Mesh::size_type size_type;
  New_elements<Mesh> result;
  result.vertices.reserve(number_of_vertices);
  result.edges.reserve(number_of_edges);
  result.faces.reserve(number_of_faces);
  if (tmesh.has_garbage())
    tmesh.collect_garbage();
  // from here to the end nothing asks for memory
  tmesh.reserve(size_type(number_of_vertices), size_type(number_of_edges), size_type(number_of_faces));
  tmesh.resize(0, 0, 0);
  tmesh.resize(size_type(number_of_vertices), size_type(number_of_edges), size_type(number_of_faces));
  result.vertices.assign(tmesh.vertices().begin(), tmesh.vertices().end());
  result.edges.assign(tmesh.edges().begin(), tmesh.edges().end());
  result.faces.assign(tmesh.faces().begin(), tmesh.faces().end());
  return result;
}

// Replaces the remeshed faces of the caller's mesh. What it does not replace keeps its descriptors: all outside of these faces,
// the fixed vertices, and the edges that must not be touched. Where memory runs out, the caller's mesh is as it was, but for
// the garbage of a Surface_mesh, which may be collected: what asks for memory comes first.
template <typename ConcurrencyTag, typename Mesh, typename TriangleMesh, typename VertexPointMap, typename Constraints>
class Mesh_storer
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename Graph_traits::face_descriptor Face;

public:
  Mesh_storer(const Mesh& mesh, const Mesh_origin<TriangleMesh>& origin, TriangleMesh& tmesh, const VertexPointMap vpm,
              const Constraints& constraints)
    : m_mesh(mesh),
      m_origin(origin),
      m_tmesh(tmesh),
      m_vpm(vpm),
      m_constraints(constraints),
      m_vertices(vertex_capacity(mesh)),
      m_halfedges(mesh.num_halfedges(), Graph_traits::null_halfedge())
  {
  }

  // `is_all_replaced`: nothing needs to keep its descriptors
  void operator()(const bool is_all_replaced)
  {
    const auto patches = patches_of_input(is_all_replaced);
    if (!is_all_replaced)
      keep_elements();
    list_new_elements(is_all_replaced);
    New_elements<TriangleMesh> added;
    if (is_all_replaced)
      added = replace_elements(m_new_vertices.size(), m_new_edges.size(), m_new_faces.size(), m_tmesh);
    else
    {
      const Old_elements gone = list_old_elements();
      added = add_elements(m_new_vertices.size(), m_new_edges.size(), m_new_faces.size(), m_tmesh);
      remove(gone);
    }
    place_vertices(added.vertices, is_all_replaced);
    connect_edges(added.edges, is_all_replaced);
    connect_faces(added.faces, is_all_replaced);
    close_border();
    if (!is_all_replaced)
      put_patches(added.faces, patches);
  }

  // the vertex of the caller's mesh that stands for one of the working mesh
  Vertex vertex(const Vertex_index v) const { return m_vertices[v]; }

private:
  bool is_untouchable(const Edge_index e) const { return m_mesh.arc(m_mesh.halfedge(e)).curve == Curve_arc::untouchable; }

  static std::size_t index(const Halfedge_index h) { return std::size_t(h); }

  // by the number of the face among those that are remeshed: their descriptors will be gone
  auto patches_of_input(const bool is_all_replaced) const
  {
    typedef std::decay_t<decltype(get(m_constraints.face_patch, *faces(m_tmesh).begin()))> Patch;
    std::vector<Patch> result;
    if (!is_all_replaced)
      for (const Face f : m_origin.faces)
        result.push_back(get(m_constraints.face_patch, f));
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

  struct Old_elements
  {
    std::vector<Edge> edges;
    std::vector<Vertex> vertices;
  };

  // the edges and vertices of the faces that are replaced, but those that are kept; and the border that stays
  Old_elements list_old_elements()
  {
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

  // and reserves memory for their border
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

  // Elements of a Surface_mesh are written by several threads. The maps of the caller may not stand that; where all elements
  // are replaced there are none.
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

  void place_vertices(const std::vector<Vertex>& added, const bool is_all_replaced)
  {
    typedef typename boost::property_traits<VertexPointMap>::value_type Point;
    for (std::size_t i = 0; i < added.size(); ++i)
      m_vertices[m_new_vertices[i]] = added[i];
    for_each(added.size(), is_all_replaced,
             [&](const std::size_t i)
             {
               const Vector p = m_origin.unit * m_mesh.point(m_new_vertices[i]).point;
               put(m_vpm, added[i], Point(p[0], p[1], p[2]));
             });
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
      if (!is_all_replaced)
        put(m_constraints.edge_is_constrained, added[i], m_mesh.is_on_curve(e) && !is_on_border);
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

  template <typename Patches>
  void put_patches(const std::vector<Face>& added, const Patches& patches)
  {
    std::size_t i = 0;
    for (const Face_index f : m_mesh.faces())
      put(m_constraints.face_patch, added[i++], patches[m_mesh.input_face(f)]);
  }

  // At a manifold vertex there is one border halfedge that leaves it, beyond the faces about it. It is the vertex's own, as
  // in a mesh that CGAL builds.
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
  const VertexPointMap m_vpm;
  const Constraints& m_constraints;
  std::vector<Vertex> m_vertices;
  std::vector<Halfedge> m_halfedges;        // of the caller's mesh, by those of the working mesh
  std::vector<Vertex_index> m_new_vertices; // what the caller's mesh does not have yet
  std::vector<Edge_index> m_new_edges;
  std::vector<Face_index> m_new_faces;
  std::vector<Halfedge> m_border; // whose next halfedge may be another one in the end
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_STORE_MESH_H
