// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_EDGE_PROPERTY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_EDGE_PROPERTY_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_segment.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/majority.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

template <typename Mesh>
struct Marked_edges
{
  std::vector<Edge_of<Mesh>> edges;
  std::vector<std::array<Vector, 2>> segments;
};

template <typename Mesh, typename EdgeIsMarkedMap, typename NamedParameters>
Marked_edges<Mesh> marked_edges(const Mesh& mesh, const EdgeIsMarkedMap is_marked, const NamedParameters& np)
{
  const auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                get_const_property_map(vertex_point, mesh));
  const auto position = get(dynamic_vertex_property_t<std::size_t>(), mesh); // for messages
  std::size_t next_position = 0;
  for (const auto v : vertices(mesh))
    put(position, v, next_position++);
  const auto point = [&](const auto v) { return finite_vector(value_of(vpm, v), "point", get(position, v)); };
  Marked_edges<Mesh> result;
  for (const auto e : edges(mesh))
    if (get(is_marked, e))
    {
      result.edges.push_back(e);
      result.segments.push_back({{point(source(e, mesh)), point(target(e, mesh))}});
    }
  return result;
}

template <typename InputMesh, typename InputIsMarkedMap, typename InputPropertyMap, typename OutputMesh,
          typename OutputIsMarkedMap, typename OutputPropertyMap>
constexpr bool accepts_edge_transfer()
{
  constexpr bool has_input = is_readable_map<InputPropertyMap, Edge_of<InputMesh>>;
  static_assert(has_input, "input_property must be a property map with the edges of the input as keys");
  constexpr bool has_output =
      !has_input || is_writable_map<OutputPropertyMap, Edge_of<OutputMesh>, Value_of_map<InputPropertyMap, Edge_of<InputMesh>>>;
  static_assert(has_output,
                "output_property must be a writable property map from the edges of the output to the values of input_property");
  constexpr bool has_marks =
      Is_edge_boolean_map<InputIsMarkedMap, InputMesh>::value && Is_edge_boolean_map<OutputIsMarkedMap, OutputMesh>::value;
  static_assert(has_marks, "input_is_marked and output_is_marked must be property maps from the edges of the meshes to bool");
  return has_input && has_output && has_marks;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingTransfer

carries a property of edges along curves, such as the kind or the number of a feature line, from the mesh that was remeshed to the
result. The curves are the marked edges, usually those of `edge_is_constrained_map` before and after the call: they stay on their
polylines. A marked edge of the result gets the value of the marked edge of the input that is closest to it. If there are several
values, it gets the one with the largest part of its length, judged by 8 points that are spread evenly over it. Edges that are not
marked are not written.

\tparam InputMesh a model of `VertexListGraph` and `EdgeListGraph`
\tparam InputIsMarkedMap a model of `ReadablePropertyMap` with the edges of `input` as keys and `bool` as values
\tparam InputPropertyMap a model of `ReadablePropertyMap` with the edges of `input` as keys and values that can be copied and be
        compared by `==`
\tparam OutputMesh as `InputMesh`
\tparam OutputIsMarkedMap as `InputIsMarkedMap`, for `output`
\tparam OutputPropertyMap a model of `WritablePropertyMap` with the edges of `output` as keys
\tparam NamedParameters1 a sequence of named parameters
\tparam NamedParameters2 a sequence of named parameters

\param input a copy of the mesh that was given to `CGAL::anisotropic_hde_remeshing()`
\param input_is_marked which edges of it are curves
\param input_property the values at these edges
\param output the result
\param output_is_marked which edges of it are curves
\param output_property gets the values
\param np1 optional named parameters for `input`: `vertex_point_map`
\param np2 optional named parameters for `output`: `vertex_point_map`

\throw std::invalid_argument if a coordinate at a marked edge is not finite, or `output` has marked edges and `input` none of
       positive length; nothing is written then

\sa `transfer_face_property()`
*/
template <typename InputMesh, typename InputIsMarkedMap, typename InputPropertyMap, typename OutputMesh,
          typename OutputIsMarkedMap, typename OutputPropertyMap,
          typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
void transfer_edge_property(const InputMesh& input, const InputIsMarkedMap input_is_marked,
                            const InputPropertyMap input_property, const OutputMesh& output,
                            const OutputIsMarkedMap output_is_marked, OutputPropertyMap output_property,
                            const NamedParameters1& np1 = parameters::default_values(),
                            const NamedParameters2& np2 = parameters::default_values())
{
  if constexpr (internal::accepts_mesh<InputMesh>() && internal::accepts_mesh<OutputMesh>())
    if constexpr (internal::accepts_edge_transfer<InputMesh, InputIsMarkedMap, InputPropertyMap, OutputMesh, OutputIsMarkedMap,
                                                  OutputPropertyMap>())
    {
      typedef internal::Value_of_map<InputPropertyMap, internal::Edge_of<InputMesh>> Value;
      const auto from = internal::marked_edges(input, input_is_marked, np1);
      const auto to = internal::marked_edges(output, output_is_marked, np2);
      const internal::Closest_segment closest_segment(from.segments);
      if (!to.edges.empty() && closest_segment.empty())
        throw std::invalid_argument("the input has no marked edge of positive length, from which those of the output come");
      for (std::size_t i = 0; i < to.edges.size(); ++i)
      {
        std::array<std::size_t, 8> closest;
        for (std::size_t k = 0; k < closest.size(); ++k)
        {
          const double t = (double(k) + 0.5) / double(closest.size());
          closest[k] = closest_segment((1 - t) * to.segments[i][0] + t * to.segments[i][1]);
        }
        put(output_property, to.edges[i],
            internal::majority<Value>(closest, [&](const std::size_t k) { return Value(get(input_property, from.edges[k])); }));
      }
    }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_EDGE_PROPERTY_H
