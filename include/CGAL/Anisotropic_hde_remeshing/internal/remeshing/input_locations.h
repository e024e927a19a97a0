// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_LOCATIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_LOCATIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Input_location.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/closest_on_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/first_halfedges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/load_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

inline Input_location corner_of_face(const std::size_t face, const std::size_t corner)
{
  Input_location result;
  result.face = face;
  result.barycentric_coordinates = {{0, 0, 0}};
  result.barycentric_coordinates[corner] = 1;
  return result;
}

// The closest point of the facets of the input. If all are degenerate, the search tree has none: then each is looked at.
inline Closest_facet::Answer closest_on_input(const Vector& p, const Input_surface& input)
{
  if (!input.empty())
    return input.closest(p);
  Closest_facet::Answer result{0, p, Vector(1, 0, 0)};
  double least = (std::numeric_limits<double>::infinity)();
  for (std::size_t k = 0; k < input.facets().size(); ++k)
  {
    const Facet& facet = input.facets()[k];
    const Closest_on_triangle closest =
        closest_on_triangle(p, input.points()[facet[0]], input.points()[facet[1]], input.points()[facet[2]]);
    if (!(closest.squared_distance < least))
      continue;
    least = closest.squared_distance;
    result.facet = k;
    result.barycentric = closest.barycentric;
  }
  return result;
}

// The locations on the input, by the vertices of the working mesh. Fixed vertices are corners of a facet of their own: another
// part of the surface may touch it.
template <typename ConcurrencyTag, typename Mesh, typename TriangleMesh>
std::vector<Input_location> locations_on_input(const Mesh& mesh, const Input_surface& input,
                                               const Mesh_origin<TriangleMesh>& origin)
{
  std::vector<Input_location> corners(origin.vertices.size()); // by the vertices of the input
  for (std::size_t k = 0; k < origin.facets.size(); ++k)
    for (std::size_t corner = 0; corner < 3; ++corner)
      if (!corners[origin.facets[k][corner]].has_face())
        corners[origin.facets[k][corner]] = corner_of_face(origin.face_positions[k], corner);

  std::vector<Input_location> result(vertex_capacity(mesh));
  parallel_for<ConcurrencyTag>(
      result.size(),
      [&](const std::size_t i)
      {
        const Vertex_index v(static_cast<Vertex_index::size_type>(i));
        if (mesh.is_removed(v))
          return;
        if (mesh.point(v).is_fixed)
        {
          result[i] = corners[mesh.point(v).input_vertex];
          return;
        }
        const Closest_facet::Answer closest = closest_on_input(mesh.point(v).point, input);
        result[i].face = origin.face_positions[closest.facet];
        for (int k = 0; k < 3; ++k)
          result[i].barycentric_coordinates[std::size_t(k)] = closest.barycentric[k];
      },
      64);
  return result;
}

template <typename TriangleMesh>
using Located_vertices = std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, Input_location>>;

// The vertices of the caller's mesh that have no part in the remeshing, and where they are: at a corner of one of their faces. All
// vertices but `loaded` have no part.
template <typename TriangleMesh>
Located_vertices<TriangleMesh>
locations_of_rest(const TriangleMesh& tmesh,
                  const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& loaded)
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  const auto number = get(dynamic_vertex_property_t<std::size_t>(), tmesh);
  for (const auto v : vertices(tmesh))
    put(number, v, std::size_t(0));
  for (const auto v : loaded)
    put(number, v, none);
  Located_vertices<TriangleMesh> result;
  for (const auto v : vertices(tmesh))
    if (get(number, v) != none)
    {
      put(number, v, result.size());
      result.emplace_back(v, Input_location());
    }
  std::size_t face = 0;
  for (auto h : first_halfedges(tmesh))
  {
    for (std::size_t corner = 0; corner < 3; ++corner, h = next(h, tmesh))
    {
      const std::size_t i = get(number, source(h, tmesh));
      if (i != none && !result[i].second.has_face())
        result[i].second = corner_of_face(face, corner);
    }
    ++face;
  }
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_INPUT_LOCATIONS_H
