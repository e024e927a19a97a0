// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_WORKING_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_WORKING_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/folded_edge.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the index types of any Surface_mesh
typedef SM_Vertex_index Vertex_index;
typedef SM_Halfedge_index Halfedge_index;
typedef SM_Edge_index Edge_index;
typedef SM_Face_index Face_index;

// A vertex as the operations see it. The normal is the unit vector in the direction of the function's gradient. The size of 64
// bytes matters, because sweeps read many vertices.
struct Vertex_state
{
  static constexpr std::uint32_t no_vertex = (std::numeric_limits<std::uint32_t>::max)();

  Vector point = Vector::Zero();
  Vector normal = Vector::Zero();
  double last_step = 0;                   // of the projection; the distance to the surface that is left is quadratic in it
  std::uint32_t input_vertex = no_vertex; // its number in the input, if it comes from there
  bool is_on_curve = false;               // the vertex stays on a boundary or on constrained edges
  bool is_fixed = false;                  // neither moved nor removed
  bool is_on_crease = false;              // between regions, with a state for each of them
  bool is_on_input = false;               // the function led nowhere; the normal is that of the input

  // whether it was put where the surface is expected, without an evaluation of the function
  bool is_predicted() const { return std::isinf(last_step); }
  void set_predicted() { last_step = std::numeric_limits<double>::infinity(); }
};

// Surface_mesh declares its own input and output, and these need operators for its points. Nothing here uses them.
inline std::ostream& operator<<(std::ostream& out, const Vertex_state& v) { return out << v.point.transpose(); }
inline std::istream& operator>>(std::istream& in, Vertex_state& v) { return in >> v.point[0] >> v.point[1] >> v.point[2]; }

// a vertex with the data that the embedding keeps there; there may be none
template <typename Vertex_data>
struct Embedded_vertex : Vertex_state, Vertex_data
{
};

// A vertex on a crease as the faces of one region see it: the point is that of the vertex, the normal that of the region.
template <typename Vertex>
struct Crease_side
{
  Region region;
  Vertex vertex;
};

// The part of a curve along which a halfedge runs, by arc lengths from the beginning of the curve. They decrease if the
// halfedge runs against the curve. On a closed curve they go on past its beginning without a jump.
struct Curve_arc
{
  static constexpr int none = -1;        // the edge lies on no curve
  static constexpr int untouchable = -2; // the edge and its ends stay as they are
  static constexpr int unnamed = 0;      // until the curves are traced

  int curve = none;
  double source = 0, target = 0;

  Curve_arc reversed() const { return Curve_arc{curve, target, source}; }
};

// The mesh that is modified: a copy of the caller's mesh of whatever type. So the caller's mesh is untouched until the end. Nor
// does the result depend on how the caller's mesh numbers and recycles its elements. An edge knows its arc. A face knows from
// which face of the input it comes, and is in the patch and the region of that face. `state(v, h)` is the vertex v as the face
// of h sees it. It differs from `point(v)` on creases only.
template <typename Vertex_data>
class Working_mesh : public CGAL::Surface_mesh<Embedded_vertex<Vertex_data>>
{
public:
  typedef Embedded_vertex<Vertex_data> Vertex;
  typedef CGAL::Surface_mesh<Vertex> Graph;
  typedef std::vector<Crease_side<Vertex>> Sides;

  Working_mesh() { find_properties(); }
  Working_mesh(const Working_mesh&) = delete;
  Working_mesh& operator=(const Working_mesh& other)
  {
    if (this == &other)
      return *this;
    Graph::operator=(other);
    m_input_regions = other.m_input_regions;
    find_properties();
    return *this;
  }
  // not noexcept: looking the properties up allocates
  Working_mesh& operator=(Working_mesh&& other) // NOLINT(performance-noexcept-move-constructor)
  {
    Graph::operator=(std::move(other));
    m_input_regions = std::move(other.m_input_regions);
    find_properties();
    return *this;
  }

  // the type that functions on graphs take
  Graph& graph() { return *this; }
  const Graph& graph() const { return *this; }

  using Graph::edge;
  using Graph::opposite;

  bool is_on_curve(const Edge_index e) const { return m_arcs[e].curve != Curve_arc::none; }

  Curve_arc arc(const Halfedge_index h) const
  {
    const Curve_arc& arc = m_arcs[edge(h)];
    return is_first(h) ? arc : arc.reversed();
  }

  void set_arc(const Halfedge_index h, const Curve_arc& arc) { m_arcs[edge(h)] = is_first(h) ? arc : arc.reversed(); }

  std::size_t input_face(const Face_index f) const { return m_input_faces[f]; }
  void set_input_face(const Face_index f, const std::size_t input_face) { m_input_faces[f] = input_face; }

  // the regions of the faces of the input; empty if there is only one region
  const std::vector<Region>& input_regions() const { return m_input_regions; }
  void set_input_regions(std::vector<Region> regions) { m_input_regions = std::move(regions); }

  // of the face of h; if h is on the border, of the face on its other side
  Region region(const Halfedge_index h) const
  {
    if (m_input_regions.empty())
      return 0;
    return m_input_regions[m_input_faces[this->face(this->is_border(h) ? opposite(h) : h)]];
  }

  const Vertex& state(const Vertex_index v, const Halfedge_index h) const
  {
    const Vertex& vertex = this->point(v);
    return vertex.is_on_crease ? side(m_sides[v], region(h)) : vertex;
  }

  // the sides of a vertex on a crease, by increasing region; `point(v)` is the same as the vertex of the first one
  const Sides& sides(const Vertex_index v) const { return m_sides[v]; }
  Sides& sides(const Vertex_index v) { return m_sides[v]; }

  static const Vertex& side(const Sides& sides, const Region region)
  {
    const auto side = std::find_if(sides.begin(), sides.end(), [&](const auto& s) { return s.region == region; });
    CGAL_assertion(side != sides.end());
    return side->vertex;
  }

  // gives the vertices between regions their sides
  void mark_creases()
  {
    std::vector<Region> regions;
    for (const Vertex_index v : this->vertices())
    {
      regions.clear();
      for (const Halfedge_index h : this->halfedges_around_target(this->halfedge(v)))
        if (!this->is_border(h))
          regions.push_back(region(h));
      std::sort(regions.begin(), regions.end());
      regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
      if (regions.size() < 2)
        continue;
      this->point(v).is_on_crease = true;
      for (const Region r : regions)
        m_sides[v].push_back(Crease_side<Vertex>{r, this->point(v)});
    }
  }

private:
  // Whether h has the direction in which its edge stores the arc. An Edge_index does not tell a direction: it remembers the
  // halfedge from which it was made.
  bool is_first(const Halfedge_index h) const { return h < opposite(h); }

  void find_properties()
  {
    m_arcs = this->template add_property_map<Edge_index, Curve_arc>("e:curve_arc").first;
    m_input_faces = this->template add_property_map<Face_index, std::size_t>("f:input_face").first;
    m_sides = this->template add_property_map<Vertex_index, Sides>("v:sides").first;
  }

  typename Graph::template Property_map<Edge_index, Curve_arc> m_arcs;
  typename Graph::template Property_map<Face_index, std::size_t> m_input_faces;
  typename Graph::template Property_map<Vertex_index, Sides> m_sides;
  std::vector<Region> m_input_regions;
};

// The sizes of vectors that are indexed by vertices, edges or faces. Removed elements have places in them too.
template <typename Mesh>
std::size_t vertex_capacity(const Mesh& mesh)
{
  return mesh.num_vertices();
}
template <typename Mesh>
std::size_t edge_capacity(const Mesh& mesh)
{
  return mesh.num_edges();
}
template <typename Mesh>
std::size_t face_capacity(const Mesh& mesh)
{
  return mesh.num_faces();
}

// the three vertices of the face of a halfedge that is not on the border
struct Triangle
{
  Vertex_index a, b, c;

  template <typename Mesh>
  Triangle(const Halfedge_index h, const Mesh& mesh) : a(mesh.source(h)), b(mesh.target(h)), c(mesh.target(mesh.next(h)))
  {
  }
};

// the three vertices as that face sees them
template <typename Mesh>
struct Corners
{
  const typename Mesh::Vertex &a, &b, &c;

  Corners(const Triangle& t, const Halfedge_index h, const Mesh& mesh)
    : a(mesh.state(t.a, h)), b(mesh.state(t.b, h)), c(mesh.state(t.c, h))
  {
  }
  Corners(const Halfedge_index h, const Mesh& mesh) : Corners(Triangle(h, mesh), h, mesh) {}
};

// The squared length of an edge in the embedding. An edge between two regions has a length in each; the larger one counts.
template <typename Mesh, typename Embedding>
double squared_length(const Edge_index e, const Mesh& mesh, const Embedding& embedding)
{
  const Halfedge_index h = mesh.halfedge(e), g = mesh.opposite(h);
  const Vertex_index u = mesh.source(h), v = mesh.target(h);
  const double length = embedding.squared_length(mesh.state(u, h), mesh.state(v, h));
  if (!mesh.point(u).is_on_crease || !mesh.point(v).is_on_crease)
    return length;
  return (std::max)(length, embedding.squared_length(mesh.state(u, g), mesh.state(v, g)));
}

// of an edge in space
template <typename Mesh>
double squared_length(const Halfedge_index h, const Mesh& mesh)
{
  return (mesh.point(mesh.source(h)).point - mesh.point(mesh.target(h)).point).squaredNorm();
}

template <typename Mesh>
Vector middle(const Halfedge_index h, const Mesh& mesh)
{
  return (mesh.point(mesh.source(h)).point + mesh.point(mesh.target(h)).point) / 2;
}

// a point of the mesh, as an origin near all others
template <typename Mesh>
Vector first_point(const Mesh& mesh)
{
  return mesh.number_of_vertices() > 0 ? mesh.point(*mesh.vertices().begin()).point : Vector(Vector::Zero());
}

// as `triangle_normal()`
inline Vector face_normal(const Vertex_state& a, const Vertex_state& b, const Vertex_state& c)
{
  return triangle_normal(b.point - a.point, c.point - a.point);
}

template <typename Mesh>
Vector face_normal(const Halfedge_index h, const Mesh& mesh)
{
  const Triangle t(h, mesh);
  return face_normal(mesh.point(t.a), mesh.point(t.b), mesh.point(t.c));
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_WORKING_MESH_H
