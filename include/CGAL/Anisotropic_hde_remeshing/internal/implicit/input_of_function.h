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

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/sample_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <type_traits>

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

// what the caller gives, as it is: nothing is found out about it yet
template <typename MeshOrPointRange, typename NamedParameters>
Surface_sample sample_input(const MeshOrPointRange& input, const NamedParameters& np, Interruption& interruption)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if constexpr (Is_range<MeshOrPointRange>::value)
    return sample_points(input, point_map_of<MeshOrPointRange>(np), normal_map_of<MeshOrPointRange>(np), interruption);
  else
    return sample_mesh(
        input, choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, input)),
        get_parameter(np, internal_np::vertex_normal_map), interruption);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_INPUT_OF_FUNCTION_H
