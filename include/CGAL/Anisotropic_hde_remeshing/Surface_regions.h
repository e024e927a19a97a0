// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_SURFACE_REGIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_SURFACE_REGIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Face_directions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/extend_darts.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/prune_creases.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingSharp
///
/// what `detect_surface_regions()` has found
struct Surface_regions
{
  std::size_t number_of_regions = 0;         ///< the parts of the surface between its creases and boundaries
  std::size_t number_of_crease_edges = 0;    ///< edges that are marked as creases
  std::size_t number_of_dropped_edges = 0;   ///< edges that are sharp by their angle, but taken for noise
  std::size_t number_of_extension_edges = 0; ///< edges that are not sharp, but continue creases that fade out
  std::size_t number_of_joined_specks = 0;   ///< regions of a few small faces that were joined to a neighbour
};

namespace internal {

// whether the types are accepted; if not, an error of the compiler says what is wrong
template <typename TriangleMesh, typename EdgeIsCreaseMap, typename FaceRegionMap, typename NamedParameters>
constexpr bool accepts_region_detection()
{
  if constexpr (!accepts_mesh<TriangleMesh>())
    return false;
  else
  {
    constexpr bool marks_edges = is_writable_map<EdgeIsCreaseMap, Edge_of<TriangleMesh>, bool>;
    static_assert(marks_edges, "edge_is_crease must be a writable property map from the edges of the mesh to bool");
    constexpr bool numbers_faces = is_writable_map<FaceRegionMap, Face_of<TriangleMesh>, std::size_t>;
    static_assert(numbers_faces, "face_region must be a writable property map from the faces of the mesh to std::size_t");
    return marks_edges && numbers_faces && accepts_parameters<Parameters_of_regions, TriangleMesh, NamedParameters>();
  }
}

// the sharp angle in degrees, 0 if none is given
template <typename NamedParameters>
double sharp_angle_parameter(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::sharp_angle_t>::value)
    return 0;
  else
  {
    const double angle = CGAL::to_double(parameters::get_parameter(np, internal_np::sharp_angle));
    if (!(angle > 0 && angle < 180))
      throw_invalid_argument("sharp_angle", angle, "more than 0 and less than 180 degrees");
    return angle;
  }
}

// the creases that the caller asks for: constrained edges, and edges between two patches
template <typename TriangleMesh, typename NamedParameters, typename EdgeIsCreaseMap>
void mark_edges_of_caller(const TriangleMesh& tmesh, const NamedParameters& np, const EdgeIsCreaseMap is_crease)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto is_constrained = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                               Static_boolean_property_map<typename Graph_traits::edge_descriptor, false>());
  const auto patch = choose_parameter(get_parameter(np, internal_np::face_patch),
                                      Static_boolean_property_map<typename Graph_traits::face_descriptor, false>());
  for (const auto e : edges(tmesh))
  {
    const auto h = halfedge(e, tmesh);
    put(is_crease, e,
        !is_border(e, tmesh) &&
            (get(is_constrained, e) || !(get(patch, face(h, tmesh)) == get(patch, face(opposite(h, tmesh), tmesh)))));
  }
}

// Marks the edges whose angle is at least `angle` in `is_crease`. Returns those that were not marked before. A face that is too
// thin to have a normal of its own is seen as part of a neighbour.
template <typename TriangleMesh, typename NamedParameters, typename Directions, typename EdgeIsCreaseMap>
std::vector<typename boost::graph_traits<TriangleMesh>::edge_descriptor>
mark_sharp_edges(const TriangleMesh& tmesh, const double angle, const NamedParameters& np, const Directions& directions,
                 const EdgeIsCreaseMap is_crease)
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor Edge;
  const auto is_sharp = get(dynamic_edge_property_t<bool>(), tmesh);
  for (const Edge e : edges(tmesh))
    put(is_sharp, e, false);
  Polygon_mesh_processing::detect_sharp_edges(tmesh, angle, is_sharp, np);
  std::vector<Edge> result;
  for (const Edge e : edges(tmesh))
  {
    if (is_border(e, tmesh) || get(is_crease, e))
      continue;
    const auto h = halfedge(e, tmesh);
    const bool is_thin = directions.is_thin(face(h, tmesh)) || directions.is_thin(face(opposite(h, tmesh), tmesh));
    if (is_thin ? directions.angle(e) < angle : !get(is_sharp, e))
      continue;
    put(is_crease, e, true);
    result.push_back(e);
  }
  return result;
}

// the regions between the creases, in the order of their first faces
template <typename TriangleMesh, typename EdgeIsCreaseMap, typename FaceRegionMap>
std::size_t number_regions(const TriangleMesh& tmesh, const EdgeIsCreaseMap is_crease, const FaceRegionMap region)
{
  const auto index = get(dynamic_face_property_t<std::size_t>(), tmesh);
  std::size_t next = 0;
  for (const auto f : faces(tmesh))
    put(index, f, next++);
  return Polygon_mesh_processing::connected_components(
      tmesh, region, CGAL::parameters::edge_is_constrained_map(is_crease).face_index_map(index));
}

template <typename TriangleMesh, typename VertexPointMap>
void check_points(const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  std::size_t index = 0;
  for (const auto v : vertices(tmesh))
  {
    if (halfedge(v, tmesh) != boost::graph_traits<TriangleMesh>::null_halfedge())
      finite_vector(value_of(vpm, v), "point", index);
    ++index;
  }
}

// Extends darts, and takes back the extensions that separate no regions. Returns how many edges it has marked.
template <typename TriangleMesh, typename Directions, typename EdgeRange, typename FaceRegionMap, typename EdgeIsCreaseMap>
std::size_t extend_darts(const TriangleMesh& tmesh, const Directions& directions, const double angle, const EdgeRange& sharp,
                         const FaceRegionMap region, const EdgeIsCreaseMap is_crease)
{
  number_regions(tmesh, is_crease, region);
  const auto extension = Dart_extension(tmesh, directions, angle)(region, sharp, is_crease);
  number_regions(tmesh, is_crease, region);
  std::size_t number = 0;
  for (const auto e : extension)
  {
    const auto h = halfedge(e, tmesh);
    const bool is_separating = get(region, face(h, tmesh)) != get(region, face(opposite(h, tmesh), tmesh));
    put(is_crease, e, is_separating);
    number += is_separating ? 1 : 0;
  }
  return number;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingSharp

finds the creases of a surface, the edges where it is not smooth, and the regions between them. These are the smooth pieces for
`CGAL::Piecewise_rbf_implicit_function`.

Creases are the edges that the caller constrains, the edges between two patches of the caller, and, if `sharp_angle` is given,
the edges at which the normals of the faces differ by at least this angle. A face has no reliable normal if its height is less
than 3 millionths of the size of the surface. Such a face is taken for a part of its neighbour across its longest edge.

<b>Noise</b> has sharp angles, too. Two kinds of noise are dropped from the edges that are creases by their angle only. The size
of the surface is the diagonal of the box about its connected component.
- A speck is a region of at most 8 faces that is smaller than 3% of the surface. It is joined to the neighbour behind its
  weakest edge.
- A dart is a set of connected creases with the same region on both sides. It is dropped if it is shorter than 8% of the
  surface.

<b>Extension.</b> A longer dart is extended from its tips to the next crease or boundary, along edges that are as sharp and as
few as can be. An edge as sharp as a crease costs a tenth of its length, a smooth one all of it. An extension may cost at most
half of the length of the dart. Extensions that do not separate regions are taken back.

The time is linear in the size of the mesh, except for sorting the creases by their angle. The result does not depend on the
position, the orientation or the unit of the mesh, except for rounding.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsCreaseMap a model of `WritablePropertyMap` with the edges of `tmesh` as keys and `bool` as values
\tparam FaceRegionMap a model of `WritablePropertyMap` with the faces of `tmesh` as keys and `std::size_t` as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh. Other faces than triangles are allowed. Isolated vertices are allowed and ignored.
\param edge_is_crease is set for every edge: whether it is a crease. A boundary edge is no crease. The map may be that of the
       constrained edges.
\param face_region is set for every face: the number of its region. Regions are numbered from 0 on in the order of their first
       faces. The map may be that of the patches.
\param np optional named parameters among the ones below

\cgalNamedParamsBegin
  \cgalParamNBegin{sharp_angle}
    \cgalParamDescription{the least angle between the normals of two faces, in degrees, at which their edge is a crease}
    \cgalParamType{a number of more than 0 and less than 180}
    \cgalParamDefault{no edge is a crease because of its angle}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{edges that are creases, whatever their angle}
    \cgalParamType{a model of `ReadablePropertyMap` with the edges of `tmesh` as keys and `bool` as values}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the patches of the faces: an edge between two patches is a crease}
    \cgalParamType{a model of `ReadablePropertyMap` with the faces of `tmesh` as keys and any values that can be compared by
                   `==`}
    \cgalParamDefault{all faces are in one patch}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{the kernel in which angles are compared}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{the kernel of the points}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the numbers of regions and edges

\throw std::invalid_argument if `sharp_angle` is out of its range, or a coordinate is not finite; the message names it
*/
template <typename TriangleMesh, typename EdgeIsCreaseMap, typename FaceRegionMap,
          typename NamedParameters = parameters::Default_named_parameters>
Surface_regions detect_surface_regions(const TriangleMesh& tmesh, EdgeIsCreaseMap edge_is_crease, FaceRegionMap face_region,
                                       const NamedParameters& np = parameters::default_values())
{
  if constexpr (!internal::accepts_region_detection<TriangleMesh, EdgeIsCreaseMap, FaceRegionMap, NamedParameters>())
    return Surface_regions();
  else
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const double angle = internal::sharp_angle_parameter(np);
    const auto vpm =
        choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, tmesh));
    internal::check_points(tmesh, vpm);
    const auto is_crease = get(dynamic_edge_property_t<bool>(), tmesh);
    const auto region = get(dynamic_face_property_t<std::size_t>(), tmesh);
    Surface_regions result;
    internal::mark_edges_of_caller(tmesh, np, is_crease);
    if (angle > 0)
    {
      const internal::Face_directions<TriangleMesh, std::decay_t<decltype(vpm)>> directions(tmesh, vpm);
      const auto sharp = internal::mark_sharp_edges(tmesh, angle, np, directions, is_crease);
      const std::size_t n = internal::number_regions(tmesh, is_crease, region);
      result.number_of_joined_specks =
          internal::Crease_pruning<TriangleMesh, std::decay_t<decltype(vpm)>>(tmesh, directions)(region, n, sharp, is_crease);
      for (const auto e : sharp)
        result.number_of_dropped_edges += get(is_crease, e) ? 0 : 1;
      result.number_of_extension_edges = internal::extend_darts(tmesh, directions, angle, sharp, region, is_crease);
    }
    result.number_of_regions = internal::number_regions(tmesh, is_crease, region);
    for (const auto e : edges(tmesh))
    {
      put(edge_is_crease, e, get(is_crease, e));
      result.number_of_crease_edges += get(is_crease, e) ? 1 : 0;
    }
    for (const auto f : faces(tmesh))
      put(face_region, f, get(region, f));
    return result;
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_SURFACE_REGIONS_H
