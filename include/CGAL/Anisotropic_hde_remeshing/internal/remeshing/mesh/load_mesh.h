// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_LOAD_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_LOAD_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Where the elements of the working mesh come from, and what the faces of the input look like.
template <typename TriangleMesh>
struct Mesh_origin
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

  std::vector<typename Graph_traits::vertex_descriptor> vertices; // by Vertex_state::input_vertex
  std::vector<typename Graph_traits::face_descriptor> faces;      // the remeshed ones, by Working_mesh::input_face()
  std::vector<std::size_t> face_positions;                        // among all faces of the input
  std::vector<Facet> facets;                                      // their vertices, rotated so that the smallest comes first
  std::size_t number_of_isolated_vertices = 0;
  double diagonal = 0; // of the box about the whole input
  double unit = 1;     // of the copy: a power of two; the diagonal in this unit is at least a half and less than one
};

// Copies all or some faces of the caller's mesh. The copy has a unit of its own, so that products of lengths neither overflow
// nor vanish. Where copied faces touch in a vertex only, the copy has a vertex for each side.
template <typename TriangleMesh, typename VertexPointMap, typename Constraints, typename Mesh>
class Mesh_loader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor Vertex;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::face_descriptor Face;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

public:
  Mesh_loader(const TriangleMesh& tmesh, const VertexPointMap vpm, const Constraints& constraints, Interruption& interruption)
    : m_tmesh(tmesh), m_vpm(vpm), m_constraints(constraints), m_interruption(interruption)
  {
  }

  // Throws Interrupted. Throws std::invalid_argument if the faces are not a manifold mesh of triangles with finite coordinates,
  // or if there are none. Throws std::length_error if there are too many.
  template <typename FaceRange>
  Mesh_origin<TriangleMesh> operator()(const FaceRange& range, Mesh& mesh)
  {
    check_manifold();
    select(range);
    check_size();
    add_vertices(mesh);
    add_faces(mesh);
    mark_curves(mesh);
    return std::move(m_origin);
  }

private:
  void check_manifold() const
  {
    std::vector<Halfedge> cones;
    Polygon_mesh_processing::non_manifold_vertices(m_tmesh, std::back_inserter(cones));
    if (cones.empty())
      return;
    std::size_t position = 0;
    for (const Vertex v : vertices(m_tmesh))
      if (v == target(cones.front(), m_tmesh))
        throw std::invalid_argument("vertex " + std::to_string(position) + " is not manifold: its faces touch in it only");
      else
        ++position;
  }

  template <typename FaceRange>
  void select(const FaceRange& range)
  {
    for (const Face f : faces(m_tmesh))
      put(m_is_selected, f, false);
    for_each_of_range(range, [this](const Face f) { put(m_is_selected, f, true); });
    std::size_t position = 0;
    for (const Face f : faces(m_tmesh))
    {
      if (get(m_is_selected, f))
      {
        check_triangle(halfedge(f, m_tmesh), m_tmesh, position);
        m_origin.faces.push_back(f);
        m_origin.face_positions.push_back(position);
      }
      ++position;
    }
    if (m_origin.faces.empty())
      throw std::invalid_argument("there are no faces to remesh");
  }

  // counts three halfedges for each face, and those of the boundary
  void check_size() const
  {
    std::size_t number = 3 * m_origin.faces.size();
    if (2 * number <= largest_number_of_halfedges)
      return;
    for (const Face f : m_origin.faces)
      for (const Halfedge h : halfedges_around_face(halfedge(f, m_tmesh), m_tmesh))
        number += is_selected(opposite(h, m_tmesh)) ? 0 : 1;
    check_number_of_halfedges(number);
  }

  bool is_selected(const Halfedge h) const { return !is_border(h, m_tmesh) && get(m_is_selected, face(h, m_tmesh)); }

  void add_vertices(Mesh& mesh)
  {
    for (const Halfedge h : halfedges(m_tmesh))
      put(m_vertex_of, h, none);
    Vector low = Vector::Constant((std::numeric_limits<double>::max)()), high = -low;
    std::size_t position = 0;
    for (const Vertex v : vertices(m_tmesh))
    {
      m_interruption.check();
      const std::size_t this_position = position++;
      if (halfedge(v, m_tmesh) == Graph_traits::null_halfedge())
      {
        ++m_origin.number_of_isolated_vertices;
        continue;
      }
      const Vector point = finite_vector(value_of(m_vpm, v), "point", this_position);
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
      for (const Halfedge h : halfedges_around_target(v, m_tmesh))
        if (is_selected(h) && get(m_vertex_of, h) == none)
          add_vertex(h, point, mesh);
    }
    m_origin.diagonal = (high - low).stableNorm();
    if (!(m_origin.diagonal > 0))
      throw std::invalid_argument("all points of the mesh are equal");
    int exponent = 0;
    std::frexp(m_origin.diagonal, &exponent);
    m_origin.unit = std::ldexp(1., (std::max)(exponent, -1000));
    for (const Vertex_index v : mesh.vertices())
      mesh.point(v).point /= m_origin.unit;
  }

  // Adds a vertex that stands for the target of h in a fan of selected faces around it. The fan goes from the face of h to both
  // sides, up to the first face that is not selected.
  void add_vertex(const Halfedge h, const Vector& point, Mesh& mesh)
  {
    const Vertex v = target(h, m_tmesh);
    typename Mesh::Vertex state;
    state.point = point;
    state.is_fixed = get(m_constraints.vertex_is_constrained, v);
    state.input_vertex = std::uint32_t(m_origin.vertices.size());
    const std::size_t index = mesh.add_vertex(state);
    m_origin.vertices.push_back(v);
    for (Halfedge g = h; is_selected(g) && get(m_vertex_of, g) == none; g = opposite(next(g, m_tmesh), m_tmesh))
      put(m_vertex_of, g, index);
    for (Halfedge g = opposite(h, m_tmesh); is_selected(g) && get(m_vertex_of, prev(g, m_tmesh)) == none;
         g = opposite(prev(g, m_tmesh), m_tmesh))
      put(m_vertex_of, prev(g, m_tmesh), index);
  }

  void add_faces(Mesh& mesh)
  {
    mesh.reserve(mesh.num_vertices(), mesh.num_vertices() + m_origin.faces.size(), m_origin.faces.size());
    for (std::size_t i = 0; i < m_origin.faces.size(); ++i)
    {
      m_interruption.check();
      const Halfedge h = halfedge(m_origin.faces[i], m_tmesh);
      Facet facet{get(m_vertex_of, prev(h, m_tmesh)), get(m_vertex_of, h), get(m_vertex_of, next(h, m_tmesh))};
      std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
      m_origin.facets.push_back(facet);
      const Face_index added = mesh.add_face(vertex_index(facet[0]), vertex_index(facet[1]), vertex_index(facet[2]));
      if (added == Mesh::null_face())
        throw std::invalid_argument("face " + std::to_string(m_origin.face_positions[i]) +
                                    " is on a non-manifold edge or vertex");
      mesh.set_input_face(added, i);
    }
  }

  static Vertex_index vertex_index(const std::size_t i) { return Vertex_index(static_cast<Vertex_index::size_type>(i)); }

  // Marks the boundary, the constrained edges, the creases, and the edges between two patches. Edges to faces that are not
  // selected are marked as untouchable.
  void mark_curves(Mesh& mesh) const
  {
    for (std::size_t i = 0; i < m_origin.faces.size(); ++i)
    {
      Halfedge h = halfedge(m_origin.faces[i], m_tmesh);
      for (int k = 0; k < 3; ++k, h = next(h, m_tmesh))
      {
        Curve_arc arc;
        arc.curve = mark(h);
        if (arc.curve == Curve_arc::none)
          continue;
        const Vertex_index from = vertex_index(get(m_vertex_of, prev(h, m_tmesh))), to = vertex_index(get(m_vertex_of, h));
        mesh.set_arc(mesh.halfedge(from, to), arc);
      }
    }
  }

  int mark(const Halfedge h) const
  {
    const Halfedge g = opposite(h, m_tmesh);
    const bool is_boundary = is_border(g, m_tmesh);
    if (!is_boundary && !is_selected(g))
      return Curve_arc::untouchable;
    if (!is_boundary && !is_constrained(h))
      return Curve_arc::none;
    return m_constraints.protect_constraints ? Curve_arc::untouchable : Curve_arc::unnamed;
  }

  bool is_constrained(const Halfedge h) const
  {
    const auto e = edge(h, m_tmesh);
    const Face f = face(h, m_tmesh), g = face(opposite(h, m_tmesh), m_tmesh);
    return get(m_constraints.edge_is_constrained, e) || m_constraints.creases.is_crease(e) ||
           !(get(m_constraints.face_patch, f) == get(m_constraints.face_patch, g)) ||
           m_constraints.creases.region(f) != m_constraints.creases.region(g);
  }

  const TriangleMesh& m_tmesh;
  const VertexPointMap m_vpm;
  const Constraints& m_constraints;
  Interruption& m_interruption;
  Mesh_origin<TriangleMesh> m_origin;
  typename boost::property_map<TriangleMesh, dynamic_face_property_t<bool>>::const_type m_is_selected{
      get(dynamic_face_property_t<bool>(), m_tmesh)};
  // by halfedge: the vertex of the copy that stands for its target in its face
  typename boost::property_map<TriangleMesh, dynamic_halfedge_property_t<std::size_t>>::const_type m_vertex_of{
      get(dynamic_halfedge_property_t<std::size_t>(), m_tmesh)};
};

template <typename TriangleMesh, typename FaceRange, typename VertexPointMap, typename Constraints, typename Mesh>
Mesh_origin<TriangleMesh> load_mesh(const TriangleMesh& tmesh, const FaceRange& range, const VertexPointMap vpm,
                                    const Constraints& constraints, Interruption& interruption, Mesh& mesh)
{
  return Mesh_loader<TriangleMesh, VertexPointMap, Constraints, Mesh>(tmesh, vpm, constraints, interruption)(range, mesh);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_LOAD_MESH_H
