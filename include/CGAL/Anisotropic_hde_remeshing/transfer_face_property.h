// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_FACE_PROPERTY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_FACE_PROPERTY_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/majority.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// Points spread evenly over a face: the centroids of the parts into which lines parallel to its sides divide it.
inline const std::array<Vector, 16>& points_of_face()
{
  static const std::array<Vector, 16> result = []
  {
    static constexpr int n = 4;
    std::array<Vector, n * n> weights;
    std::size_t next = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
      {
        weights[next++] = Vector(i + 1. / 3, j + 1. / 3, n - i - j - 2. / 3) / n; // upright
        if (i + j < n - 1)
          weights[next++] = Vector(i + 2. / 3, j + 2. / 3, n - i - j - 4. / 3) / n; // upside down
      }
    return weights;
  }();
  return result;
}

template <typename InputMesh, typename InputPropertyMap, typename OutputMesh, typename OutputPropertyMap>
constexpr bool accepts_face_transfer()
{
  constexpr bool has_input = is_readable_map<InputPropertyMap, Face_of<InputMesh>>;
  static_assert(has_input, "input_property must be a property map with the faces of the input as keys");
  constexpr bool has_output =
      !has_input || is_writable_map<OutputPropertyMap, Face_of<OutputMesh>, Value_of_map<InputPropertyMap, Face_of<InputMesh>>>;
  static_assert(has_output,
                "output_property must be a writable property map from the faces of the output to the values of input_property");
  return has_input && has_output;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingTransfer

carries a property of the faces, such as labels or materials, from the mesh that was remeshed to the result. A face gets the
value of the closest face of the input. If there are several values, it gets the one with the largest part of its area, judged by 16
points that are spread evenly over it. The values are not interpolated.

`face_patch_map` of `CGAL::anisotropic_hde_remeshing()` does more: it keeps the lines between labels. This function is for labels
that shall not constrain the mesh.

\tparam ConcurrencyTag `Sequential_tag` (the default), `Parallel_tag` or `Parallel_if_available_tag`: how the closest faces are
       found. The property maps are asked by one thread.
\tparam InputMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam InputPropertyMap a model of `ReadablePropertyMap` with the faces of `input` as keys and values that can be copied and be
        compared by `==`
\tparam OutputMesh as `InputMesh`
\tparam OutputPropertyMap a model of `WritablePropertyMap` with the faces of `output` as keys
\tparam NamedParameters1 a sequence of named parameters
\tparam NamedParameters2 a sequence of named parameters

\param input a copy of the mesh that was given to `CGAL::anisotropic_hde_remeshing()`
\param input_property the values at its faces
\param output the result
\param output_property gets the values
\param np1 optional named parameters for `input`: `vertex_point_map` and `geom_traits`
\param np2 optional named parameters for `output`: `vertex_point_map` and `geom_traits`

\throw std::invalid_argument if a face is not a triangle, a coordinate is not finite, or `output` has faces and all of `input` are
       degenerate; nothing is written then

\sa `transfer_vertex_property()`
\sa `transfer_edge_property()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename InputMesh, typename InputPropertyMap, typename OutputMesh,
          typename OutputPropertyMap, typename NamedParameters1 = parameters::Default_named_parameters,
          typename NamedParameters2 = parameters::Default_named_parameters>
void transfer_face_property(const InputMesh& input, const InputPropertyMap input_property, const OutputMesh& output,
                            OutputPropertyMap output_property, const NamedParameters1& np1 = parameters::default_values(),
                            const NamedParameters2& np2 = parameters::default_values())
{
  if constexpr (internal::accepts_measurement<InputMesh, NamedParameters1>() &&
                internal::accepts_measurement<OutputMesh, NamedParameters2>())
    if constexpr (internal::accepts_face_transfer<InputMesh, InputPropertyMap, OutputMesh, OutputPropertyMap>())
    {
      typedef internal::Value_of_map<InputPropertyMap, internal::Face_of<InputMesh>> Value;
      const internal::Measured_mesh from = internal::read_measured_mesh(input, np1),
                                    to = internal::read_measured_mesh(output, np2);
      const internal::Closest_facet closest_facet(from.points, from.faces);
      if (!to.faces.empty() && closest_facet.empty())
        throw std::invalid_argument("the input has no face that is not degenerate");
      std::vector<std::array<std::size_t, 16>> below(to.faces.size());
      internal::parallel_for<ConcurrencyTag>(
          below.size(),
          [&](const std::size_t i)
          {
            const internal::Facet& face = to.faces[i];
            for (std::size_t k = 0; k < below[i].size(); ++k)
            {
              const internal::Vector& weights = internal::points_of_face()[k];
              below[i][k] = closest_facet(weights[0] * to.points[face[0]] + weights[1] * to.points[face[1]] +
                                          weights[2] * to.points[face[2]])
                                .facet;
            }
          },
          16);
      const std::vector<internal::Face_of<InputMesh>> input_faces(faces(input).begin(), faces(input).end());
      std::size_t i = 0;
      for (const auto f : faces(output))
        put(output_property, f,
            internal::majority<Value>(below[i++],
                                      [&](const std::size_t k) { return Value(get(input_property, input_faces[k])); }));
    }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TRANSFER_FACE_PROPERTY_H
