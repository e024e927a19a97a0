// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_MEASURED_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_MEASURED_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/folded_edge.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/named_parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A triangle mesh in arrays: what all measures need, read from any face graph in one pass. Isolated vertices are only
// counted; the others are numbered in the order of `vertices()`.
struct Measured_mesh
{
  std::vector<Vector> points;
  std::vector<char> is_on_boundary;  // a vertex, as `points`; no vector<bool>, which threads cannot share
  std::vector<std::size_t> valences; // a vertex
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<char> is_degenerate; // a face, by the exact predicate of the kernel
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::size_t number_of_isolated_vertices = 0;
  std::size_t number_of_boundary_edges = 0;
  std::size_t number_of_boundary_loops = 0;

  Vector normal(const std::size_t f) const // of the length of twice the area
  {
    const std::array<std::size_t, 3>& v = faces[f];
    return (points[v[1]] - points[v[0]]).cross(points[v[2]] - points[v[0]]);
  }

  // as `triangle_normal()`, in a unit of length
  Vector normal_in_unit(const std::size_t f, const double unit) const
  {
    const std::array<std::size_t, 3>& v = faces[f];
    return triangle_normal((points[v[1]] - points[v[0]]) / unit, (points[v[2]] - points[v[0]]) / unit);
  }

  double diagonal() const // of the bounding box
  {
    if (points.empty())
      return 0;
    Vector low = points.front(), high = points.front();
    for (const Vector& p : points)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return (high - low).stableNorm();
  }
};

// the steps of `read_measured_mesh()`
template <typename TriangleMesh, typename VertexPointMap>
class Mesh_reader
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  // not the internal indices: those of a mesh with removed elements have gaps
  typedef typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<std::size_t>>::const_type Index_map;
  typedef typename boost::property_map<TriangleMesh, dynamic_halfedge_property_t<bool>>::const_type Visited_map;

public:
  Mesh_reader(const TriangleMesh& mesh, const VertexPointMap& point_map)
    : m_mesh(mesh), m_point_map(point_map), m_indices(get(dynamic_vertex_property_t<std::size_t>(), mesh))
  {
  }

  template <typename GeomTraits>
  Measured_mesh read(const GeomTraits& traits)
  {
    read_vertices();
    read_edges();
    read_faces(traits);
    count_boundary_loops();
    return std::move(m_result);
  }

private:
  void read_vertices()
  {
    for (const vertex_descriptor v : vertices(m_mesh))
    {
      if (halfedge(v, m_mesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
      {
        ++m_result.number_of_isolated_vertices;
        continue;
      }
      put(m_indices, v, m_result.points.size());
      const auto& p = get(m_point_map, v);
      m_result.points.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
    }
    m_result.is_on_boundary.assign(m_result.points.size(), 0);
    m_result.valences.assign(m_result.points.size(), 0);
  }

  void read_edges()
  {
    for (const edge_descriptor e : edges(m_mesh))
    {
      const halfedge_descriptor h = halfedge(e, m_mesh);
      const std::size_t a = get(m_indices, source(h, m_mesh)), b = get(m_indices, target(h, m_mesh));
      m_result.edges.emplace_back(a, b);
      ++m_result.valences[a];
      ++m_result.valences[b];
      if (CGAL::is_border_edge(h, m_mesh))
      {
        ++m_result.number_of_boundary_edges;
        m_result.is_on_boundary[a] = m_result.is_on_boundary[b] = 1;
      }
    }
  }

  template <typename GeomTraits>
  void read_faces(const GeomTraits& traits)
  {
    const auto collinear = traits.collinear_3_object();
    for (const face_descriptor f : faces(m_mesh))
    {
      const halfedge_descriptor h = halfedge(f, m_mesh);
      const vertex_descriptor a = source(h, m_mesh), b = target(h, m_mesh), c = target(next(h, m_mesh), m_mesh);
      m_result.faces.push_back({get(m_indices, a), get(m_indices, b), get(m_indices, c)});
      m_result.is_degenerate.push_back(collinear(get(m_point_map, a), get(m_point_map, b), get(m_point_map, c)));
    }
  }

  void count_boundary_loops()
  {
    Visited_map visited = get(dynamic_halfedge_property_t<bool>(), m_mesh);
    for (const halfedge_descriptor h : halfedges(m_mesh))
      put(visited, h, false);
    for (const halfedge_descriptor start : halfedges(m_mesh))
    {
      if (!CGAL::is_border(start, m_mesh) || get(visited, start))
        continue;
      ++m_result.number_of_boundary_loops;
      for (halfedge_descriptor h = start; !get(visited, h); h = next(h, m_mesh))
        put(visited, h, true);
    }
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_point_map;
  Index_map m_indices;
  Measured_mesh m_result;
};

template <typename TriangleMesh, typename NamedParameters>
Measured_mesh read_measured_mesh(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;

  CGAL_precondition_msg(is_triangle_mesh(tmesh), "the measures are of a triangle mesh");
  const Geom_traits traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  const Vertex_point_map point_map =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
  return Mesh_reader<TriangleMesh, Vertex_point_map>(tmesh, point_map).read(traits);
}

// R / (2 r) of a triangle of three points that are not collinear: 1 for the equilateral one
inline double aspect_ratio(const Vector& p, const Vector& q, const Vector& r)
{
  // Edges relative to the longest, so that no product overflows or vanishes whatever the unit of the mesh. The cross
  // product of the two shorter ones is the one with the least cancellation.
  std::array<Vector, 3> sides = {q - p, r - q, p - r};
  const double scale = (std::max)({sides[0].norm(), sides[1].norm(), sides[2].norm()});
  if (!(scale > 0))
    return std::numeric_limits<double>::infinity();
  std::array<double, 3> lengths;
  for (int i = 0; i < 3; ++i)
  {
    sides[i] /= scale;
    lengths[i] = sides[i].norm();
  }
  const int longest = lengths[0] >= lengths[1] ? (lengths[0] >= lengths[2] ? 0 : 2) : (lengths[1] >= lengths[2] ? 1 : 2);
  const double squared_area_4 = sides[(longest + 1) % 3].cross(sides[(longest + 2) % 3]).squaredNorm(); // 4 A^2
  if (!(squared_area_4 > 0))
    return std::numeric_limits<double>::infinity();
  return lengths[0] * lengths[1] * lengths[2] * (lengths[0] + lengths[1] + lengths[2]) / (4 * squared_area_4);
}

// the least angle, in degrees, of a triangle given by the squares of its side lengths
inline double minimum_angle(double a, double b, double c)
{
  if (a > b)
    std::swap(a, b);
  if (a > c)
    std::swap(a, c); // it lies opposite to the shortest side
  if (!(a > 0))
    return 0;
  const double cosine = (b + c - a) / (2 * std::sqrt(b) * std::sqrt(c));
  return std::acos((std::max)(-1., (std::min)(1., cosine))) * 180 / CGAL_PI;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_MEASURED_MESH_H
