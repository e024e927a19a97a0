// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_PARAMETER_TYPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_PARAMETER_TYPES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Input_location.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_scheme.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/Smoothing.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/sizing_field_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/config.h>
#include <CGAL/version.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <type_traits>
#include <utility>

// What the named parameters take. A wrong type shall be one error with the name of the parameter, not pages of errors from
// within. So a public function checks a list of parameters first. If one is refused, it instantiates nothing else.

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the type of a named parameter; internal_np::Param_not_found if it is not given
template <typename NamedParameters, typename Tag>
using Given_type =
    std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), std::declval<Tag>()))>;

// The conditions below are on the type T of a parameter. The subject is the mesh, range or kernel that the parameter belongs
// to.

template <typename T, typename>
struct Is_number : std::bool_constant<is_number<T>>
{
};

template <typename T, typename>
struct Is_smoothing : std::bool_constant<is_number<T> || std::is_same<T, Smoothing>::value>
{
};

template <typename T, typename>
struct Is_boolean : std::bool_constant<is_boolean<T>>
{
};

// a count; doubles are accepted, too, as a count may come from a computation
template <typename T, typename>
struct Is_count : std::bool_constant<std::is_arithmetic<T>::value && !std::is_same<T, bool>::value>
{
};

template <typename T, typename>
struct Is_remeshing_scheme : std::is_same<T, Remeshing_scheme>
{
};

template <typename T, typename, typename = void>
struct Is_embedding : std::false_type
{
};
template <typename T, typename Subject>
struct Is_embedding<T, Subject,
                    std::void_t<typename T::Vertex_data, decltype(std::declval<const T&>().in_unit(1.)),
                                decltype(std::declval<const T&>().unit_of_lengths(1.))>> : std::true_type
{
};

// The remesher makes an embedding of a metric.
template <typename T, typename = void>
constexpr bool is_metric_given = false;
template <typename T>
constexpr bool is_metric_given<
    T, std::void_t<decltype(std::declval<const T&>()(Eigen::Vector3d(), Eigen::Matrix<double, 3, 2>(), Eigen::Matrix2d())),
                   decltype(std::declval<const T&>().bounds()), decltype(std::declval<const T&>().in_unit(1.)),
                   decltype(std::declval<const T&>().unit_of_lengths(1.))>> = true;

template <typename T, typename Subject>
struct Is_embedding_or_metric : std::bool_constant<Is_embedding<T, Subject>::value || is_metric_given<T>>
{
};

template <typename T, typename, typename = void>
struct Is_visitor : std::false_type
{
};
template <typename T, typename Subject>
struct Is_visitor<T, Subject,
                  std::void_t<decltype(std::declval<T&>().stage_started(Stage::OUTPUT)),
                              decltype(std::declval<T&>().progress(0.5)), decltype(bool(std::declval<T&>().go_further()))>>
  : std::true_type
{
};

template <typename T, typename Subject>
struct Is_visitor<std::reference_wrapper<T>, Subject, void> : Is_visitor<T, Subject>
{
};

template <typename T, typename, typename = void>
struct Is_radial_function : std::false_type
{
};
template <typename T, typename Subject>
struct Is_radial_function<T, Subject,
                          std::void_t<decltype(T::order), decltype(T::sign), decltype(std::declval<const T&>()(1.).value),
                                      decltype(std::declval<const T&>()(1.).first)>> : std::true_type
{
};

template <typename T, typename, typename = void>
struct Is_kernel : std::false_type
{
};
template <typename T, typename Subject>
struct Is_kernel<T, Subject, std::void_t<typename T::FT, typename T::Point_3, typename T::Collinear_3>> : std::true_type
{
};

template <typename Graph>
using Vertex_of = typename boost::graph_traits<Graph>::vertex_descriptor;
template <typename Graph>
using Edge_of = typename boost::graph_traits<Graph>::edge_descriptor;
template <typename Graph>
using Face_of = typename boost::graph_traits<Graph>::face_descriptor;

template <typename T, typename Graph>
struct Is_vertex_point_map : Has_coordinates<Value_of_map<T, Vertex_of<Graph>>>
{
};

template <typename T, typename Graph>
struct Is_written_vertex_point_map : std::bool_constant<Is_vertex_point_map<T, Graph>::value &&
                                                        is_writable_map<T, Vertex_of<Graph>, Value_of_map<T, Vertex_of<Graph>>>>
{
};

template <typename T, typename Range>
struct Has_points_of_range : Has_coordinates<Value_of_map<T, Value_of_range<Range>>>
{
};

template <typename T, typename Graph>
struct Is_edge_boolean_map : std::is_convertible<Value_of_map<T, Edge_of<Graph>>, bool>
{
};

template <typename T, typename Graph>
struct Is_written_edge_boolean_map
  : std::bool_constant<Is_edge_boolean_map<T, Graph>::value && is_writable_map<T, Edge_of<Graph>, bool>>
{
};

template <typename T, typename Graph>
struct Is_vertex_boolean_map : std::is_convertible<Value_of_map<T, Vertex_of<Graph>>, bool>
{
};

template <typename T, typename Graph>
struct Is_face_map : std::bool_constant<is_readable_map<T, Face_of<Graph>>>
{
};

template <typename T, typename Graph>
struct Is_written_face_map : std::bool_constant<is_readable_map<T, Face_of<Graph>> &&
                                                is_writable_map<T, Face_of<Graph>, Value_of_map<T, Face_of<Graph>>>>
{
};

template <typename T, typename Graph>
struct Is_location_map : std::bool_constant<is_writable_map<T, Vertex_of<Graph>, Input_location>>
{
};

template <typename, typename>
struct Is_never_taken : std::false_type
{
};

// A check of one parameter: its tag, its condition, and the condition in words.
#define CGAL_AHR_TAKES(CHECK, TAG, CONDITION, WORDS)                                                                           \
  struct Takes_##CHECK                                                                                                         \
  {                                                                                                                            \
    template <typename NamedParameters, typename Subject>                                                                      \
    static constexpr bool accepts()                                                                                            \
    {                                                                                                                          \
      typedef Given_type<NamedParameters, internal_np::TAG> T;                                                                 \
      constexpr bool is_accepted =                                                                                             \
          std::disjunction<std::is_same<T, internal_np::Param_not_found>, CONDITION<T, Subject>>::value;                       \
      static_assert(is_accepted, "the named parameter " WORDS);                                                                \
      return is_accepted;                                                                                                      \
    }                                                                                                                          \
  };

// the names of the table
#define CGAL_AHR_NAMED_PARAMETER(NAME, CONDITION, WORDS) CGAL_AHR_TAKES(NAME, NAME##_t, CONDITION, #NAME " takes " WORDS)
#define CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, TAG, CONDITION, WORDS)                                                          \
  CGAL_AHR_TAKES(NAME, TAG, CONDITION, #NAME " takes " WORDS)
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameter_table.h>

// clang-format off
// where the mesh is not written
CGAL_AHR_TAKES(read_vertex_point_map, vertex_point_t, Is_vertex_point_map, "vertex_point_map takes a property map from the vertices of the mesh to points")
CGAL_AHR_TAKES(read_edge_is_constrained_map, edge_is_constrained_t, Is_edge_boolean_map, "edge_is_constrained_map takes a property map from the edges of the mesh to bool")
CGAL_AHR_TAKES(read_face_patch_map, face_patch_t, Is_face_map, "face_patch_map takes a property map from the faces of the mesh")
// names of PMP's isotropic_remeshing that would be ignored
CGAL_AHR_TAKES(do_project, do_project_t, Is_never_taken, "do_project is not for this function: the vertices are always put on the surface")
CGAL_AHR_TAKES(projection_functor, projection_functor_t, Is_never_taken, "projection_functor is not for this function: give a function whose zero set is the surface")
// names of CGAL that would be ignored, as the package has its own
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(5, 6, 0)
CGAL_AHR_TAKES(facet_angle_of_cgal, facet_angle_param_t, Is_never_taken, "facet_angle is that of CGAL::Anisotropic_hde_remeshing::parameters here")
CGAL_AHR_TAKES(facet_size_of_cgal, facet_size_param_t, Is_never_taken, "facet_size is that of CGAL::Anisotropic_hde_remeshing::parameters here")
CGAL_AHR_TAKES(facet_distance_of_cgal, facet_distance_param_t, Is_never_taken, "facet_distance is that of CGAL::Anisotropic_hde_remeshing::parameters here")
#endif
// clang-format on
#undef CGAL_AHR_TAKES

// Lists of parameters. They are no templates: template arguments would fill the message.

// those of a function, without those of the mesh or range that it is built from
struct Parameters_of_function
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Takes_number_of_patches::template accepts<NamedParameters, Subject>() &&
           Takes_patch_overlap::template accepts<NamedParameters, Subject>() &&
           Takes_offset_distance::template accepts<NamedParameters, Subject>() &&
           Takes_relative_offset_distance::template accepts<NamedParameters, Subject>() &&
           Takes_two_sided_offsets::template accepts<NamedParameters, Subject>() &&
           Takes_smoothing::template accepts<NamedParameters, Subject>() &&
           Takes_points_on_facets::template accepts<NamedParameters, Subject>() &&
           Takes_detect_edges::template accepts<NamedParameters, Subject>() &&
           Takes_radial_function::template accepts<NamedParameters, Subject>() &&
           Takes_visitor::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_function_of_mesh
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Parameters_of_function::template accepts<NamedParameters, Subject>() &&
           Takes_close_holes::template accepts<NamedParameters, Subject>() &&
           Takes_read_vertex_point_map::template accepts<NamedParameters, Subject>() &&
           Takes_vertex_normal_map::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_function_of_range
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Parameters_of_function::template accepts<NamedParameters, Subject>() &&
           Takes_detect_outliers::template accepts<NamedParameters, Subject>() &&
           Takes_close_holes::template accepts<NamedParameters, Subject>() &&
           Takes_point_map::template accepts<NamedParameters, Subject>() &&
           Takes_normal_map::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_reconstruction
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Parameters_of_function_of_range::template accepts<NamedParameters, Subject>() &&
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(5, 6, 0)
           Takes_facet_angle_of_cgal::template accepts<NamedParameters, Subject>() &&
           Takes_facet_size_of_cgal::template accepts<NamedParameters, Subject>() &&
           Takes_facet_distance_of_cgal::template accepts<NamedParameters, Subject>() &&
#endif
           Takes_facet_angle::template accepts<NamedParameters, Subject>() &&
           Takes_facet_size::template accepts<NamedParameters, Subject>() &&
           Takes_facet_distance::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_regions
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Takes_sharp_angle::template accepts<NamedParameters, Subject>() &&
           Takes_read_edge_is_constrained_map::template accepts<NamedParameters, Subject>() &&
           Takes_read_face_patch_map::template accepts<NamedParameters, Subject>() &&
           Takes_read_vertex_point_map::template accepts<NamedParameters, Subject>() &&
           Takes_geom_traits::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_sizes
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Takes_sigma::template accepts<NamedParameters, Subject>() &&
           Takes_relative_sigma::template accepts<NamedParameters, Subject>() &&
           Takes_embedding::template accepts<NamedParameters, Subject>() &&
           Takes_sizing_field::template accepts<NamedParameters, Subject>() &&
           Takes_gradation::template accepts<NamedParameters, Subject>() &&
           Takes_target_edge_length::template accepts<NamedParameters, Subject>() &&
           Takes_relative_target_edge_length::template accepts<NamedParameters, Subject>() &&
           Takes_number_of_target_faces::template accepts<NamedParameters, Subject>() &&
           Takes_approximation_error::template accepts<NamedParameters, Subject>() &&
           Takes_relative_approximation_error::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_remeshing
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Parameters_of_sizes::template accepts<NamedParameters, Subject>() &&
           Takes_fit_to_surface::template accepts<NamedParameters, Subject>() &&
           Takes_shape_weight::template accepts<NamedParameters, Subject>() &&
           Takes_aspect_ratio_bound::template accepts<NamedParameters, Subject>() &&
           Takes_project_borders::template accepts<NamedParameters, Subject>() &&
           Takes_number_of_iterations::template accepts<NamedParameters, Subject>() &&
           Takes_number_of_relaxation_steps::template accepts<NamedParameters, Subject>() &&
           Takes_remeshing_scheme::template accepts<NamedParameters, Subject>() &&
           Takes_split_ratio::template accepts<NamedParameters, Subject>() &&
           Takes_collapse_ratio::template accepts<NamedParameters, Subject>() &&
           Takes_smoothing_ratio::template accepts<NamedParameters, Subject>() &&
           Takes_edge_is_constrained_map::template accepts<NamedParameters, Subject>() &&
           Takes_vertex_is_constrained_map::template accepts<NamedParameters, Subject>() &&
           Takes_face_patch_map::template accepts<NamedParameters, Subject>() &&
           Takes_protect_constraints::template accepts<NamedParameters, Subject>() &&
           Takes_collapse_constraints::template accepts<NamedParameters, Subject>() &&
           Takes_relax_constraints::template accepts<NamedParameters, Subject>() &&
           Takes_do_split::template accepts<NamedParameters, Subject>() &&
           Takes_do_collapse::template accepts<NamedParameters, Subject>() &&
           Takes_do_flip::template accepts<NamedParameters, Subject>() &&
           Takes_do_project::template accepts<NamedParameters, Subject>() &&
           Takes_projection_functor::template accepts<NamedParameters, Subject>() &&
           Takes_do_self_intersection_tests::template accepts<NamedParameters, Subject>() &&
           Takes_vertex_location_map::template accepts<NamedParameters, Subject>() &&
           Takes_visitor::template accepts<NamedParameters, Subject>() &&
           Takes_vertex_point_map::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_remeshing_without_function
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Parameters_of_remeshing::template accepts<NamedParameters, Subject>() &&
           Parameters_of_function::template accepts<NamedParameters, Subject>() &&
           Takes_vertex_normal_map::template accepts<NamedParameters, Subject>() &&
           Takes_sharp_angle::template accepts<NamedParameters, Subject>() &&
           Takes_geom_traits::template accepts<NamedParameters, Subject>();
  }
};

struct Parameters_of_measures
{
  template <typename NamedParameters, typename Subject>
  static constexpr bool accepts()
  {
    return Takes_read_vertex_point_map::template accepts<NamedParameters, Subject>() &&
           Takes_read_face_patch_map::template accepts<NamedParameters, Subject>() &&
           Takes_geom_traits::template accepts<NamedParameters, Subject>() &&
           Takes_sigma::template accepts<NamedParameters, Subject>() &&
           Takes_target_edge_length::template accepts<NamedParameters, Subject>() &&
           Takes_number_of_points_on_faces::template accepts<NamedParameters, Subject>();
  }
};

// whether a function for a mesh, range or kernel accepts `np`; if not, an error of the compiler says what is wrong
template <typename List, typename Subject, typename NamedParameters>
constexpr bool accepts_parameters()
{
  constexpr bool is_np = is_named_parameters<NamedParameters>;
  static_assert(is_np,
                "the last argument must be named parameters, such as CGAL::Anisotropic_hde_remeshing::parameters::sigma(0.1)");
  if constexpr (is_np)
    return List::template accepts<NamedParameters, Subject>();
  else
    return false;
}

template <typename TriangleMesh>
constexpr bool accepts_mesh()
{
  constexpr bool is_mesh = Is_face_graph<TriangleMesh>::value;
  static_assert(is_mesh, "the mesh must be a model of FaceListGraph, such as Surface_mesh, whose headers are included");
  return is_mesh;
}

template <typename TriangleMesh>
constexpr bool accepts_mesh_to_write()
{
  constexpr bool is_const = std::is_const<TriangleMesh>::value;
  static_assert(!is_const, "the mesh is remeshed in place: it must not be const");
  return !is_const && accepts_mesh<TriangleMesh>();
}

template <typename TriangleMesh, typename FaceRange>
constexpr bool accepts_faces()
{
  constexpr bool are_faces = std::is_convertible<Value_of_range<FaceRange>, Face_of<TriangleMesh>>::value;
  static_assert(are_faces, "the range must be one of faces of the mesh");
  return are_faces;
}

template <typename Function>
constexpr bool accepts_function()
{
  constexpr bool is_function = is_implicit_function<Function>;
  static_assert(is_function,
                "the function must be a model of ImplicitFunctionWithGradient, with Point_3, operator()(Point_3) "
                "const and gradient(Point_3) const, or of PiecewiseImplicitFunction; make_implicit_function() makes one "
                "of a lambda");
  return is_function;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_PARAMETER_TYPES_H
