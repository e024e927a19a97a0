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

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/aspect_ratio.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/folded_edge.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
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

// A triangle mesh in arrays: what all measures need, read from any face graph in one pass. Isolated vertices are only counted.
// The others are numbered in the order of `vertices()`. With a piecewise function the mesh is cut along the creases: a vertex
// or an edge there is one for each region. A vertex on a crease counts as one of the boundary.
struct Measured_mesh
{
  std::vector<Vector> points;
  std::vector<char> is_on_boundary;  // a vertex, as `points`; no vector<bool>, which threads cannot share
  std::vector<std::size_t> valences; // a vertex
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<Region> point_regions, face_regions;
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
template <typename TriangleMesh, typename VertexPointMap, typename FaceRegionMap>
class Mesh_reader
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  // The internal indices would not do: those of a mesh with removed elements have gaps.
  typedef typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<std::size_t>>::const_type Index_map;
  typedef typename boost::property_map<TriangleMesh, dynamic_halfedge_property_t<bool>>::const_type Visited_map;

public:
  Mesh_reader(const TriangleMesh& mesh, const VertexPointMap& point_map, const FaceRegionMap& face_region)
    : m_mesh(mesh),
      m_point_map(point_map),
      m_face_region(face_region),
      m_indices(get(dynamic_vertex_property_t<std::size_t>(), mesh))
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
    std::size_t position = 0;
    for (const vertex_descriptor v : vertices(m_mesh))
    {
      const std::size_t this_position = position++;
      if (halfedge(v, m_mesh) == boost::graph_traits<TriangleMesh>::null_halfedge())
      {
        ++m_result.number_of_isolated_vertices;
        continue;
      }
      put(m_indices, v, m_result.points.size());
      const Vector point =
          finite_vector(value_of(m_point_map, v), "point", this_position, (std::numeric_limits<double>::infinity)());
      const std::vector<Region> regions = regions_around(v);
      for (const Region region : regions)
      {
        m_result.points.push_back(point);
        m_result.point_regions.push_back(region);
        m_result.is_on_boundary.push_back(regions.size() > 1);
      }
    }
    m_result.valences.assign(m_result.points.size(), 0);
  }

  std::vector<Region> regions_around(const vertex_descriptor v) const
  {
    std::vector<Region> regions;
    for (const halfedge_descriptor h : halfedges_around_target(v, m_mesh))
      if (!CGAL::is_border(h, m_mesh))
        regions.push_back(region(face(h, m_mesh)));
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    return regions;
  }

  Region region(const face_descriptor f) const { return static_cast<Region>(get(m_face_region, f)); }

  // the index of a vertex in a region
  std::size_t index(const vertex_descriptor v, const Region region) const
  {
    std::size_t i = get(m_indices, v);
    while (m_result.point_regions[i] != region)
      ++i;
    return i;
  }

  void read_edges()
  {
    for (const edge_descriptor e : edges(m_mesh))
    {
      const halfedge_descriptor h = halfedge(e, m_mesh), g = opposite(h, m_mesh);
      const bool is_border_of_h = CGAL::is_border(h, m_mesh), is_border_of_g = CGAL::is_border(g, m_mesh);
      m_result.number_of_boundary_edges += is_border_of_h || is_border_of_g ? 1 : 0;
      const Region region_of_h = region(face(is_border_of_h ? g : h, m_mesh)),
                   region_of_g = region(face(is_border_of_g ? h : g, m_mesh));
      add_edge(h, region_of_h, is_border_of_h || is_border_of_g);
      if (region_of_g != region_of_h)
        add_edge(h, region_of_g, false);
    }
  }

  void add_edge(const halfedge_descriptor h, const Region region, const bool is_boundary)
  {
    const std::size_t a = index(source(h, m_mesh), region), b = index(target(h, m_mesh), region);
    m_result.edges.emplace_back(a, b);
    for (const std::size_t v : {a, b})
    {
      ++m_result.valences[v];
      if (is_boundary)
        m_result.is_on_boundary[v] = 1;
    }
  }

  template <typename GeomTraits>
  void read_faces(const GeomTraits& traits)
  {
    const auto collinear = traits.collinear_3_object();
    std::size_t position = 0;
    for (const face_descriptor f : faces(m_mesh))
    {
      const halfedge_descriptor h = halfedge(f, m_mesh);
      check_triangle(h, m_mesh, position++);
      const vertex_descriptor a = source(h, m_mesh), b = target(h, m_mesh), c = target(next(h, m_mesh), m_mesh);
      const Region r = region(f);
      m_result.faces.push_back({index(a, r), index(b, r), index(c, r)});
      m_result.face_regions.push_back(r);
      m_result.is_degenerate.push_back(collinear(value_of(m_point_map, a), value_of(m_point_map, b), value_of(m_point_map, c)));
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
  FaceRegionMap m_face_region;
  Index_map m_indices; // of a vertex in the first of its regions
  Measured_mesh m_result;
};

// Throws std::invalid_argument if a face is not a triangle, or a coordinate is not finite.
template <typename TriangleMesh, typename NamedParameters, typename FaceRegionMap>
Measured_mesh read_measured_mesh(const TriangleMesh& tmesh, const NamedParameters& np, const FaceRegionMap& face_region)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;

  const Geom_traits traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  const Vertex_point_map point_map =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
  return Mesh_reader<TriangleMesh, Vertex_point_map, FaceRegionMap>(tmesh, point_map, face_region).read(traits);
}

template <typename TriangleMesh, typename NamedParameters>
Measured_mesh read_measured_mesh(const TriangleMesh& tmesh, const NamedParameters& np)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  return read_measured_mesh(tmesh, np, Static_boolean_property_map<face_descriptor, false>());
}

// The mesh is cut along the creases of a piecewise function. `face_patch_map` tells the regions of the faces.
template <typename Function, typename TriangleMesh, typename NamedParameters>
Measured_mesh read_measured_mesh_of(const Function&, const TriangleMesh& tmesh, const NamedParameters& np)
{
  if constexpr (is_piecewise<Function>)
  {
    static_assert(!parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value,
                  "a piecewise function needs face_patch_map, which tells the piece of each face");
    return read_measured_mesh(tmesh, np, parameters::get_parameter(np, internal_np::face_patch));
  }
  else
    return read_measured_mesh(tmesh, np);
}

// whether a mesh can be measured with these parameters; if not, an error of the compiler says what is wrong
template <typename TriangleMesh, typename NamedParameters>
constexpr bool accepts_measurement()
{
  if constexpr (accepts_mesh<TriangleMesh>())
    return accepts_parameters<Parameters_of_measures, TriangleMesh, NamedParameters>();
  else
    return false;
}

template <typename TriangleMesh, typename Function, typename NamedParameters>
constexpr bool accepts_measurement()
{
  if constexpr (accepts_function<Function>())
    return accepts_measurement<TriangleMesh, NamedParameters>();
  else
    return false;
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
