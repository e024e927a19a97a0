// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_VERTEX_PROPERTY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_VERTEX_PROPERTY_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Input_location.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/first_halfedges.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Origin.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingTransfer

The mean of three values with given weights. The weights are not negative and have the sum 1. A value of weight 1 is the mean,
bit by bit. The values are
- numbers; the mean of integers is rounded to the nearest one, and that of `bool` is the value with more weight;
- vectors and all other types that can be added, and be multiplied by a `double` from the right;
- points;
- arrays, whose components are interpolated one by one;
- `CGAL::IO::Color`.
*/
struct Linear_interpolation
{
  /// \brief the mean of `values` with `weights`
  /// \tparam Value one of the types above
  template <typename Value>
  Value operator()(const std::array<Value, 3>& values, const std::array<double, 3>& weights) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (weights[k] == 1)
        return values[k];
    if constexpr (std::is_integral<Value>::value)
      return Value(
          std::llround(weights[0] * double(values[0]) + weights[1] * double(values[1]) + weights[2] * double(values[2])));
    else if constexpr (Is_point<Value>::value)
      return Value(values[0] + ((values[1] - values[0]) * weights[1] + (values[2] - values[0]) * weights[2]));
    else
      return Value(values[0] * weights[0] + values[1] * weights[1] + values[2] * weights[2]);
  }

  template <typename Component, std::size_t n>
  std::array<Component, n> operator()(const std::array<std::array<Component, n>, 3>& values,
                                      const std::array<double, 3>& weights) const
  {
    std::array<Component, n> result;
    for (std::size_t i = 0; i < n; ++i)
      result[i] = (*this)(std::array<Component, 3>{{values[0][i], values[1][i], values[2][i]}}, weights);
    return result;
  }

  IO::Color operator()(const std::array<IO::Color, 3>& values, const std::array<double, 3>& weights) const
  {
    std::array<unsigned char, 4> channels;
    for (std::size_t i = 0; i < channels.size(); ++i)
      channels[i] = (*this)(std::array<unsigned char, 3>{{values[0][i], values[1][i], values[2][i]}}, weights);
    return IO::Color(channels[0], channels[1], channels[2], channels[3]);
  }

private:
  // A point has a difference to the origin. It cannot be multiplied by a number.
  template <typename T, typename = void>
  struct Is_point : std::false_type
  {
  };
  template <typename T>
  struct Is_point<T, std::void_t<decltype(std::declval<const T&>() - ORIGIN)>> : std::true_type
  {
  };
};

/*!
\ingroup PkgAnisotropicHdeRemeshingTransfer

The value of the largest weight of three: that of the nearest vertex of the face, in barycentric coordinates. It is for labels, which
must not be interpolated. If weights are equal, the value that comes first is taken.
*/
struct Nearest_value
{
  /// \brief the one of `values` with the largest of `weights`
  /// \tparam Value any type that can be copied
  template <typename Value>
  Value operator()(const std::array<Value, 3>& values, const std::array<double, 3>& weights) const
  {
    const std::size_t k = weights[1] > weights[0] ? 1 : 0;
    return values[weights[2] > weights[k] ? 2 : k];
  }
};

namespace internal {

// whether the maps are accepted; if not, an error of the compiler says what is wrong
template <typename InputMesh, typename InputPropertyMap, typename OutputMesh, typename VertexLocationMap,
          typename OutputPropertyMap>
constexpr bool accepts_transfer()
{
  typedef Value_of_map<InputPropertyMap, Vertex_of<InputMesh>> Value;
  constexpr bool has_input = is_readable_map<InputPropertyMap, Vertex_of<InputMesh>>;
  static_assert(has_input, "input_property must be a property map with the vertices of the input as keys");
  constexpr bool has_locations =
      std::is_convertible<Value_of_map<VertexLocationMap, Vertex_of<OutputMesh>>, Input_location>::value;
  static_assert(has_locations, "vertex_location must be a property map from the vertices of the output to Input_location");
  constexpr bool has_output = !has_input || is_writable_map<OutputPropertyMap, Vertex_of<OutputMesh>, Value>;
  static_assert(has_output, "output_property must be a writable property map from the vertices of the output to the values of "
                            "input_property");
  return has_input && has_locations && has_output;
}

// Throws std::invalid_argument if a vertex comes from no face of the input.
template <typename OutputMesh, typename VertexLocationMap>
void check_locations(const OutputMesh& output, const VertexLocationMap vertex_location, const std::size_t number_of_faces)
{
  std::size_t position = 0;
  for (const auto v : vertices(output))
  {
    const Input_location location = get(vertex_location, v);
    if (!location.has_face())
      throw std::invalid_argument("vertex " + std::to_string(position) +
                                  " of the output has no location: it is isolated, or vertex_location was not written for it");
    if (location.face >= number_of_faces)
      throw_invalid_argument("the face of the location of vertex " + std::to_string(position), location.face,
                             "below the number of faces of the input, " + std::to_string(number_of_faces));
    ++position;
  }
}

template <typename InputMesh, typename InputPropertyMap, typename OutputMesh, typename VertexLocationMap,
          typename OutputPropertyMap, typename Interpolation>
void transfer_vertex_values(const InputMesh& input, const InputPropertyMap input_property, const OutputMesh& output,
                            const VertexLocationMap vertex_location, OutputPropertyMap output_property,
                            const Interpolation& interpolation)
{
  typedef Value_of_map<InputPropertyMap, Vertex_of<InputMesh>> Value; // what `get` returns may be a proxy of it
  const auto first_halfedges = internal::first_halfedges(input);
  check_locations(output, vertex_location, first_halfedges.size());
  for (const auto v : vertices(output))
  {
    const Input_location location = get(vertex_location, v);
    const auto h = first_halfedges[location.face];
    const std::array<Value, 3> values{{Value(get(input_property, source(h, input))),
                                       Value(get(input_property, target(h, input))),
                                       Value(get(input_property, target(next(h, input), input)))}};
    put(output_property, v, interpolation(values, location.barycentric_coordinates));
  }
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingTransfer

carries a property of the vertices, such as colours, texture coordinates or a solution, from the mesh that was remeshed to the
result. Every vertex of the result comes from a place in a face of the input. It gets the mean of the values at the vertices of
this face, weighted by its barycentric coordinates. Discontinuities at vertices, such as the seams of a texture, are not seen.

\tparam InputMesh a model of `FaceListGraph`
\tparam InputPropertyMap a model of `ReadablePropertyMap` with the vertices of `input` as keys
\tparam OutputMesh a model of `VertexListGraph`
\tparam VertexLocationMap a model of `ReadablePropertyMap` with the vertices of `output` as keys and `Input_location` as values
\tparam OutputPropertyMap a model of `WritablePropertyMap` with the vertices of `output` as keys
\tparam Interpolation a functor like `Linear_interpolation` or `Nearest_value`

\param input a copy of the mesh that was given to `CGAL::anisotropic_hde_remeshing()`, made before the call. Its vertices and
       faces must be in the same order. The copy constructor keeps the order, `CGAL::copy_face_graph()` does not.
\param input_property the values at its vertices
\param output the result
\param vertex_location the map that was given by the name `vertex_location_map`
\param output_property gets the values
\param interpolation how three values are joined to one: `Nearest_value()` for labels

\throw std::invalid_argument if a vertex has no location, or one on a face that `input` does not have; nothing is written then
*/
template <typename InputMesh, typename InputPropertyMap, typename OutputMesh, typename VertexLocationMap,
          typename OutputPropertyMap, typename Interpolation = Linear_interpolation>
void transfer_vertex_property(const InputMesh& input, const InputPropertyMap input_property, const OutputMesh& output,
                              const VertexLocationMap vertex_location, OutputPropertyMap output_property,
                              const Interpolation& interpolation = Interpolation())
{
  constexpr bool are_meshes = internal::accepts_mesh<InputMesh>() && internal::accepts_mesh<OutputMesh>();
  if constexpr (are_meshes)
    if constexpr (internal::accepts_transfer<InputMesh, InputPropertyMap, OutputMesh, VertexLocationMap, OutputPropertyMap>())
      internal::transfer_vertex_values(input, input_property, output, vertex_location, output_property, interpolation);
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_VERTEX_PROPERTY_H
