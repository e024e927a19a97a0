// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_ON_SURFACE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_ON_SURFACE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/Any_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/visitor_parameter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Facet_planes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Facet_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/has_long_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/keep_sharp_curves.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/input_locations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remeshing_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>
#include <CGAL/Piecewise_rbf_implicit_function.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// whether the first argument is a range of faces: this tells the functions below apart
template <typename T>
constexpr bool is_face_range = Is_range<std::remove_const_t<T>>::value;

// all faces of a mesh
struct Whole_mesh
{
  template <typename TriangleMesh>
  auto operator()(const TriangleMesh& tmesh) const
  {
    return faces(tmesh);
  }
  static constexpr bool is_whole = true;
};

// some faces of a mesh
template <typename FaceRange>
struct Part_of_mesh
{
  const FaceRange& range;

  template <typename TriangleMesh>
  const FaceRange& operator()(const TriangleMesh&) const
  {
    return range;
  }
  static constexpr bool is_whole = false;
};

template <typename TriangleMesh>
constexpr bool accepts_faces_of(const Whole_mesh*)
{
  return true;
}
template <typename TriangleMesh, typename FaceRange>
constexpr bool accepts_faces_of(const Part_of_mesh<FaceRange>*)
{
  return accepts_faces<TriangleMesh, FaceRange>();
}

template <typename FaceRange>
std::size_t number_of_faces_in(const FaceRange& faces)
{
  std::size_t number = 0;
  for_each_of_range(faces, [&](const auto&) { ++number; });
  return number;
}

// A mesh that stays as it was, as the remeshing was stopped or there is nothing to remesh: its vertices are where they were.
template <typename TriangleMesh, typename NamedParameters>
void locate_unchanged_vertices(const TriangleMesh& tmesh, const NamedParameters& np)
{
  if constexpr (is_given<NamedParameters, internal_np::vertex_location_map_t>)
  {
    auto location_map = parameters::get_parameter(np, internal_np::vertex_location_map);
    for (const auto& located : locations_of_rest(tmesh, {}))
      put(location_map, located.first, located.second);
  }
  else
  {
    (void)tmesh;
    (void)np;
  }
}

// Calls `remesh` with the faces, unless there are none of a part of a mesh: then nothing is to do.
template <typename Faces, typename TriangleMesh, typename NamedParameters, typename Remesh>
Remeshing_result remesh_any_faces(const Faces& faces, TriangleMesh& tmesh, const NamedParameters& np, const Remesh& remesh)
{
  check_parameters(np);
  Remeshing_result result;
  if (Faces::is_whole || number_of_faces_in(faces(tmesh)) > 0)
    result = remesh(faces(tmesh));
  if (result.number_of_faces == 0)
    locate_unchanged_vertices(tmesh, np);
  return result;
}

// remeshes on the zero set of the caller's function
template <typename ConcurrencyTag, typename Faces, typename TriangleMesh, typename Function, typename NamedParameters>
Remeshing_result remesh_on_surface(const Faces& faces, TriangleMesh& tmesh, const Function& function, const NamedParameters& np)
{
  if constexpr (accepts_mesh_to_write<TriangleMesh>())
    if constexpr (accepts_faces_of<TriangleMesh>(static_cast<const Faces*>(nullptr)))
      if constexpr (accepts_function<Function>())
        if constexpr (accepts_parameters<Parameters_of_remeshing, TriangleMesh, NamedParameters>())
        {
          static_assert(
              !is_given<NamedParameters, internal_np::sharp_angle_t>,
              "sharp_angle is for the function that is built here; a piecewise function comes with its face_patch_map");
          Remeshing_visitor nobody;
          Visitor_parameter<NamedParameters> visitor = visitor_parameter(np, nobody);
          const Surface_of_faces<TriangleMesh> surface(function, creases_of_caller<Function, TriangleMesh>(np));
          Faces_request request;
          request.is_whole_mesh = Faces::is_whole;
          constexpr bool may_be_by_error = is_given<NamedParameters, internal_np::remeshing_scheme_t>;
          return remesh_any_faces(faces, tmesh, np,
                                  [&](const auto& range) {
                                    return remesh_faces<ConcurrencyTag, may_be_by_error>(range, tmesh, surface, request, np,
                                                                                         Any_visitor(visitor));
                                  });
        }
  return Remeshing_result();
}

// Remeshes by measured error. No function is needed. With a sharp angle there are regions and creases.
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename NamedParameters>
Remeshing_result remesh_faces_by_error(const FaceRange& faces, TriangleMesh& tmesh, const bool is_whole_mesh,
                                       const NamedParameters& np, const Any_visitor visitor)
{
  Surface_of_faces<TriangleMesh> surface;
  if constexpr (is_given<NamedParameters, internal_np::sharp_angle_t>)
  {
    const auto edge_is_crease = get(dynamic_edge_property_t<bool>(), tmesh);
    const auto face_region = get(dynamic_face_property_t<std::size_t>(), tmesh);
    const Surface_regions regions = detect_surface_regions(tmesh, edge_is_crease, face_region, np);
    surface = Surface_of_faces<TriangleMesh>(regions.number_of_regions, Creases<TriangleMesh>(edge_is_crease, face_region));
  }
  return remesh_faces_without_embedding<ConcurrencyTag>(faces, tmesh, surface, is_whole_mesh, np, visitor);
}

// Whether the caller may ask for creases: by an angle, or by constrained edges or patches. Normals of the caller's are one for each
// vertex, so that the surface is smooth.
template <typename NamedParameters>
constexpr bool
    may_have_creases = is_given<NamedParameters, internal_np::sharp_angle_t> ||
                       (is_none_given<NamedParameters, internal_np::vertex_normal_map_t> &&
                        !is_none_given<NamedParameters, internal_np::edge_is_constrained_t, internal_np::face_patch_t>);

// Finds the creases and the regions between them. Without a sharp angle, creases are the curves of constrained edges and between
// patches that are sharp. Returns whether there are creases that one smooth function would round.
template <typename TriangleMesh, typename NamedParameters, typename EdgeIsCreaseMap, typename FaceRegionMap>
bool find_creases(const TriangleMesh& tmesh, const NamedParameters& np, const EdgeIsCreaseMap edge_is_crease,
                  const FaceRegionMap face_region)
{
  if constexpr (is_given<NamedParameters, internal_np::sharp_angle_t>)
  {
    detect_surface_regions(tmesh, edge_is_crease, face_region, np);
    return true;
  }
  else
  {
    static constexpr double sharp_angle_of_constraints = 40; // degrees
    const auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                  get_const_property_map(vertex_point, tmesh));
    check_points(tmesh, vpm);
    mark_edges_of_caller(tmesh, np, edge_is_crease);
    return keep_sharp_curves(tmesh, vpm, sharp_angle_of_constraints, edge_is_crease) &&
           number_regions(tmesh, edge_is_crease, face_region) > 1;
  }
}

// whether the facets of the mesh are the surface: they are long and exact
template <typename TriangleMesh, typename NamedParameters>
bool has_exact_facets(const TriangleMesh& tmesh, const NamedParameters& np)
{
  return has_long_facets(Whole_mesh()(tmesh), tmesh,
                         parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                      get_const_property_map(vertex_point, tmesh)));
}

// Builds the function of the whole mesh, and calls `remesh_on` with it and its creases. The function is smooth, or smooth between
// creases, or that of the facets where these are long and exact and nothing is asked of the function. It computes in double even if
// the points of the mesh are exact.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters, typename FunctionParameters,
          typename RemeshOn>
void build_function_of(const TriangleMesh& tmesh, const NamedParameters& np, const FunctionParameters& np_of_function,
                       const RemeshOn& remesh_on)
{
  typedef std::decay_t<decltype(parameters::choose_parameter(parameters::get_parameter(np, internal_np::radial_function),
                                                             Polyharmonic_rbf()))>
      Radial_function;
  typedef Simple_cartesian<double> Kernel;
  typedef Piecewise_rbf_implicit_function<Kernel, Radial_function, ConcurrencyTag> Function_of_regions;

  if constexpr (may_have_creases<NamedParameters>)
  {
    const auto edge_is_crease = get(dynamic_edge_property_t<bool>(), tmesh);
    const auto face_region = get(dynamic_face_property_t<std::size_t>(), tmesh);
    if (find_creases(tmesh, np, edge_is_crease, face_region))
    {
      remesh_on(Function_of_regions(tmesh, face_region, keep_long_facets(np_of_function, has_exact_facets(tmesh, np))),
                Creases<TriangleMesh>(edge_is_crease, face_region));
      return;
    }
  }
  if constexpr (!is_given<NamedParameters, internal_np::sharp_angle_t>)
  {
    if constexpr (leaves_function_open<NamedParameters>)
      if (iteration_parameters(np).scheme != Remeshing_scheme::PAPER && has_exact_facets(tmesh, np))
      {
        typedef Static_boolean_property_map<Face_of<TriangleMesh>, false> One_region;
        remesh_on(Function_of_regions(tmesh, One_region(), keep_long_facets(np_of_function, true)), Creases<TriangleMesh>());
        return;
      }
    typedef Rbf_implicit_function<Kernel, Radial_function, ConcurrencyTag> Function;
    remesh_on(Function(tmesh, np_of_function), Creases<TriangleMesh>());
  }
}

// Whether an embedding may keep to exact facets as they are: with a sharp angle, or if nothing is asked of the function. A map of
// constrained edges tells of all curves in the end, and without a sharp angle its owner expects none but his own.
template <typename NamedParameters>
constexpr bool may_keep_facets =
    !is_error_given<NamedParameters> && !is_given<NamedParameters, internal_np::sizing_field_t> &&
    (is_given<NamedParameters, internal_np::sharp_angle_t> ||
     (leaves_function_open<NamedParameters> && !is_given<NamedParameters, internal_np::edge_is_constrained_t>));

// Whether the measured error may take the place of an embedding that does not get the number of faces asked for with all facets. Who
// asks for none wants other faces, and not those of the input, which are what loses the least.
template <typename NamedParameters>
constexpr bool may_give_way_to_error = is_given<NamedParameters, internal_np::number_of_target_faces_t> &&
                                       !is_given<NamedParameters, internal_np::project_borders_t> &&
                                       (std::is_same<Embedding_parameter<NamedParameters>, Normal_embedding>::value ||
                                        is_metric<Embedding_parameter<NamedParameters>>);

// the same for these parameters and this mesh
template <typename TriangleMesh, typename NamedParameters>
bool keeps_facets(const TriangleMesh& tmesh, const NamedParameters& np)
{
  const Remeshing_parameters parameters = iteration_parameters(np);
  const Interpolation_parameters of_function = interpolation_parameters(np);
  sharp_angle_parameter(np); // throws if it is out of its range
  return parameters.scheme != Remeshing_scheme::PAPER && parameters.number_of_iterations > 0 && !(of_function.noise > 0) &&
         !of_function.estimates_noise && has_exact_facets(tmesh, np);
}

// Remeshes with each facet as a region, if the number of faces allows it.
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename NamedParameters, typename Facets>
Remeshing_result remesh_between_facets(const FaceRange& faces, TriangleMesh& tmesh, const bool is_whole_mesh,
                                       const NamedParameters& np, const Facets& facets, const Any_visitor visitor)
{
  const auto edge_is_crease = get(dynamic_edge_property_t<bool>(), tmesh);
  const auto face_region = get(dynamic_face_property_t<std::size_t>(), tmesh);
  facets.mark(edge_is_crease, face_region);
  const Facet_planes<Simple_cartesian<double>> function(facets.planes());
  Faces_request request;
  request.is_whole_mesh = is_whole_mesh;
  request.must_meet_number = true;
  return remesh_faces<ConcurrencyTag, true>(
      faces, tmesh, Surface_of_faces<TriangleMesh>(function, Creases<TriangleMesh>(edge_is_crease, face_region)), request, np,
      visitor);
}

// Remeshes a mesh of exact facets by an embedding that keeps to them: each is a region, its edges are creases, and nothing is lost.
// Where the number of faces asked for is less than that takes, the measured error leads: it loses the least, and an embedding on the
// facets would cut across their edges. Returns none if the caller wants the embedding in any case.
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename NamedParameters>
std::optional<Remeshing_result> remesh_exact_facets(const FaceRange& faces, TriangleMesh& tmesh, const bool is_whole_mesh,
                                                    const NamedParameters& np, const Any_visitor visitor)
{
  static constexpr double share_of_embedding = 0.7; // of the progress
  Visitor_of_part of_embedding(visitor, 0, share_of_embedding), of_error(visitor, share_of_embedding, 1);
  visitor.stage_started(Stage::IMPLICIT_FUNCTION);
  Real_timer timer;
  timer.start();
  const auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                get_const_property_map(vertex_point, tmesh));
  const Facet_regions<TriangleMesh, std::decay_t<decltype(vpm)>> facets(tmesh, vpm);
  const std::size_t number_of_faces = number_of_faces_in(faces);
  const Target_length target = target_length(np, facets.diagonal(), 1, number_of_faces);
  if (facets.are_planar() && (!is_whole_mesh || facets.least_number_of_faces() <= target.number_of_faces_over(facets.area())))
  {
    const double seconds = timer.time();
    Remeshing_result result =
        remesh_between_facets<ConcurrencyTag>(faces, tmesh, is_whole_mesh, np, facets, Any_visitor(of_embedding));
    result.implicit_function_seconds = seconds;
    if (result.was_stopped)
      return result;
    if (result.number_of_faces > 0)
    {
      visitor.progress(1);
      return result;
    }
  }
  if constexpr (may_give_way_to_error<NamedParameters>)
    if (iteration_parameters(np).scheme == Remeshing_scheme::DEFAULT && allowed_operations(np).has_all_of_mesh())
      return remesh_faces_by_error<ConcurrencyTag>(faces, tmesh, is_whole_mesh, np, Any_visitor(of_error));
  return std::nullopt;
}

// Remeshes on the surface through the vertices of the whole mesh, whichever faces are remeshed.
template <typename ConcurrencyTag, typename FaceRange, typename TriangleMesh, typename NamedParameters>
Remeshing_result remesh_faces_on_built_surface(const FaceRange& faces, TriangleMesh& tmesh, const bool is_whole_mesh,
                                               const NamedParameters& np)
{
  static constexpr double share_of_function = 0.3; // of the time, where the mesh gets as many faces as it has

  Remeshing_visitor nobody;
  Visitor_parameter<NamedParameters> visitor_of_caller = visitor_parameter(np, nobody);
  const Any_visitor visitor(visitor_of_caller);
  if constexpr (leaves_embedding_and_function_open<NamedParameters>)
  {
    const auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                  get_const_property_map(vertex_point, tmesh));
    if (is_by_measured_error(np, number_of_faces_in(faces), [&] { return has_long_facets(faces, tmesh, vpm); }))
      return remesh_faces_by_error<ConcurrencyTag>(faces, tmesh, is_whole_mesh, np, visitor);
  }
  if constexpr (may_keep_facets<NamedParameters>)
    if (keeps_facets(tmesh, np))
      if (const auto result = remesh_exact_facets<ConcurrencyTag>(faces, tmesh, is_whole_mesh, np, visitor))
        return *result;
  Visitor_of_part of_function(visitor, 0, share_of_function), of_rest(visitor, share_of_function, 1);
  const auto np_of_function = parameters::begin_with(np).visitor(std::ref(of_function)).close_holes(false);
  visitor.stage_started(Stage::IMPLICIT_FUNCTION);
  Real_timer timer;
  timer.start();
  Remeshing_result result;
  Faces_request request;
  request.is_whole_mesh = is_whole_mesh;
  const auto remesh_on = [&](const auto& function, const Creases<TriangleMesh>& creases)
  {
    const double seconds = timer.time();
    result = remesh_faces<ConcurrencyTag, true>(faces, tmesh, Surface_of_faces<TriangleMesh>(function, creases), request, np,
                                                Any_visitor(of_rest));
    result.implicit_function_seconds = seconds;
    result.number_of_patches = function.diagnostics().number_of_patches;
    result.number_of_patches_on_fallback = function.diagnostics().patches_on_fallback;
  };
  try
  {
    build_function_of<ConcurrencyTag>(tmesh, np, np_of_function, remesh_on);
  }
  catch (const Interrupted&)
  {
    result.was_stopped = true;
  }
  return result;
}

template <typename ConcurrencyTag, typename Faces, typename TriangleMesh, typename NamedParameters>
Remeshing_result remesh_on_built_surface(const Faces& faces, TriangleMesh& tmesh, const NamedParameters& np)
{
  if constexpr (accepts_mesh_to_write<TriangleMesh>())
    if constexpr (accepts_faces_of<TriangleMesh>(static_cast<const Faces*>(nullptr)))
      if constexpr (accepts_parameters<Parameters_of_remeshing_without_function, TriangleMesh, NamedParameters>())
        return remesh_any_faces(faces, tmesh, np,
                                [&](const auto& range)
                                { return remesh_faces_on_built_surface<ConcurrencyTag>(range, tmesh, Faces::is_whole, np); });
  return Remeshing_result();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESH_ON_SURFACE_H
