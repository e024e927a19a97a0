// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MESH_REORDERER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MESH_REORDERER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Numbers the elements along a Hilbert curve, so that neighbours in space are neighbours in memory. On a mesh in random order,
// the operations wait for memory most of the time. Removed elements are dropped.
template <typename ConcurrencyTag, typename Mesh>
class Mesh_reorderer
{
public:
  Mesh_reorderer(Mesh& mesh, Interruption& interruption) : m_mesh(mesh), m_interruption(interruption) {}

  // Returns the new numbers of the faces by the old ones. Leaves the mesh as it is if it is interrupted, and returns nothing.
  std::vector<Face_index> operator()()
  {
    const auto steps = {&Mesh_reorderer::place_vertices, &Mesh_reorderer::connect_edges, &Mesh_reorderer::connect_faces,
                        &Mesh_reorderer::connect_halfedges};
    for (const auto step : steps)
    {
      (this->*step)();
      if (m_interruption.ask())
        return {};
    }
    m_ordered.set_input_regions(m_mesh.input_regions());
    m_mesh = std::move(m_ordered);
    return std::move(m_faces);
  }

private:
  void place_vertices()
  {
    typedef Simple_cartesian<double>::Point_3 Point_3;
    std::vector<std::pair<Point_3, Vertex_index>> points;
    for (const Vertex_index v : m_mesh.vertices())
    {
      const Vector& p = m_mesh.point(v).point;
      points.emplace_back(Point_3(p[0], p[1], p[2]), v);
    }
    typedef First_of_pair_property_map<std::pair<Point_3, Vertex_index>> Point_map;
    hilbert_sort<ConcurrencyTag>(points.begin(), points.end(),
                                 Spatial_sort_traits_adapter_3<Simple_cartesian<double>, Point_map>());
    if (m_interruption.ask())
      return;
    m_ordered.resize(m_mesh.number_of_vertices(), m_mesh.number_of_edges(), m_mesh.number_of_faces());
    m_vertices.resize(vertex_capacity(m_mesh));
    auto next = m_ordered.vertices().begin();
    for (const auto& point : points)
    {
      m_vertices[point.second] = *next++;
      m_ordered.point(m_vertices[point.second]) = m_mesh.point(point.second);
      m_ordered.sides(m_vertices[point.second]) = m_mesh.sides(point.second);
    }
  }

  // Sorts elements by `number(element)`, the smallest number of their vertices. So elements that follow each other are near
  // each other.
  template <typename Element, typename Elements, typename Number>
  std::vector<Element> in_order(const Elements& elements, const Number& number) const
  {
    // a counting sort
    std::vector<std::size_t> begin(m_ordered.number_of_vertices() + 1, 0);
    for (const Element e : elements)
      ++begin[number(e) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Element> result(begin.back());
    for (const Element e : elements)
      result[begin[number(e)]++] = e;
    return result;
  }

  void connect_edges()
  {
    const auto number = [&](const Edge_index e)
    { return std::size_t((std::min)(m_vertices[m_mesh.vertex(e, 0)], m_vertices[m_mesh.vertex(e, 1)])); };
    m_halfedges.resize(m_mesh.num_halfedges());
    auto next = m_ordered.edges().begin();
    for (const Edge_index e : in_order<Edge_index>(m_mesh.edges(), number))
    {
      if (m_interruption.poll())
        return;
      const Halfedge_index h = m_mesh.halfedge(e), g = m_mesh.opposite(h);
      m_halfedges[h] = m_ordered.halfedge(*next++);
      m_halfedges[g] = m_ordered.opposite(m_halfedges[h]);
      for (const Halfedge_index side : {h, g})
        m_ordered.set_target(m_halfedges[side], m_vertices[m_mesh.target(side)]);
      m_ordered.set_arc(m_halfedges[h], m_mesh.arc(h));
    }
    for (const Vertex_index v : m_mesh.vertices())
      m_ordered.set_halfedge(m_vertices[v], m_halfedges[m_mesh.halfedge(v)]);
  }

  void connect_faces()
  {
    const auto number = [&](const Face_index f)
    {
      const Triangle t(m_mesh.halfedge(f), m_mesh);
      return std::size_t((std::min)({m_vertices[t.a], m_vertices[t.b], m_vertices[t.c]}));
    };
    m_faces.resize(face_capacity(m_mesh));
    auto next = m_ordered.faces().begin();
    for (const Face_index f : in_order<Face_index>(m_mesh.faces(), number))
    {
      if (m_interruption.poll())
        return;
      const Face_index added = *next++;
      m_faces[f] = added;
      m_ordered.set_input_face(added, m_mesh.input_face(f));
      m_ordered.set_halfedge(added, m_halfedges[m_mesh.halfedge(f)]);
      for (const Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
        m_ordered.set_face(m_halfedges[h], added);
    }
  }

  void connect_halfedges()
  {
    for (const Halfedge_index h : m_mesh.halfedges())
    {
      if (m_interruption.poll())
        return;
      m_ordered.set_next(m_halfedges[h], m_halfedges[m_mesh.next(h)]);
    }
  }

  Mesh& m_mesh;
  Interruption& m_interruption;
  Mesh m_ordered;
  std::vector<Vertex_index> m_vertices;    // of the ordered mesh, by vertices of the mesh
  std::vector<Face_index> m_faces;         // of the ordered mesh, by faces of the mesh
  std::vector<Halfedge_index> m_halfedges; // of the ordered mesh, by halfedges of the mesh
};

template <typename ConcurrencyTag, typename Mesh>
std::vector<Face_index> reorder_in_space(Mesh& mesh, Interruption& interruption)
{
  return Mesh_reorderer<ConcurrencyTag, Mesh>{mesh, interruption}();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_MESH_REORDERER_H
