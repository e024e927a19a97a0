// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_FACES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_FACES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Input_location.h>
#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/aspect_ratio.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/visitor_parameter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/has_long_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Visitor_reference.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/load_obstacles.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/input_locations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Mesh_storer.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/load_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/points_and_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Surface_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_by_error.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/sizing_field_parameter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/split_input.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The regions of the loaded faces. Throws std::invalid_argument if a region is not the number of a piece.
template <typename TriangleMesh, typename FaceRegionMap>
std::vector<Region> regions_of_faces(const Mesh_origin<TriangleMesh>& origin, const FaceRegionMap face_region,
                                     const std::size_t number_of_pieces)
{
  std::vector<Region> result;
  for (std::size_t i = 0; i < origin.faces.size(); ++i)
  {
    const std::size_t region = static_cast<std::size_t>(get(face_region, origin.faces[i]));
    if (region >= number_of_pieces)
      throw_invalid_argument("face_patch_map", region,
                             "the number of a piece, below " + std::to_string(number_of_pieces) + ", at face " +
                                 std::to_string(origin.face_positions[i]));
    result.push_back(Region(region));
  }
  return result;
}

// the intersections of the mesh, and with the faces that are not remeshed
template <typename NamedParameters, typename Mesh, typename TriangleMesh, typename VertexPointMap>
Mesh_intersections<Mesh> intersections_parameter(const NamedParameters& np, const Mesh& mesh, const TriangleMesh& tmesh,
                                                 const VertexPointMap vpm, const Mesh_origin<TriangleMesh>& origin,
                                                 const bool is_whole_mesh)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const bool is_active = choose_parameter(get_parameter(np, internal_np::do_self_intersection_tests), true);
  Obstacles obstacles;
  if (is_active && !is_whole_mesh)
    obstacles = load_obstacles(tmesh, vpm, origin);
  while (!obstacles.vertex_numbers.empty() && obstacles.vertex_numbers.size() < mesh.number_of_vertices())
    obstacles.vertex_numbers.push_back(obstacles.first_free_number++); // of vertices that the input did not have
  return Mesh_intersections<Mesh>(mesh, std::move(obstacles), is_active);
}

// counts faces that are so long and thin that no one will like them
template <typename Mesh>
std::size_t number_of_needles(const Mesh& mesh)
{
  std::size_t number = 0;
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    number += aspect_ratio(mesh.point(t.a).point, mesh.point(t.b).point, mesh.point(t.c).point) > needle_aspect_ratio ? 1 : 0;
  }
  return number;
}

// counts faces without a neighbour
template <typename Mesh>
std::size_t number_of_lone_faces(const Mesh& mesh)
{
  std::size_t number = 0;
  for (const Face_index f : mesh.faces())
  {
    bool is_lone = true;
    for (const Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      is_lone = is_lone && mesh.is_border(mesh.opposite(h));
    number += is_lone ? 1 : 0;
  }
  return number;
}

// No function: the facets of the input are the surface. It has one region, or several with creases between them.
struct No_function
{
};
struct No_function_of_regions
{
  std::size_t n;
  std::size_t number_of_pieces() const { return n; }
  No_function piece(std::size_t) const { return No_function(); }
};

template <typename Function>
constexpr bool has_values =
    !std::is_same<Function, No_function>::value && !std::is_same<Function, No_function_of_regions>::value;

// loads the faces, remeshes them and stores them
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename Function, typename NamedParameters,
          typename CreaseMaps>
Remeshing_result remesh_faces(const FaceRange& faces, TriangleMesh& tmesh, const Function& function, const bool is_whole_mesh,
                              const NamedParameters& np, const CreaseMaps& creases)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, tmesh));
  Remeshing_visitor nobody;
  Visitor_parameter<NamedParameters> visitor = visitor_parameter(np, nobody);
  Interruption interruption([&visitor] { return visitor.go_further(); });
  const auto constraints = mesh_constraints<TriangleMesh>(np, creases);

  typedef typename Embedding_with_sizes<NamedParameters>::type Embedding;
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;
  Remeshing_result result;
  Mesh mesh;
  Mesh_origin<TriangleMesh> origin;
  const auto load = [&]
  {
    mesh = Mesh();
    origin = load_mesh(tmesh, faces, vpm, constraints, interruption, mesh);
    if constexpr (is_piecewise<Function>)
      mesh.set_input_regions(regions_of_faces(origin, creases.face_region, number_of_pieces(function)));
  };
  try
  {
    load();
  }
  catch (const Interrupted&)
  {
    result.was_stopped = true;
    return result;
  }
  const auto embedding_without_sizes = embedding_parameter(np, origin.diagonal);
  std::optional<Input_surface> input_with_sizes; // none if no sizes are asked for
  const Embedding embedding = [&]
  {
    if constexpr (is_given<NamedParameters, internal_np::sizing_field_t>)
    {
      input_with_sizes.emplace(points_of(mesh), origin.facets, origin.diagonal / origin.unit);
      return embedding_with_sizes(embedding_without_sizes,
                                  sizing_field_parameter<Value_of_map<decltype(vpm), Vertex_of<TriangleMesh>>>(
                                      np, tmesh, origin.vertices, *input_with_sizes, origin.unit));
    }
    else
      return embedding_without_sizes;
  }();
  const Embedding embedding_in_unit = embedding.in_unit(origin.unit);
  const double unit_of_lengths = embedding_in_unit.unit_of_lengths(origin.unit);
  Remeshing_parameters parameters =
      remeshing_parameters(np, embedding_in_unit, origin.diagonal, origin.unit, mesh.number_of_faces());
  if (parameters.scheme == Remeshing_scheme::MEASURED_ERROR)
    parameters.has_long_facets = has_long_facets(faces, tmesh, vpm);
  const bool is_split = parameters.scheme == Remeshing_scheme::MEASURED_ERROR && !(parameters.error > 0) &&
                        parameters.target.number_of_faces() > double(mesh.number_of_faces());
  if (is_split)
  {
    split_faces(mesh, parameters.target.number_of_faces(), interruption);
    if constexpr (!is_given<NamedParameters, internal_np::number_of_iterations_t>)
      parameters.number_of_iterations = 0; // it cannot come nearer to the input
  }
  const Input_surface input(points_of(mesh), facets_of(mesh), origin.diagonal / origin.unit);
  auto intersections = intersections_parameter(np, mesh, tmesh, vpm, origin, is_whole_mesh);
  const Visitor_reference listener(visitor, interruption);
  const auto remesh_copy = [&]
  {
    Remeshing_report report;
    if (parameters.scheme == Remeshing_scheme::MEASURED_ERROR)
    {
      if constexpr (std::is_same<Embedding, Normal_embedding>::value &&
                    is_given<NamedParameters, internal_np::remeshing_scheme_t>)
        report = remesh_by_error<ConcurrencyTag>(mesh, is_piecewise<Function>, input, intersections, parameters, listener);
      report.number_of_regions = number_of_pieces(function);
    }
    else if constexpr (has_values<Function>)
      report = remesh<ConcurrencyTag>(mesh, embedding_in_unit, Surface_function(function, origin.unit), input, intersections,
                                      parameters, listener);
    return report;
  };
  try
  {
    Remeshing_report report = remesh_copy();
    while (intersections.template learns_from_pairs<ConcurrencyTag>(interruption))
    {
      load();
      if (is_split)
        split_faces(mesh, parameters.target.number_of_faces(), interruption);
      report = remesh_copy();
    }
    write_report(report, origin.unit, unit_of_lengths, result);
  }
  catch (const Interrupted&) // while it was loaded again
  {
    result.was_stopped = true;
    return result;
  }
  catch (const Too_many_faces& too_many)
  {
    throw_too_many_faces<NamedParameters>(too_many, unit_of_lengths);
  }
  if constexpr (std::is_same<Embedding_parameter<NamedParameters>, Normal_embedding>::value)
    if (parameters.scheme != Remeshing_scheme::MEASURED_ERROR)
      result.sigma = embedding_without_sizes.sigma();
  result.was_stopped = interruption.is_requested();
  if (result.was_stopped && result.number_of_iterations == 0)
    return result; // some vertices may not be on the surface yet

  Real_timer timer;
  timer.start();
  visitor.stage_started(Stage::OUTPUT);
  if (!parameters.target.is_length_given() && parameters.target.number_of_faces() < double(largest_number_of_faces))
    result.number_of_target_faces = std::size_t(parameters.target.number_of_faces());
  result.number_of_faces = mesh.number_of_faces();
  result.number_of_needles = number_of_needles(mesh);
  result.number_of_self_intersections_before = intersections.number_of_pairs_before();
  result.number_of_self_intersections = intersections.number_of_pairs();
  result.number_of_lone_faces = number_of_lone_faces(mesh);
  result.has_long_facets = parameters.has_long_facets;
  const bool is_all_replaced = is_whole_mesh && !is_constrained<NamedParameters>;
  std::vector<Input_location> locations;
  Located_vertices<TriangleMesh> rest;
  if constexpr (is_given<NamedParameters, internal_np::vertex_location_map_t>)
  {
    // without the vertices that were added to it
    std::vector<Vector> points(input.points().begin(), input.points().begin() + std::ptrdiff_t(origin.vertices.size()));
    const Input_surface of_caller(std::move(points), origin.facets, input.diagonal());
    locations = locations_on_input<ConcurrencyTag>(mesh, of_caller, origin);
    if (!is_all_replaced)
      rest = locations_of_rest(tmesh, origin.vertices);
  }
  if (is_all_replaced)
    result.number_of_isolated_vertices = origin.number_of_isolated_vertices;
  const auto location_map = get_parameter(np, internal_np::vertex_location_map);
  Mesh_storer<ConcurrencyTag, Mesh, TriangleMesh, decltype(vpm), std::decay_t<decltype(constraints)>,
              std::decay_t<decltype(location_map)>>
      store(mesh, origin, tmesh, vpm, constraints, location_map, locations, rest);
  store(is_all_replaced);
  result.output_seconds = timer.time();
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_FACES_H
