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
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Space_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/aspect_ratio.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/Any_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
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
template <typename TriangleMesh>
std::vector<Region> regions_of_faces(const Mesh_origin<TriangleMesh>& origin, const Creases<TriangleMesh>& creases,
                                     const std::size_t number_of_pieces)
{
  std::vector<Region> result;
  for (std::size_t i = 0; i < origin.faces.size(); ++i)
  {
    const std::size_t region = creases.region(origin.faces[i]);
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

// counts faces whose longest edge is longer than `bound` times the altitude over it
template <typename Mesh>
std::size_t number_of_faces_beyond(const Mesh& mesh, const double bound)
{
  std::size_t number = 0;
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    number += Space_triangle{mesh.point(t.a).point, mesh.point(t.b).point, mesh.point(t.c).point}.ratio() > bound ? 1 : 0;
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

// The surface that the faces are remeshed on: the zero set of a function, or without one the facets of the input. It has one region, or
// several with creases between them.
template <typename TriangleMesh>
struct Surface_of_faces
{
  Surface_of_faces() = default;
  template <typename Function>
  Surface_of_faces(const Function& f, Creases<TriangleMesh> c)
    : function(f), number_of_regions(function.number_of_pieces()), is_piecewise(function.is_piecewise()), creases(std::move(c))
  {
  }
  // the facets
  Surface_of_faces(const std::size_t n, Creases<TriangleMesh> c)
    : number_of_regions(n), is_piecewise(true), creases(std::move(c))
  {
  }

  Surface_function function; // none of the facets
  std::size_t number_of_regions = 1;
  bool is_piecewise = false;
  Creases<TriangleMesh> creases;
};

// what is to be done, beyond what the caller asks for
struct Faces_request
{
  bool is_whole_mesh = true;
  bool is_by_error = false;      // whatever scheme and embedding the caller asks for
  bool must_meet_number = false; // a result that misses the number of faces asked for is not stored, and tells of no faces
};

// Loads the faces, remeshes the copy and stores it. `may_be_by_error`: whether the measured error may lead.
template <typename ConcurrencyTag, bool may_be_by_error, typename Embedding, typename FaceRange, typename TriangleMesh,
          typename NamedParameters>
class Faces_remesher
{
  static_assert(has_remesh<Embedding>, "with shared instantiations, embeddings and metrics other than Normal_embedding and "
                                       "Curvature_metric need CGAL_AHR_WITH_OTHER_TYPES");
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;

  static auto vertex_point_map(const NamedParameters& np, TriangleMesh& tmesh)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    return choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, tmesh));
  }
  typedef decltype(vertex_point_map(std::declval<const NamedParameters&>(), std::declval<TriangleMesh&>())) Vertex_point_map;
  typedef decltype(mesh_constraints(std::declval<const NamedParameters&>(),
                                    std::declval<const Creases<TriangleMesh>&>())) Constraints;

public:
  Faces_remesher(const FaceRange& faces, TriangleMesh& tmesh, const Surface_of_faces<TriangleMesh>& surface,
                 const Faces_request& request, const NamedParameters& np, const Any_visitor visitor)
    : m_faces(faces),
      m_tmesh(tmesh),
      m_surface(surface),
      m_request(request),
      m_np(np),
      m_vpm(vertex_point_map(np, tmesh)),
      m_visitor(visitor),
      m_interruption([visitor] { return visitor.go_further(); }),
      m_constraints(mesh_constraints(np, surface.creases))
  {
  }

  Remeshing_result operator()()
  {
    try
    {
      load();
      remesh_copy();
    }
    catch (const Interrupted&) // while it was loaded
    {
      m_result.was_stopped = true;
      return m_result;
    }
    m_result.was_stopped = m_interruption.is_requested();
    if (m_request.must_meet_number)
    {
      write_counts();
      if (m_result.misses_number_of_faces())
      {
        m_result.number_of_faces = 0;
        return m_result;
      }
    }
    if (!m_result.was_stopped || m_result.number_of_iterations > 0) // otherwise some vertices may not be on the surface yet
      store();
    return m_result;
  }

private:
  void load()
  {
    m_mesh = Mesh();
    m_origin = load_mesh(m_tmesh, m_faces, m_vpm, m_constraints, m_interruption, m_mesh);
    if (m_surface.is_piecewise)
      m_mesh.set_input_regions(regions_of_faces(m_origin, m_surface.creases, m_surface.number_of_regions));
  }

  // Remeshes the copy, and begins anew if more of its faces intersect afterwards.
  void remesh_copy()
  {
    std::optional<Input_surface> input_with_sizes; // none if no sizes are asked for
    const Embedding embedding = embedding_of_caller(input_with_sizes).in_unit(m_origin.unit);
    const double unit_of_lengths = embedding.unit_of_lengths(m_origin.unit);
    read_parameters(embedding);
    m_input.emplace(points_of(m_mesh), facets_of(m_mesh), m_origin.diagonal / m_origin.unit);
    auto intersections = intersections_parameter(m_np, m_mesh, m_tmesh, m_vpm, m_origin, m_request.is_whole_mesh);
    try
    {
      Remeshing_report report = remesh_once(embedding, intersections);
      while (intersections.is_to_restart())
      {
        intersections.restart();
        load();
        split();
        report = remesh_once(embedding, intersections);
      }
      write_report(report, m_origin.unit, unit_of_lengths, m_result);
    }
    catch (const Too_many_faces& too_many)
    {
      throw_too_many_faces<NamedParameters>(too_many, unit_of_lengths);
    }
    if constexpr (std::is_same<Embedding_parameter<NamedParameters>, Normal_embedding>::value)
      if (!is_by_error())
        m_result.sigma = embedding_parameter(m_np, m_origin.diagonal).sigma();
    m_result.number_of_self_intersections_before = intersections.number_of_pairs_before();
    m_result.number_of_self_intersections = intersections.number_of_pairs();
  }

  // in the caller's unit; the measured error has none
  Embedding embedding_of_caller(std::optional<Input_surface>& input) const
  {
    if constexpr (std::is_same<Embedding, Normal_embedding>::value)
      if (m_request.is_by_error)
        return Normal_embedding(0);
    if constexpr (!std::is_same<Embedding, typename Embedding_with_sizes<NamedParameters>::type>::value)
      return Embedding(0);
    else if constexpr (is_given<NamedParameters, internal_np::sizing_field_t>)
    {
      input.emplace(points_of(m_mesh), m_origin.facets, m_origin.diagonal / m_origin.unit);
      return embedding_with_sizes(embedding_parameter(m_np, m_origin.diagonal),
                                  sizing_field_parameter<Value_of_map<Vertex_point_map, Vertex_of<TriangleMesh>>>(
                                      m_np, m_tmesh, m_origin.vertices, *input, m_origin.unit));
    }
    else
      return embedding_parameter(m_np, m_origin.diagonal);
  }

  bool is_by_error() const { return m_parameters.scheme == Remeshing_scheme::MEASURED_ERROR; }

  void read_parameters(const Embedding& embedding)
  {
    m_parameters = remeshing_parameters(m_np, embedding, m_request.is_by_error, m_origin.diagonal, m_origin.unit,
                                        m_mesh.number_of_faces());
    if (is_by_error())
      m_parameters.has_long_facets = has_long_facets(m_faces, m_tmesh, m_vpm);
    m_is_split =
        is_by_error() && !(m_parameters.error > 0) && m_parameters.target.number_of_faces() > double(m_mesh.number_of_faces());
    split();
    if constexpr (!is_given<NamedParameters, internal_np::number_of_iterations_t>)
      if (m_is_split)
        m_parameters.number_of_iterations = 0; // it cannot come nearer to the input
  }

  // into as many faces as are asked for, if these are more than there are
  void split()
  {
    if (m_is_split)
      split_faces(m_mesh, m_parameters.target.number_of_faces(), m_interruption);
  }

  Remeshing_report remesh_once(const Embedding& embedding, Mesh_intersections<Mesh>& intersections)
  {
    const Visitor_reference listener(m_visitor, m_interruption);
    Remeshing_report report;
    if constexpr (may_be_by_error && std::is_same<Embedding, Normal_embedding>::value)
      if (is_by_error())
      {
        report =
            remesh_by_error<ConcurrencyTag>(m_mesh, m_surface.is_piecewise, *m_input, intersections, m_parameters, listener);
        report.number_of_regions = m_surface.number_of_regions;
        return report;
      }
    if constexpr (std::is_same<Embedding, typename Embedding_with_sizes<NamedParameters>::type>::value)
      report = remesh<ConcurrencyTag>(m_mesh, embedding, m_surface.function.in_unit(m_origin.unit), *m_input, intersections,
                                      m_parameters, listener);
    return report;
  }

  void store()
  {
    Real_timer timer;
    timer.start();
    m_visitor.stage_started(Stage::OUTPUT);
    write_counts();
    const bool is_all_replaced = m_request.is_whole_mesh && !is_constrained<NamedParameters>;
    std::vector<Input_location> locations;
    Located_vertices<TriangleMesh> rest;
    if constexpr (is_given<NamedParameters, internal_np::vertex_location_map_t>)
    {
      locations = locations_of_vertices();
      if (!is_all_replaced)
        rest = locations_of_rest(m_tmesh, m_origin.vertices);
    }
    if (is_all_replaced)
      m_result.number_of_isolated_vertices = m_origin.number_of_isolated_vertices;
    const auto location_map = parameters::get_parameter(m_np, internal_np::vertex_location_map);
    Mesh_storer<ConcurrencyTag, Mesh, TriangleMesh, Vertex_point_map, Constraints, std::decay_t<decltype(location_map)>> store(
        m_mesh, m_origin, m_tmesh, m_vpm, m_constraints, location_map, locations, rest);
    store(is_all_replaced);
    m_result.output_seconds = timer.time();
  }

  void write_counts()
  {
    const Target_length& target = m_parameters.target;
    if (!target.is_length_given() && target.number_of_faces() < double(largest_number_of_faces))
      m_result.number_of_target_faces = std::size_t(target.number_of_faces());
    m_result.number_of_faces = m_mesh.number_of_faces();
    m_result.number_of_needles = number_of_needles(m_mesh);
    if (m_parameters.aspect_ratio_bound > 0)
      m_result.number_of_faces_beyond_aspect_ratio = number_of_faces_beyond(m_mesh, m_parameters.aspect_ratio_bound);
    m_result.number_of_lone_faces = number_of_lone_faces(m_mesh);
    m_result.has_long_facets = m_parameters.has_long_facets;
  }

  // on the faces of the caller, without the vertices that were added to them
  std::vector<Input_location> locations_of_vertices() const
  {
    std::vector<Vector> points(m_input->points().begin(), m_input->points().begin() + std::ptrdiff_t(m_origin.vertices.size()));
    const Input_surface of_caller(std::move(points), m_origin.facets, m_input->diagonal());
    return locations_on_input<ConcurrencyTag>(m_mesh, of_caller, m_origin);
  }

  const FaceRange& m_faces;
  TriangleMesh& m_tmesh;
  const Surface_of_faces<TriangleMesh>& m_surface;
  const Faces_request m_request;
  const NamedParameters& m_np;
  const Vertex_point_map m_vpm;
  const Any_visitor m_visitor;
  Interruption m_interruption;
  const Constraints m_constraints;
  Mesh m_mesh;
  Mesh_origin<TriangleMesh> m_origin;
  Remeshing_parameters m_parameters;
  bool m_is_split = false; // into more faces before all else
  std::optional<Input_surface> m_input;
  Remeshing_result m_result;
};

// remeshes in the embedding that the caller asks for
template <typename ConcurrencyTag, bool may_be_by_error, typename FaceRange, typename TriangleMesh, typename NamedParameters>
Remeshing_result remesh_faces(const FaceRange& faces, TriangleMesh& tmesh, const Surface_of_faces<TriangleMesh>& surface,
                              const Faces_request& request, const NamedParameters& np, const Any_visitor visitor)
{
  typedef typename Embedding_with_sizes<NamedParameters>::type Embedding;
  return Faces_remesher<ConcurrencyTag, may_be_by_error, Embedding, FaceRange, TriangleMesh, NamedParameters>(
      faces, tmesh, surface, request, np, visitor)();
}

// remeshes by measured error, whichever scheme and embedding the caller asks for
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename NamedParameters>
Remeshing_result remesh_faces_without_embedding(const FaceRange& faces, TriangleMesh& tmesh,
                                                const Surface_of_faces<TriangleMesh>& surface, const bool is_whole_mesh,
                                                const NamedParameters& np, const Any_visitor visitor)
{
  Faces_request request;
  request.is_whole_mesh = is_whole_mesh;
  request.is_by_error = true;
  return Faces_remesher<ConcurrencyTag, true, Normal_embedding, FaceRange, TriangleMesh, NamedParameters>(
      faces, tmesh, surface, request, np, visitor)();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_FACES_H
