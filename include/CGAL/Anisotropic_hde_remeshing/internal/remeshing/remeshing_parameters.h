// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHING_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHING_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_scheme.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/size_limits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Allowed_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Metric_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/targets/Target_length.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the parameters of the remeshing in the unit of the working mesh, checked
struct Remeshing_parameters
{
  Remeshing_scheme scheme = Remeshing_scheme::DEFAULT;
  unsigned int number_of_iterations = 10;
  unsigned int number_of_relaxation_steps = 3;
  double smoothing_ratio = 1;
  double collapse_ratio = 0.8;
  double split_ratio = 4. / 3;
  bool fit_to_surface = false;
  double shape_weight = 2;       // by measured error
  double aspect_ratio_bound = 0; // of the longest edge to the altitude over it; 0 if none is asked for
  bool project_borders = false;
  Allowed_operations allowed;
  bool has_long_facets = false; // whether the facets of the input are the long and exact ones of a CAD program
  double error = 0;             // the largest distance to the surface; 0 if none is asked for
  Target_length target = Target_length::of_number_of_faces(0);
};

template <typename NamedParameters, typename Name>
constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Name>::value;

// what PMP's isotropic_remeshing is told by the same names
template <typename NamedParameters>
Allowed_operations allowed_operations(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Allowed_operations result;
  result.split = choose_parameter(get_parameter(np, internal_np::do_split), true);
  result.collapse = choose_parameter(get_parameter(np, internal_np::do_collapse), true);
  result.flip = choose_parameter(get_parameter(np, internal_np::do_flip), true);
  result.collapse_on_curves = choose_parameter(get_parameter(np, internal_np::collapse_constraints), true);
  result.smooth_on_curves = choose_parameter(get_parameter(np, internal_np::relax_constraints), true);
  return result;
}

// An equilateral triangle has 1.15, and no surface is covered by these alone. Infinite: none is asked for.
inline double checked_aspect_ratio_bound(const double bound)
{
  if (!(bound >= 1.2))
    throw_invalid_argument("aspect_ratio_bound", bound, "at least 1.2");
  return std::isinf(bound) ? 0 : bound;
}

// Where vertices move to the least distance, shape hardly counts.
inline double default_shape_weight(const bool is_fitted) { return is_fitted ? 0.1 : Remeshing_parameters().shape_weight; }

// By measured error fewer are enough; where an error is kept, more of them save faces.
inline unsigned int default_number_of_iterations(const Remeshing_scheme scheme, const bool keeps_error)
{
  if (scheme != Remeshing_scheme::MEASURED_ERROR)
    return Remeshing_parameters().number_of_iterations;
  return keeps_error ? 6 : 4;
}

// those that are no lengths
template <typename NamedParameters>
Remeshing_parameters iteration_parameters(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Remeshing_parameters result;
  result.scheme = choose_parameter(get_parameter(np, internal_np::remeshing_scheme), Remeshing_scheme::DEFAULT);
  if (result.scheme == Remeshing_scheme::PAPER)
  {
    result.collapse_ratio = 0.5;
    result.split_ratio = 1.5;
    result.smoothing_ratio = 0.3;
  }
  if constexpr (is_given<NamedParameters, internal_np::number_of_iterations_t>)
    result.number_of_iterations =
        checked_repetitions("number_of_iterations", get_parameter(np, internal_np::number_of_iterations));
  if constexpr (is_given<NamedParameters, internal_np::number_of_relaxation_steps_t>)
    result.number_of_relaxation_steps =
        checked_repetitions("number_of_relaxation_steps", get_parameter(np, internal_np::number_of_relaxation_steps));
  result.smoothing_ratio = checked_between(
      "smoothing_ratio", choose_parameter(get_parameter(np, internal_np::smoothing_ratio), result.smoothing_ratio), 0, 1);
  result.collapse_ratio = checked_between(
      "collapse_ratio", choose_parameter(get_parameter(np, internal_np::collapse_ratio), result.collapse_ratio), 0, 1);
  result.split_ratio =
      checked_between("split_ratio", choose_parameter(get_parameter(np, internal_np::split_ratio), result.split_ratio), 1, 100);
  result.fit_to_surface = choose_parameter(get_parameter(np, internal_np::fit_to_surface), false);
  result.shape_weight =
      checked_not_negative("shape_weight", CGAL::to_double(choose_parameter(get_parameter(np, internal_np::shape_weight),
                                                                            default_shape_weight(result.fit_to_surface))));
  if constexpr (is_given<NamedParameters, internal_np::aspect_ratio_bound_t>)
    result.aspect_ratio_bound = checked_aspect_ratio_bound(CGAL::to_double(get_parameter(np, internal_np::aspect_ratio_bound)));
  result.project_borders = choose_parameter(get_parameter(np, internal_np::project_borders), false);
  result.allowed = allowed_operations(np);
  if (result.scheme == Remeshing_scheme::MEASURED_ERROR && !result.allowed.has_all_of_mesh())
    throw_invalid_argument("remeshing_scheme", "MEASURED_ERROR",
                           "another one, or not given, if do_split, do_collapse or do_flip is false");
  return result;
}

template <typename NamedParameters>
constexpr bool is_error_given = is_given<NamedParameters, internal_np::approximation_error_t> ||
                                is_given<NamedParameters, internal_np::relative_approximation_error_t>;

// The embedding that is given, or that of the metric that is given. Without one it is the paper's, with sigma in the unit of the mesh or
// as a share of the diagonal of its bounding box. If only sizes are given, they are lengths in space, as in PMP's isotropic_remeshing. If
// only an error is given, it is the metric of the largest distance.
template <typename NamedParameters>
auto embedding_parameter(const NamedParameters& np, const double diagonal)
{
  constexpr bool has_embedding = is_given<NamedParameters, internal_np::embedding_t>,
                 has_sigma = is_given<NamedParameters, internal_np::sigma_t>,
                 has_relative_sigma = is_given<NamedParameters, internal_np::relative_sigma_t>;
  static_assert(int(has_embedding) + int(has_sigma) + int(has_relative_sigma) <= 1,
                "embedding, sigma and relative_sigma exclude each other");
  using parameters::get_parameter;
  if constexpr (has_embedding)
  {
    typedef Given_type<NamedParameters, internal_np::embedding_t> Given;
    if constexpr (is_metric_given<Given>)
      return Metric_embedding<Given>(get_parameter(np, internal_np::embedding));
    else
      return Given(get_parameter(np, internal_np::embedding));
  }
  else if constexpr (has_sigma)
    return Normal_embedding(CGAL::to_double(get_parameter(np, internal_np::sigma)));
  else if constexpr (has_relative_sigma)
    return Normal_embedding(
        diagonal * checked_not_negative("relative_sigma", CGAL::to_double(get_parameter(np, internal_np::relative_sigma))));
  else if constexpr (is_given<NamedParameters, internal_np::sizing_field_t>)
    return Normal_embedding(0);
  else if constexpr (is_error_given<NamedParameters>)
    return Metric_embedding<Curvature_metric>(Curvature_metric(std::numeric_limits<double>::infinity()));
  else
    return Normal_embedding(0.01 * diagonal);
}

template <typename NamedParameters>
using Embedding_parameter = decltype(embedding_parameter(std::declval<NamedParameters>(), 1.));

// how much sizes may grow on a way, over its length
template <typename NamedParameters>
double gradation_parameter(const NamedParameters& np)
{
  static_assert(is_given<NamedParameters, internal_np::sizing_field_t>,
                "gradation is that of sizing_field, which is not given");
  return checked_positive("gradation", CGAL::to_double(parameters::get_parameter(np, internal_np::gradation)));
}

// the error in the unit of the mesh; 0 if none is given
template <typename NamedParameters>
double error_parameter(const NamedParameters& np, const double diagonal)
{
  constexpr bool has_error = is_given<NamedParameters, internal_np::approximation_error_t>,
                 has_relative_error = is_given<NamedParameters, internal_np::relative_approximation_error_t>;
  static_assert(!has_error || !has_relative_error, "approximation_error and relative_approximation_error exclude each other");
  using parameters::get_parameter;
  if constexpr (has_error)
    return checked_positive("approximation_error", CGAL::to_double(get_parameter(np, internal_np::approximation_error)));
  else if constexpr (has_relative_error)
    return diagonal * checked_positive("relative_approximation_error",
                                       CGAL::to_double(get_parameter(np, internal_np::relative_approximation_error)));
  else
    return 0;
}

// The target length in `unit`. Both `unit` and the diagonal of the mesh are lengths as the embedding has them.
template <typename NamedParameters>
Target_length target_length(const NamedParameters& np, const double diagonal, const double unit,
                            const std::size_t number_of_faces)
{
  constexpr bool has_length = is_given<NamedParameters, internal_np::target_edge_length_t>,
                 has_relative_length = is_given<NamedParameters, internal_np::relative_target_edge_length_t>,
                 has_count = is_given<NamedParameters, internal_np::number_of_target_faces_t>,
                 has_sizes = is_given<NamedParameters, internal_np::sizing_field_t>;
  static_assert(!has_sizes || !(has_length || has_relative_length),
                "sizing_field excludes target_edge_length and relative_target_edge_length");
  static_assert(!is_error_given<NamedParameters> || !(has_length || has_relative_length),
                "an approximation error excludes a target length");
  static_assert(int(has_length) + int(has_relative_length) + int(has_count) <= 1,
                "target_edge_length, relative_target_edge_length and number_of_target_faces exclude each other");
  using parameters::get_parameter;
  if constexpr (has_length)
    return Target_length::of_length(
        checked_positive("target_edge_length", CGAL::to_double(get_parameter(np, internal_np::target_edge_length))) / unit);
  else if constexpr (has_relative_length)
    return Target_length::of_length(
        diagonal / unit *
        checked_positive("relative_target_edge_length",
                         CGAL::to_double(get_parameter(np, internal_np::relative_target_edge_length))));
  else if constexpr (has_count)
    return Target_length::of_number_of_faces(checked_count(
        "number_of_target_faces", get_parameter(np, internal_np::number_of_target_faces), largest_number_of_faces));
  else if constexpr (is_error_given<NamedParameters>)
    return Target_length::of_number_of_faces(largest_number_of_faces);
  else if constexpr (has_sizes)
    return Target_length::of_length(1); // the lengths are relative to the sizes
  else
    return Target_length::of_number_of_faces(number_of_faces);
}

// A length may ask for too many faces. Only the mesh can tell. The length is in the unit of the working mesh.
struct Too_many_faces
{
  double length, number_of_faces;
};

inline void check_number_of_faces(const Target_length& target)
{
  if (target.number_of_faces() > double(largest_number_of_faces))
    throw Too_many_faces{target.length(), target.number_of_faces()};
}

// `unit_of_lengths` is that of lengths in the embedding, in the caller's unit
template <typename NamedParameters>
[[noreturn]] void throw_too_many_faces(const Too_many_faces& too_many, const double unit_of_lengths)
{
  constexpr bool has_sizes = is_given<NamedParameters, internal_np::sizing_field_t>;
  throw_invalid_argument(has_sizes ? "the target edge length in units of sizing_field" : "the target edge length",
                         too_many.length * unit_of_lengths,
                         "so large that the mesh has at most " + text_of_number(double(largest_number_of_faces)) +
                             " faces, not about " + text_of_estimate(too_many.number_of_faces));
}

// All parameters for a mesh in `unit`. `embedding` is in this unit, the diagonal in the caller's. `is_by_error`: the measured error leads,
// whatever scheme the caller asks for.
template <typename NamedParameters, typename Embedding>
Remeshing_parameters remeshing_parameters(const NamedParameters& np, const Embedding& embedding, const bool is_by_error,
                                          const double diagonal, const double unit, const std::size_t number_of_faces)
{
  Remeshing_parameters result = iteration_parameters(np);
  if (is_by_error)
    result.scheme = Remeshing_scheme::MEASURED_ERROR;
  result.error = error_parameter(np, diagonal) / unit;
  result.target = target_length(np, embedding.unit_of_lengths(diagonal), embedding.unit_of_lengths(unit), number_of_faces);
  const bool has_measured_error = std::is_same<Embedding, Normal_embedding>::value &&
                                  (result.error > 0 || is_given<NamedParameters, internal_np::number_of_target_faces_t>);
  if (result.scheme == Remeshing_scheme::MEASURED_ERROR && !has_measured_error)
    result.scheme = Remeshing_scheme::EMBEDDING;
  if constexpr (!is_given<NamedParameters, internal_np::number_of_iterations_t>)
    result.number_of_iterations = default_number_of_iterations(result.scheme, result.error > 0);
  return result;
}

template <typename NamedParameters, typename... Names>
constexpr bool is_none_given = !(is_given<NamedParameters, Names> || ...);

// whether nothing is asked of the function
template <typename NamedParameters>
constexpr bool leaves_function_open =
    is_none_given<NamedParameters, internal_np::number_of_patches_t, internal_np::patch_overlap_t,
                  internal_np::offset_distance_t, internal_np::relative_offset_distance_t, internal_np::two_sided_offsets_t,
                  internal_np::smoothing_t, internal_np::points_on_facets_t, internal_np::detect_edges_t,
                  internal_np::radial_function_t, internal_np::vertex_normal_map_t>;

// Whether nothing is asked of the embedding or of the function. Then a mesh with few faces is remeshed by measured error.
template <typename NamedParameters>
constexpr bool leaves_embedding_and_function_open =
    (is_given<NamedParameters, internal_np::number_of_target_faces_t> || is_error_given<NamedParameters>)&&is_none_given<
        NamedParameters, internal_np::sigma_t, internal_np::relative_sigma_t, internal_np::embedding_t,
        internal_np::sizing_field_t, internal_np::project_borders_t, internal_np::split_ratio_t, internal_np::collapse_ratio_t,
        internal_np::smoothing_ratio_t, internal_np::number_of_relaxation_steps_t>&& leaves_function_open<NamedParameters>;

// Whether the measured error leads where an error is asked for, and nothing of the embedding or the function.
inline bool keeps_measured_error(const Remeshing_scheme scheme)
{
  return scheme == Remeshing_scheme::MEASURED_ERROR || scheme == Remeshing_scheme::DEFAULT;
}

// The same where nothing but a number of faces is asked for. The caller's scheme has the first word. `has_long_facets()` tells whether
// the facets of the input are exact.
template <typename HasLongFacets>
bool is_by_measured_error(const Remeshing_scheme scheme, const double number_of_target_faces, const std::size_t number_of_faces,
                          const HasLongFacets& has_long_facets)
{
  static constexpr double largest_ratio = 0.75; // of the number of faces to that of the input
  return scheme == Remeshing_scheme::MEASURED_ERROR ||
         (scheme == Remeshing_scheme::DEFAULT &&
          (number_of_target_faces <= largest_ratio * double(number_of_faces) || has_long_facets()));
}

// Whether the measured error leads, and no function is needed.
template <typename NamedParameters, typename HasLongFacets>
bool is_by_measured_error(const NamedParameters& np, const std::size_t number_of_faces, const HasLongFacets& has_long_facets)
{
  if (!allowed_operations(np).has_all_of_mesh())
    return false;
  if constexpr (leaves_embedding_and_function_open<NamedParameters> && is_error_given<NamedParameters>)
    return keeps_measured_error(iteration_parameters(np).scheme);
  else if constexpr (leaves_embedding_and_function_open<NamedParameters>)
    return is_by_measured_error(iteration_parameters(np).scheme, target_length(np, 1, 1, 1).number_of_faces(), number_of_faces,
                                has_long_facets);
  else
    return false;
}

// checks all that can be wrong with the parameters, before anything is computed
template <typename NamedParameters>
void check_parameters(const NamedParameters& np)
{
  const Remeshing_parameters parameters = iteration_parameters(np);
  embedding_parameter(np, 1);
  error_parameter(np, 1);
  if constexpr (is_given<NamedParameters, internal_np::gradation_t>)
    gradation_parameter(np);
  const Target_length target = target_length(np, 1, 1, 1);
  if (parameters.fit_to_surface && is_given<NamedParameters, internal_np::number_of_target_faces_t> &&
      !is_error_given<NamedParameters>)
    check_number_of_fitted_faces(target.number_of_faces());
}

// The creases and the regions of the faces. At a crease two regions of the surface meet, or one region has an edge inside. It has the
// same type whichever maps they are in.
template <typename TriangleMesh>
class Creases
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  // none, in one region
  Creases() = default;

  template <typename FaceRegionMap>
  explicit Creases(const FaceRegionMap face_region)
    : m_region([face_region](const Face f) { return static_cast<std::size_t>(get(face_region, f)); })
  {
  }

  template <typename EdgeIsCreaseMap, typename FaceRegionMap>
  Creases(const EdgeIsCreaseMap edge_is_crease, const FaceRegionMap face_region) : Creases(face_region)
  {
    m_is_crease = [edge_is_crease](const Edge e) { return bool(get(edge_is_crease, e)); };
  }

  typedef typename Graph_traits::edge_descriptor Edge;
  typedef typename Graph_traits::face_descriptor Face;
  bool is_crease(const Edge e) const { return m_is_crease && m_is_crease(e); }
  std::size_t region(const Face f) const { return m_region ? m_region(f) : 0; }

private:
  std::function<bool(Edge)> m_is_crease;
  std::function<std::size_t(Face)> m_region;
};

// If the caller gives a piecewise function, the patches are the regions. Otherwise there is one region.
template <typename Function, typename TriangleMesh, typename NamedParameters>
Creases<TriangleMesh> creases_of_caller(const NamedParameters& np)
{
  if constexpr (is_piecewise<Function>)
  {
    static_assert(is_given<NamedParameters, internal_np::face_patch_t>,
                  "a piecewise function needs face_patch_map, which tells the piece of each face");
    return Creases<TriangleMesh>(parameters::get_parameter(np, internal_np::face_patch));
  }
  else
  {
    (void)np;
    return Creases<TriangleMesh>();
  }
}

// The maps of constraints; without them nothing is constrained, and all faces are in one patch.
template <typename TriangleMesh, typename EdgeIsConstrainedMap, typename VertexIsConstrainedMap, typename FacePatchMap>
struct Mesh_constraints
{
  EdgeIsConstrainedMap edge_is_constrained;
  VertexIsConstrainedMap vertex_is_constrained;
  FacePatchMap face_patch;
  Creases<TriangleMesh> creases;
  bool protect_constraints;
};

template <typename TriangleMesh, typename NamedParameters>
auto mesh_constraints(const NamedParameters& np, const Creases<TriangleMesh>& creases)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const auto edges = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                      Static_boolean_property_map<typename Graph_traits::edge_descriptor, false>());
  const auto vertices = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                                         Static_boolean_property_map<typename Graph_traits::vertex_descriptor, false>());
  const auto patches = choose_parameter(get_parameter(np, internal_np::face_patch),
                                        Static_boolean_property_map<typename Graph_traits::face_descriptor, false>());
  return Mesh_constraints<TriangleMesh, std::decay_t<decltype(edges)>, std::decay_t<decltype(vertices)>,
                          std::decay_t<decltype(patches)>>{
      edges, vertices, patches, creases, choose_parameter(get_parameter(np, internal_np::protect_constraints), false)};
}

// whether elements of the caller's mesh keep their descriptors
template <typename NamedParameters>
constexpr bool is_constrained =
    is_given<NamedParameters, internal_np::edge_is_constrained_t> ||
    is_given<NamedParameters, internal_np::vertex_is_constrained_t> || is_given<NamedParameters, internal_np::face_patch_t> ||
    is_given<NamedParameters, internal_np::protect_constraints_t>;

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHING_PARAMETERS_H
