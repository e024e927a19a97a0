// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INPUT_OF_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INPUT_OF_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_edges.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Hole_rims.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Points_on_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/estimate_noise.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/mark_apexes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What `Rbf_implicit_function` is built from: a mesh, or a range of points with normals. What differs between the two is here.

template <typename RadialFunction, typename NamedParameters>
constexpr bool accepts_kernel()
{
  typedef Given_type<NamedParameters, internal_np::radial_function_t> Given;
  constexpr bool is_kernel =
      std::is_same<Given, internal_np::Param_not_found>::value || std::is_convertible<Given, RadialFunction>::value;
  static_assert(is_kernel, "the named parameter radial_function takes an object of the second template argument of "
                           "Rbf_implicit_function");
  return is_kernel;
}

template <typename MeshOrPointRange, typename NamedParameters>
constexpr bool has_points_and_normals()
{
  if constexpr (!Is_range<MeshOrPointRange>::value ||
                !(parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value ||
                  parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value))
    return true;
  else
  {
    constexpr bool has_pairs = Is_pair<Value_of_range<MeshOrPointRange>>::value;
    static_assert(has_pairs, "a range of points needs point_map and normal_map, unless its elements are pairs");
    return has_pairs;
  }
}

// whether the input and the types of the parameters are accepted; if not, an error of the compiler says what is wrong
template <typename RadialFunction, typename MeshOrPointRange, typename NamedParameters>
constexpr bool accepts_input_of_function()
{
  constexpr bool is_range = Is_range<MeshOrPointRange>::value;
  constexpr bool is_input = is_range || Is_face_graph<MeshOrPointRange>::value;
  static_assert(is_input,
                "the implicit function is built from a model of FaceListGraph or from a range of points with normals");
  if constexpr (!is_input)
    return false;
  else
  {
    typedef std::conditional_t<is_range, Parameters_of_function_of_range, Parameters_of_function_of_mesh> Parameters;
    if constexpr (accepts_parameters<Parameters, MeshOrPointRange, NamedParameters>())
      return accepts_kernel<RadialFunction, NamedParameters>() && has_points_and_normals<MeshOrPointRange, NamedParameters>();
    else
      return false;
  }
}

// The defaults ask for pairs, so they are instantiated only where they are used.
template <typename PointRange, typename NamedParameters>
auto point_map_of(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value)
    return First_of_pair_property_map<Value_of_range<PointRange>>();
  else
    return parameters::get_parameter(np, internal_np::point_map);
}

template <typename PointRange, typename NamedParameters>
auto normal_map_of(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value)
    return Second_of_pair_property_map<Value_of_range<PointRange>>();
  else
    return parameters::get_parameter(np, internal_np::normal_map);
}

inline void check_sample(const Surface_sample& sample)
{
  if (sample.size() == 0)
    throw std::invalid_argument("the input has no points");
  bool has_normal = false, has_spacing = false;
  for (std::size_t i = 0; i < sample.size(); ++i)
  {
    has_normal = has_normal || !sample.normals[i].isZero(0);
    has_spacing = has_spacing || sample.spacings[i] > 0;
  }
  if (!has_normal || !has_spacing)
    throw std::invalid_argument("the input has no point with a normal: all its faces are degenerate");
}

// Throws if no function can be built from it. Finds out the noise, if that is asked for; it is in the unit of the sample.
template <typename ConcurrencyTag, typename MeshOrPointRange, typename NamedParameters>
std::shared_ptr<const Surface_sample> sample_input(const MeshOrPointRange& input, const NamedParameters& np,
                                                   Interpolation_parameters& interpolation, Interruption& interruption)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Surface_sample sample;
  if constexpr (Is_range<MeshOrPointRange>::value)
    sample = sample_points<ConcurrencyTag>(input, point_map_of<MeshOrPointRange>(np), normal_map_of<MeshOrPointRange>(np),
                                           interpolation.detects_outliers, interpolation.closes_holes, interruption);
  else
    sample = sample_mesh(
        input, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, input)),
        get_parameter(np, internal_np::vertex_normal_map), interruption);
  check_sample(sample);
  if (interpolation.closes_holes && !sample.facets.empty())
    find_rims_of_mesh<ConcurrencyTag>(sample, interruption);
  interpolation.noise *= sample.normalization.scale;
  if (interpolation.estimates_noise)
    interpolation.noise = estimate_noise<ConcurrencyTag>(sample, interruption);
  if (interpolation.noise > 0)
    interpolation.mistrust_facets();
  if ((interpolation.uses_facets || interpolation.finds_edges) && !sample.facets.empty())
  {
    const Facet_edges edges(sample);
    if (interpolation.finds_edges)
    {
      mark_edges(sample, edges);
      mark_apexes(sample, edges);
    }
    if (interpolation.uses_facets)
      add_points_on_facets<ConcurrencyTag>(sample, edges, interpolation.keeps_vertices, interruption);
  }
  return std::make_shared<const Surface_sample>(std::move(sample));
}

// the signed distance to the input
template <typename MeshOrPointRange>
std::shared_ptr<const Signed_distance> distance_to_input(const std::shared_ptr<const Surface_sample>& sample)
{
  typedef std::conditional_t<Is_range<MeshOrPointRange>::value, Point_distance, Facet_distance> Distance;
  return std::make_shared<const Distance>(sample);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INPUT_OF_FUNCTION_H
