// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_RBF_SURFACE_RECONSTRUCTION_H
#define CGAL_RBF_SURFACE_RECONSTRUCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Reconstruction_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/input_of_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/parameter_types.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/reconstruct.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/tags.h>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

makes a triangle mesh of the surface through points with normals.

`Rbf_implicit_function` is built from the points. \cgal's surface mesher (`make_surface_mesh()`) meshes its zero set. If a
parameter of `anisotropic_hde_remeshing()` is given, such as a number of faces, the mesh is then remeshed on the function.

- The mesh is an orientable manifold. Its faces look outward, that is along the normals. It is closed, unless `close_holes(false)`
  is given: then it ends at the `Rbf_implicit_function::bounding_sphere()`.
- The mesh has all components of the zero set on which there are points, if they are further from each other than `facet_size`. It
  has no component without points. The mesher begins on each component with points that are put on the zero set. Parts that are
  too small for this are counted in `Anisotropic_hde_remeshing::Reconstruction_result::number_of_missed_places`.
- The vertices are on the zero set, up to 1e-4 of the smaller one of `facet_size` and `facet_distance`. After a remeshing they are
  where `anisotropic_hde_remeshing()` puts them.
- The mesher always ends. Let \f$ A \f$ be the area of the points, and of the bounding sphere if holes are closed. Let \f$ s \f$ be
  the size of the facets, \f$ d \f$ their distance, and \f$ h \f$ the spacing of the points. If nothing bends more sharply than
  the spacing can show, there is room for \f$ n = 1.155 A / \min(s^2, 2 d h) \f$ vertices. The function is evaluated at most
  \f$ 10^5 + 50 n \f$ times. Clean points take a tenth of that, or less. If more evaluations are needed, for example because of
  noise or outliers, an exception is thrown.
- The mesh is added to `output_mesh` in the end. If anything is thrown, `output_mesh` is as it was.

The mesher runs in one thread, in time proportional to the number of vertices and the time of an evaluation. The other steps are
parallel if `ConcurrencyTag` says so. The result is the same, in the same order.

\tparam ConcurrencyTag `Sequential_tag` (the default), `Parallel_tag` or `Parallel_if_available_tag`
\tparam PointRange a model of `ConstRange`
\tparam TriangleMesh a model of `MutableFaceGraph` with an internal point property map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points with normals
\param output_mesh gets the mesh
\param np optional named parameters among the ones below, those of `Rbf_implicit_function` for ranges of points, and those of
       `anisotropic_hde_remeshing()` that need no property map of the mesh

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points}
    \cgalParamDefault{`First_of_pair_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{the outward normals, of any length; zero where unknown}
    \cgalParamDefault{`Second_of_pair_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{smoothing}
    \cgalParamDescription{the standard deviation of the noise of the points, a length, or
                          `Anisotropic_hde_remeshing::AUTOMATIC_SMOOTHING`: it is estimated; see `Rbf_implicit_function`}
    \cgalParamDefault{0: the surface meets the points}
  \cgalParamNEnd
  \cgalParamNBegin{detect_outliers}
    \cgalParamDescription{whether points that their neighbours contradict are left out, and such normals are turned or dropped; see
                          `Rbf_implicit_function`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{facet_angle}
    \cgalParamDescription{the least angle of a facet of the surface mesher, in degrees}
    \cgalParamType{a number from 0 to 30}
    \cgalParamDefault{25}
  \cgalParamNEnd
  \cgalParamNBegin{facet_size}
    \cgalParamDescription{the largest radius of a ball about a facet of the surface mesher with its centre on the surface, a length.
                          Edges get about as long. Components and parts of the surface that are smaller may be missed.}
    \cgalParamType{a number, positive, and so large that the mesh gets at most 500,000,000 faces}
    \cgalParamDefault{the spacing of the points, `Rbf_diagnostics::median_spacing`: the mesh gets about as many vertices as there
                      are points, where these are even. With `number_of_target_faces` it is larger, so that the mesh has no more
                      faces, but at most four spacings}
  \cgalParamNEnd
  \cgalParamNBegin{facet_distance}
    \cgalParamDescription{the largest distance from the centre of this ball to that of the circumcircle of the facet, a length:
                          about how far facets may be from the surface}
    \cgalParamType{a number, positive, and so large that the mesh gets at most 500,000,000 faces}
    \cgalParamDefault{a tenth of `facet_size`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_target_faces}
    \cgalParamDescription{how many faces the result shall have, by `anisotropic_hde_remeshing()`}
    \cgalParamType{an integer from 1 to 500,000,000}
    \cgalParamDefault{as many as the surface mesher makes}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{learns of the progress of all three steps together. The first two are `Stage::IMPLICIT_FUNCTION`. If
                          it stops them, `Anisotropic_hde_remeshing::Interrupted` is thrown. If it stops the remeshing, the result
                          is the mesh reached by then.}
    \cgalParamType{a model of `RemeshingVisitor`}
    \cgalParamDefault{`Anisotropic_hde_remeshing::Remeshing_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what was found: holes, outliers, noise, components; and the sizes that were chosen

\throw std::runtime_error if the zero set is too rough to be meshed with these sizes, if there is none, or if it cannot be meshed as
       a manifold; the message says what may help
\throw std::invalid_argument if there are no points, a coordinate is not finite, all normals are zero, or a parameter is out of
       its range; the message names it
\throw Anisotropic_hde_remeshing::Interrupted if the visitor stops the function or the mesher

\sa `Rbf_implicit_function`
*/
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Anisotropic_hde_remeshing::Reconstruction_result
rbf_surface_reconstruction(const PointRange& points, TriangleMesh& output_mesh,
                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = Anisotropic_hde_remeshing::internal;
  Anisotropic_hde_remeshing::Reconstruction_result result;
  constexpr bool is_range = internal::Is_range<PointRange>::value;
  static_assert(is_range, "the surface is made of a range of points with normals");
  if constexpr (is_range)
    if constexpr (internal::accepts_mesh_to_write<TriangleMesh>())
      if constexpr (internal::accepts_parameters<internal::Parameters_of_reconstruction, PointRange, NamedParameters>())
        if constexpr (internal::accepts_input_of_function<internal::Radial_function_parameter<NamedParameters>, PointRange,
                                                          NamedParameters>())
          if constexpr (internal::accepts_parameters<internal::Parameters_of_remeshing, internal::Reconstructed_mesh,
                                                     NamedParameters>())
            copy_face_graph(internal::reconstruct<ConcurrencyTag>(points, np, result), output_mesh);
  return result;
}

} // namespace CGAL

#endif // CGAL_RBF_SURFACE_RECONSTRUCTION_H
