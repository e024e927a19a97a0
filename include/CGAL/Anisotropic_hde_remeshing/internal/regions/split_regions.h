// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_SPLIT_REGIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_SPLIT_REGIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

typedef Surface_mesh<Simple_cartesian<double>::Point_3> Region_mesh;

// the number of regions; they must be numbered from 0 on without a gap
template <typename FaceGraph, typename FaceRegionMap>
std::size_t checked_number_of_regions(const FaceGraph& mesh, const FaceRegionMap face_region)
{
  std::vector<bool> has_face;
  for (const auto f : faces(mesh))
  {
    const std::size_t region = std::size_t(get(face_region, f));
    if (region >= num_faces(mesh))
      throw_invalid_argument("the number of a region", region,
                             "less than the number of faces, " + std::to_string(num_faces(mesh)));
    if (region >= has_face.size())
      has_face.resize(region + 1, false);
    has_face[region] = true;
  }
  for (std::size_t i = 0; i < has_face.size(); ++i)
    if (!has_face[i])
      throw_invalid_argument("the number of regions", has_face.size(),
                             "such that each has a face, but region " + std::to_string(i) + " has none");
  if (has_face.empty())
    throw std::invalid_argument("the input has no faces");
  return has_face.size();
}

// The regions as meshes of their own. (CGAL's Face_filtered_graph takes no faces that touch in a vertex only.) Where a region touches itself in a vertex, each of its fans there gets its own vertex. So
// the meshes are manifold.
template <typename FaceGraph, typename VertexPointMap, typename FaceRegionMap>
std::vector<Region_mesh> split_regions(const FaceGraph& mesh, const VertexPointMap vpm, const FaceRegionMap face_region,
                                       Interruption& interruption)
{
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  const std::size_t number_of_regions = checked_number_of_regions(mesh, face_region);
  // the corner of the face of a halfedge at its target
  const auto corner = get(dynamic_halfedge_property_t<std::size_t>(), mesh);
  std::size_t number_of_corners = 0;
  for (const Halfedge h : halfedges(mesh))
    put(corner, h, number_of_corners++);
  Disjoint_sets same_vertex(number_of_corners);
  const auto region_of = [&](const Halfedge h) { return std::size_t(get(face_region, face(h, mesh))); };
  for (const auto e : edges(mesh))
  {
    interruption.check();
    const Halfedge h = halfedge(e, mesh), o = opposite(h, mesh);
    if (is_border(e, mesh) || region_of(h) != region_of(o))
      continue;
    same_vertex.union_set(get(corner, h), get(corner, prev(o, mesh)));
    same_vertex.union_set(get(corner, o), get(corner, prev(h, mesh)));
  }

  const auto index = get(dynamic_vertex_property_t<std::size_t>(), mesh); // for messages
  std::size_t number_of_vertices = 0;
  for (const auto v : vertices(mesh))
    put(index, v, number_of_vertices++);
  std::vector<Region_mesh> result(number_of_regions);
  std::vector<Region_mesh::Vertex_index> new_vertices(number_of_corners);
  std::vector<Region_mesh::Vertex_index> face_vertices;
  for (const auto f : faces(mesh))
  {
    interruption.check();
    Region_mesh& region = result[region_of(halfedge(f, mesh))];
    face_vertices.clear();
    for (const Halfedge h : halfedges_around_face(halfedge(f, mesh), mesh))
    {
      Region_mesh::Vertex_index& v = new_vertices[same_vertex.find_set(get(corner, h))];
      if (v == Region_mesh::null_vertex())
      {
        const Vector p = finite_vector(value_of(vpm, target(h, mesh)), "point", get(index, target(h, mesh)));
        v = region.add_vertex(Region_mesh::Point(p[0], p[1], p[2]));
      }
      face_vertices.push_back(v);
    }
    region.add_face(face_vertices);
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_SPLIT_REGIONS_H
