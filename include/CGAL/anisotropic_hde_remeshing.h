// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_scheme.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_on_surface.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

remeshes a triangle mesh so that it becomes uniform and isotropic in the embedding \f$ (x, \sigma n(x)) \f$ in \f$ R^6 \f$.

In space, the mesh is then adapted to the curvature and stretched along the directions of low curvature. The operations are splits,
contractions and flips of edges, and smoothing of vertices. Every vertex inside the surface is put on the zero set of
`function`. The boundary edges, the constrained edges and the edges between patches form polylines in the input. Vertices of
these edges stay on the polylines. The ends, the branchings and the turns of more than 60 degrees of the polylines are kept. A
closed polyline keeps at least 0.85 of its length. With `project_borders`, boundaries are put on the zero set, too.

One smooth function rounds sharp edges that are not constrained. A piecewise function has a smooth piece for each region of the
surface. The edges between two regions are the creases. They are kept:
- A face uses the normals of its own region at its vertices. A vertex on a crease has one normal for each region there.
- Creases are split, contracted and smoothed along themselves. An edge on a crease has a 6D length on each side; the larger one
  counts. No other operation crosses a crease.
- New and moved vertices of a crease are on the polyline of the input. There is one exception: places where the polyline goes
  along an arc, evenly and in steps of less than 6 degrees, and the zero sets of both regions meet at more than 15 degrees.
  There these vertices are put where the zero sets meet. They leave the polyline by at most twice the height of the arc over it,
  and at most 5e-4 of the diagonal of the bounding box.
- Corners do not move. They are the ends, branchings and turns mentioned above.
- If there are creases, the edges on curves follow these curves closely. Each edge replaces a part of a curve of the input. No
  point of this part is further than 5e-5 of the diagonal of the bounding box from the edge.

The following holds for any orientable manifold triangle mesh, any finite parameters and any number of threads. Anything else is
refused before `tmesh` is touched.
- The call ends. The result is valid, manifold and consistently oriented. It has the components, the boundary loops and the
  Euler characteristic of the input.
- No face is folded. A face is folded if it looks against the normals at its vertices. There is one exception: a face may be folded
  if it replaces a flat face, or a face that was folded more. There are not more edges than before over which two faces turn by more
  than 143 degrees. No face becomes degenerate.
- Vertices that are not on the zero set are counted in the result.
- No more pairs of faces intersect than before. If the input had none, the result has none. Both numbers are in the result. This
  does not hold with `do_self_intersection_tests(false)`, nor where the coordinates are not of `double` and are rounded.
- The result does not depend on the number of threads.
- If an exception is thrown, `tmesh` is as it was before. So are the values of the property maps at its elements, except those
  of `vertex_location_map`. Property maps that `tmesh` itself keeps are written when nothing can fail any more. Other maps may
  throw: they are written while the old elements are still there, and their old values are put back if necessary.

If constraints are given, some elements keep their descriptors: constrained vertices, the ends, branchings and turns mentioned
above, and protected edges. If no constraints are given, all elements are replaced: descriptors become invalid, and isolated
vertices are dropped.

A `Surface_mesh` marks removed elements as garbage. After a call with constraints or for a range of faces, the elements that were
replaced are garbage, as after \cgal's other functions, and descriptors are valid until the caller calls `collect_garbage()`. After
a call that replaces all elements, there is no garbage. There is one exception: a mesh that had garbage before, and whose points or
locations are in a map that it does not keep itself.

\tparam ConcurrencyTag `Sequential_tag` (the default), `Parallel_tag` or `Parallel_if_available_tag`
\tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
\tparam Function a model of `ImplicitFunctionWithGradient` or of `PiecewiseImplicitFunction`. The first may be
        `Rbf_implicit_function`, or a function of the user's own with a nested type `Point_3`, `FT operator()(Point_3) const`
        and `Vector_3 gradient(Point_3) const`. The second may be `Piecewise_rbf_implicit_function`. A piecewise function needs
        `face_patch_map`: the patch of a face is the number of its piece. All functions are called concurrently unless
        `ConcurrencyTag` is `Sequential_tag`.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh, an orientable manifold, possibly with boundary
\param function the function whose zero set is the surface. The zero set lies near the mesh. If the function is piecewise, the
       zero set of each piece lies near the faces of the piece.
\param np optional named parameters among the ones below

\cgalNamedParamsBegin
  \cgalParamNBegin{sigma}
    \cgalParamDescription{the weight \f$ \sigma \f$ of the normals, a length in the unit of the mesh. A typical radius of
                          curvature is a natural choice; 0 makes the mesh isotropic in space.}
    \cgalParamType{a number, not negative}
    \cgalParamDefault{0.01 of the diagonal of the bounding box}
  \cgalParamNEnd
  \cgalParamNBegin{relative_sigma}
    \cgalParamDescription{\f$ \sigma \f$ as a share of the diagonal of the bounding box; excludes `sigma`}
    \cgalParamType{a number, not negative}
    \cgalParamDefault{0.01}
  \cgalParamNEnd
  \cgalParamNBegin{embedding}
    \cgalParamDescription{the embedding in which the mesh becomes uniform and isotropic, in place of the paper's. It excludes
                          `sigma` and `relative_sigma`. `Anisotropic_hde_remeshing::Curvature_metric` is for a small distance to
                          the surface, `Anisotropic_hde_remeshing::Adaptive_normal_embedding` is for meshes of which no scale is
                          known, `Anisotropic_hde_remeshing::Scalar_field_embedding` is for a field that is to be resolved.}
    \cgalParamType{a model of `RemeshingEmbedding` or of `RemeshingMetric`}
    \cgalParamDefault{`Anisotropic_hde_remeshing::Normal_embedding` with \f$ \sigma \f$. If an approximation error is given and
                      sigma is not: `Anisotropic_hde_remeshing::Curvature_metric` with \f$ p = \infty \f$. If a sizing field is
                      given and sigma is not: `Anisotropic_hde_remeshing::Normal_embedding` with \f$ \sigma = 0 \f$, as in
                      `Polygon_mesh_processing::isotropic_remeshing()`, so that the sizes are lengths in space}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{the length that edges shall have at each place, in the embedding, in the unit of the mesh. With
                          `number_of_target_faces` or an approximation error the sizes tell the proportions only. In a metric,
                          faces have the area of an equilateral triangle of that size, and the bounds of the metric hold, too.
                          Sizes should change by no more than half of a length over that length: triangles become thin where they
                          change faster; see `gradation`. It excludes `target_edge_length` and `relative_target_edge_length`.}
    \cgalParamType{one of these: a function object that takes a point of `vertex_point_map`, is defined on and near the surface,
                   and may be called concurrently; a model of `ReadablePropertyMap` with the vertices of `tmesh` as keys, read once
                   for each vertex of the faces that are remeshed; or a model of \cgal's `PMPSizingField`, of which there are two
                   since \cgal 6.0, whose `at()` is asked once for each of these vertices. Between vertices the size is interpolated
                   linearly on the faces of the input. All return numbers, positive and finite. `std::ref()` avoids a copy.}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{gradation}
    \cgalParamDescription{how much the sizes of `sizing_field` may grow along a path, over the length of the path. The size at a
                          vertex of the input is at most that at any other one plus `gradation` times the shortest path along the
                          edges. For this a function is evaluated at the vertices. Between the vertices its own value counts where
                          it is less than what the vertices allow. So a mesh that is too coarse for the function limits it less.}
    \cgalParamType{a number, positive; 0.2 to 0.5 is good}
    \cgalParamDefault{sizes grow as the field has it}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length that the edges shall have in \f$ R^6 \f$, in the unit of the mesh}
    \cgalParamType{a number, positive, and so large that the mesh gets at most 500,000,000 faces}
    \cgalParamDefault{follows from `number_of_target_faces`}
  \cgalParamNEnd
  \cgalParamNBegin{relative_target_edge_length}
    \cgalParamDescription{the same as a share of the diagonal of the bounding box; excludes `target_edge_length`}
    \cgalParamType{a number, positive}
    \cgalParamDefault{follows from `number_of_target_faces`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_target_faces}
    \cgalParamDescription{how many faces the result shall have; excludes a target length}
    \cgalParamType{an integer from 1 to 500,000,000}
    \cgalParamDefault{as many as it had}
  \cgalParamNEnd
  \cgalParamNBegin{approximation_error}
    \cgalParamDescription{the largest distance that the mesh shall have from the surface, in the unit of the mesh. The mesh
                          gets about as few faces as this takes. It gets at most `number_of_target_faces` if that is given, too.
                          If neither a function nor an embedding is given, it is the distance between the mesh and the facets of
                          the input, both ways, outlines included, and the mesh gets no more faces than the input. Otherwise it is
                          the distance from the faces to the zero set. It is measured at the points of a grid on every face.
                          Between the points, second differences bound it. Faces are split until the bound holds, or until they are
                          too small to be split. Faces at boundary and constrained curves may be further away, by as much as these
                          curves are away from the surface. The bound that was reached is in
                          `Anisotropic_hde_remeshing::Remeshing_result::approximation_error`. Excludes a target length.}
    \cgalParamType{a number, positive}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{relative_approximation_error}
    \cgalParamDescription{the same as a share of the diagonal of the bounding box; excludes `approximation_error`}
    \cgalParamType{a number, positive}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{fit_to_surface}
    \cgalParamDescription{whether the vertices leave the surface in the end, along their normals. They go where the integral of
                          the squared distance between faces and surface is least. Where the surface is curved to one side, the
                          root mean square of the distance falls to about a quarter. Vertices of curves and fixed vertices
                          stay. By measured error, vertices are off the surface anyway. Then this asks for the least distance:
                          there are more iterations, and long triangles cost hardly anything.}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{shape_weight}
    \cgalParamDescription{by measured error only: the cost of a long face. The ratio of its longest edge to the altitude over it
                          costs nothing up to 4. Each 4 more cost `shape_weight` mean errors of a face, up to six times as much.
                          With 0, triangles are as long as is best for the distance. Large weights make them rounder, and the
                          distance larger.}
    \cgalParamType{a number, 0 or more}
    \cgalParamDefault{2; 0.1 with `fit_to_surface`}
  \cgalParamNEnd
  \cgalParamNBegin{aspect_ratio_bound}
    \cgalParamDescription{by measured error only: the largest ratio of the longest edge to the altitude over it, for meshes to
                          compute on. No operation makes a face exceed it, and faces beyond it are expensive. Some faces cannot be
                          better, for example between creases and beside constrained edges. They stay.
                          `Anisotropic_hde_remeshing::Remeshing_result::number_of_faces_beyond_aspect_ratio` counts them, in all
                          schemes.}
    \cgalParamType{a number, 1.2 or more; an equilateral triangle has 1.15}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{project_borders}
    \cgalParamDescription{whether the vertices of the boundary are put on the zero set, too. Otherwise they stay on the boundary
                          of the input, which is off the surface by the height of its edges, or as far as the input is. A vertex
                          goes from the polyline to the zero set in the plane of the boundary there, the plane of three edges in a
                          row, so a boundary that a plane has cut stays in this plane. Where the boundary is straight, or the zero
                          set is nearly parallel to that plane, by less than 10 degrees, the vertex goes perpendicular to the
                          boundary. Corners, that is turns of more than 60 degrees and places where the boundary goes from one
                          plane into another by more than 30 degrees, go along the line where both planes meet. No vertex goes
                          further than half of an edge of the boundary. Vertices that do not reach the zero set in this way stay.
                          They are counted in `Anisotropic_hde_remeshing::Remeshing_result::number_of_unprojected_vertices`.
                          Constrained vertices, protected boundaries, the ends of other curves at the boundary, and the border of
                          a range of faces stay in any case. By measured error there is no zero set. If this is `true`, a function
                          is built.}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how often the sequence of operations is done. With 0, the vertices are only projected. By measured
                          error, the mesh is only coarsened. If an error is asked for, it is measured, but the mesh is not
                          refined.}
    \cgalParamType{an integer from 0 to 1,000,000}
    \cgalParamDefault{10; by measured error 4, with an error that is asked for 6, and 0 if more faces are asked for than there
                      are: after the splits they are on the input}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_relaxation_steps}
    \cgalParamDescription{how often an iteration smooths; not used by the scheme of the paper}
    \cgalParamType{an integer from 0 to 1,000,000}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{remeshing_scheme}
    \cgalParamDescription{the order of the operations}
    \cgalParamType{`Anisotropic_hde_remeshing::Remeshing_scheme`}
    \cgalParamDefault{`DEFAULT`. With a function of the caller's this is `EMBEDDING`.}
  \cgalParamNEnd
  \cgalParamNBegin{split_ratio}
    \cgalParamDescription{edges longer than this multiple of the target length are split}
    \cgalParamType{a number from 1 to 100}
    \cgalParamDefault{4/3; 3/2 in the scheme of the paper}
  \cgalParamNEnd
  \cgalParamNBegin{collapse_ratio}
    \cgalParamDescription{edges shorter than this multiple of the target length are contracted}
    \cgalParamType{a number from 0 to 1}
    \cgalParamDefault{4/5; 1/2 in the scheme of the paper}
  \cgalParamNEnd
  \cgalParamNBegin{smoothing_ratio}
    \cgalParamDescription{the share of the vertices that a smoothing moves, those with the smallest angles first}
    \cgalParamType{a number from 0 to 1}
    \cgalParamDefault{1; 0.3 in the scheme of the paper}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that the result must have. They stay as they are, or are subdivided or joined along their
                          polylines. The map is set for the edges of the result.}
    \cgalParamType{a model of `ReadWritePropertyMap` with the edges of `tmesh` as keys and `bool` as values}
    \cgalParamDefault{no edge is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the vertices that stay as they are}
    \cgalParamType{a model of `ReadablePropertyMap` with the vertices of `tmesh` as keys and `bool` as values}
    \cgalParamDefault{no vertex is constrained}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the patches of the faces. The result keeps them: edges between two patches are constrained. With a
                          piecewise function, the patches are the numbers of the pieces, and edges between two pieces are
                          creases. The map is set for the faces of the result.}
    \cgalParamType{a model of `ReadWritePropertyMap` with the faces of `tmesh` as keys and any values that can be compared by
                   `==`; with a piecewise function, values that are convertible to `std::size_t`, too}
    \cgalParamDefault{all faces are in one patch; a piecewise function needs it}
  \cgalParamNEnd
  \cgalParamNBegin{protect_constraints}
    \cgalParamDescription{whether boundary edges, constrained edges and edges between patches stay as they are, too}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{collapse_constraints}
    \cgalParamDescription{whether boundary edges, constrained edges and edges between patches are contracted, along their polylines}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{relax_constraints}
    \cgalParamDescription{whether the vertices of these edges are smoothed, along their polylines. By measured error they are not in
                          any case.}
    \cgalParamType{bool}
    \cgalParamDefault{`true` (in `Polygon_mesh_processing::isotropic_remeshing()` it is `false`)}
  \cgalParamNEnd
  \cgalParamNBegin{do_split}
    \cgalParamDescription{whether edges are split. If this or one of the next two is `false`, the number of faces or the error asked
                          for may be out of reach, and the default scheme is not the measured error.}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{do_collapse}
    \cgalParamDescription{whether edges are contracted}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{do_flip}
    \cgalParamDescription{whether edges are flipped}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{do_self_intersection_tests}
    \cgalParamDescription{whether operations are refused that would let more pairs of faces of `tmesh` intersect. Operations are
                          tested where two sheets of the input are as near to each other as the surface rises above the edges. All
                          faces are looked at after the first and some of the later iterations, and in the end. Where pairs
                          intersect that have not before, what was done since the last look is done again, and tests there, too.
                          For the visitor the progress goes back then. If there are no near sheets, the tests cost a few per cent.
                          If they are everywhere, they cost up to as much as the remeshing}
    \cgalParamType{bool}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_location_map}
    \cgalParamDescription{is set to the closest point of the input for every vertex of the result. It is also set for vertices
                          that are not remeshed, and if the mesh stays as it was. The location of a vertex that stays is this
                          vertex. An isolated vertex that stays is on no face:
                          `Anisotropic_hde_remeshing::Input_location::no_face`. See
                          `Anisotropic_hde_remeshing::transfer_vertex_property()`}
    \cgalParamType{a model of `WritablePropertyMap` with the vertices of `tmesh` as keys and
                   `Anisotropic_hde_remeshing::Input_location` as values}
    \cgalParamDefault{not computed}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{learns of the progress and may stop the remeshing}
    \cgalParamType{a model of `RemeshingVisitor`}
    \cgalParamDefault{`Anisotropic_hde_remeshing::Remeshing_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamDefault{`get_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what was done, and the parameters that were chosen

\throw std::invalid_argument if `tmesh` has no faces, a face that is not a triangle, a vertex that is not manifold, or
       coordinates that are not finite, if `function` is piecewise and the patch of a face is not the number of a piece, if a size
       of `sizing_field` is not positive and finite, or if a parameter is out of its range; the message names the parameter and
       its value
\throw std::length_error if the indices have no room: for more than \f$ 2^{32} - 2 \f$ halfedges, those of the boundary
       included, and with `fit_to_surface` for more than 238,609,294 faces

\sa `Anisotropic_hde_remeshing::detect_surface_regions()`
*/
#ifdef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
#else
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<!Anisotropic_hde_remeshing::internal::is_face_range<TriangleMesh> &&
                                      !Anisotropic_hde_remeshing::internal::is_named_parameters<Function>>>
#endif
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(TriangleMesh& tmesh, const Function& function,
                                                                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Anisotropic_hde_remeshing::internal;
  return internal::remesh_on_surface<std::remove_cv_t<ConcurrencyTag>>(internal::Whole_mesh(), tmesh, function, np);
}

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

remeshes a triangle mesh without a function of the caller's.

The default scheme is `Anisotropic_hde_remeshing::Remeshing_scheme::MEASURED_ERROR` in two cases. The facets of the mesh are then
the surface, and no function is built.
- Only a number of faces is asked for, and it is at most three quarters of that of the mesh; or only an error is asked for.
- Only a number of faces is asked for, whichever it is, and the facets are those of a CAD program. They count as such if more than a
  quarter of the area is in faces whose longest edge is more than eight times the altitude over it. They also count if more than a
  quarter of the area is in long facets of several faces, as those of a cylinder of few sides. And they count if hardly any edge
  turns by little, and half of the area is in such facets and in large ones, as of a block.

By measured error, `sigma`, `target_edge_length` and the counters of projections in the result are 0.

Otherwise the surface is the smooth one that `Rbf_implicit_function` lays through the vertices of the mesh. The named parameters of
`Rbf_implicit_function` may be given, too: `number_of_patches`, `patch_overlap`, `offset_distance`, `vertex_normal_map` and
`radial_function`. The type of `radial_function` selects the kernel.

The facets of a CAD program are the surface, however, unless one of these parameters, `smoothing`, `points_on_facets`,
`detect_edges` or `Remeshing_scheme::PAPER` is given. An embedding or a length then keeps the facets:
- Each facet is a region, the edges between facets are creases, and nothing is lost. With `sharp_angle`, this is so whatever
  parameters of the function are given, except `smoothing`. It is not so if an error or `sizing_field` is given, nor, without
  `sharp_angle`, if `edge_is_constrained_map` is given.
- The facets may be too many or too narrow for the number of faces that is asked for. Then the remeshing goes by measured error,
  without the embedding.
- With `Remeshing_scheme::EMBEDDING`, the mesh is uniform in the embedding in that case. The vertices are on the facets, and edges
  cut across those between facets. The same holds if no number is asked for, and for a length if the facets have more corners than
  the mesh would have vertices.

With `sharp_angle`, the surface is smooth between its creases only. `Anisotropic_hde_remeshing::detect_surface_regions()` finds
the creases. The surface is that of `Piecewise_rbf_implicit_function`, and `vertex_normal_map` is not used.

Without it, constrained edges and edges between patches are creases where their curves are sharp: edges at which faces turn by at
least 40 degrees make up more than half of a curve from one branching to the next. If such creases separate regions of the surface,
and `vertex_normal_map` is not given, the surface is that of `Piecewise_rbf_implicit_function` for these regions. On a smooth mesh,
constrained edges and patches leave the surface smooth.

\cgalNamedParamsBegin
  \cgalParamNBegin{sharp_angle}
    \cgalParamDescription{the least angle between the normals of two faces, in degrees, at which their edge is a crease. Noise
                          is dropped. The edges of `edge_is_constrained_map` and the edges between two patches of
                          `face_patch_map` are creases, too, whatever their angle. In the end, `edge_is_constrained_map` is set
                          for the edges on all creases, and `face_patch_map` keeps the patches. With `protect_constraints` the
                          creases are marked, too. Where exact facets are kept, all edges between them are creases. If only some
                          faces are remeshed, only the creases inside them are marked. For machine parts 20 to 40 are good.
                          (CGAL's parameter `sharpness_angle` is another one: the width, 0 to 90 degrees, of a weight for the
                          normals of neighbouring points.)}
    \cgalParamType{a number of more than 0 and less than 180}
    \cgalParamDefault{the surface is smooth everywhere but at sharp curves of constrained edges or between patches}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw std::invalid_argument as above, and if a parameter of the function or `sharp_angle` is out of its range
*/
#ifdef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename NamedParameters>
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(TriangleMesh& tmesh, const NamedParameters& np)
#else
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename T, typename Tag, typename Base>
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(TriangleMesh& tmesh,
                                                                      const Named_function_parameters<T, Tag, Base>& np)
#endif
{
  namespace internal = Anisotropic_hde_remeshing::internal;
  return internal::remesh_on_built_surface<std::remove_cv_t<ConcurrencyTag>>(internal::Whole_mesh(), tmesh, np);
}

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

remeshes a triangle mesh with all parameters at their defaults: the result has as many faces as the mesh.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh>
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(TriangleMesh& tmesh)
{
  return anisotropic_hde_remeshing<ConcurrencyTag>(tmesh, parameters::default_values());
}

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

remeshes some faces of a mesh only. Everything else is untouched and keeps its descriptors. So do the edges at the border of the
range.
`number_of_target_faces` counts the faces of the range; relative lengths refer to the whole mesh. If the range is empty, nothing is
done.

\tparam FaceRange a range of `boost::graph_traits<TriangleMesh>::%face_descriptor`: anything that has a begin and an end, such
        as a container, `CGAL::Iterator_range`, or a span or view of C++20
*/
#ifdef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
#else
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<Anisotropic_hde_remeshing::internal::is_face_range<FaceRange> &&
                                      !Anisotropic_hde_remeshing::internal::is_named_parameters<Function>>>
#endif
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(const FaceRange& faces, TriangleMesh& tmesh,
                                                                      const Function& function,
                                                                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Anisotropic_hde_remeshing::internal;
  return internal::remesh_on_surface<std::remove_cv_t<ConcurrencyTag>>(internal::Part_of_mesh<FaceRange>{faces}, tmesh,
                                                                       function, np);
}

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

remeshes some faces of a mesh only, on the smooth surface that `Rbf_implicit_function` lays through the vertices of the whole
mesh. With `sharp_angle`, the surface is that of `Piecewise_rbf_implicit_function` for the regions of the whole mesh.
*/
#ifdef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh, typename NamedParameters>
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(const FaceRange& faces, TriangleMesh& tmesh,
                                                                      const NamedParameters& np)
#else
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh, typename T, typename Tag,
          typename Base, typename = std::enable_if_t<Anisotropic_hde_remeshing::internal::is_face_range<FaceRange>>>
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(const FaceRange& faces, TriangleMesh& tmesh,
                                                                      const Named_function_parameters<T, Tag, Base>& np)
#endif
{
  namespace internal = Anisotropic_hde_remeshing::internal;
  return internal::remesh_on_built_surface<std::remove_cv_t<ConcurrencyTag>>(internal::Part_of_mesh<FaceRange>{faces}, tmesh,
                                                                             np);
}

/*!
\ingroup PkgAnisotropicHdeRemeshingFunctions

remeshes some faces of a mesh only, with all parameters at their defaults: the result has as many faces as the range.
*/
#ifdef DOXYGEN_RUNNING
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh>
#else
template <typename ConcurrencyTag = Sequential_tag, typename FaceRange, typename TriangleMesh,
          typename = std::enable_if_t<Anisotropic_hde_remeshing::internal::is_face_range<FaceRange>>>
#endif
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(const FaceRange& faces, TriangleMesh& tmesh)
{
  return anisotropic_hde_remeshing<ConcurrencyTag>(faces, tmesh, parameters::default_values());
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_FUNCTION_H
