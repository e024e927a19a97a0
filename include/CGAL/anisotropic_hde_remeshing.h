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
#include <CGAL/Anisotropic_hde_remeshing/internal/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/named_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Remesher.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh_conversion.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace CGAL {

namespace Anisotropic_hde_remeshing {
namespace internal {

inline double bounding_box_diagonal(const Working_mesh& mesh)
{
  Vector low = Vector::Constant((std::numeric_limits<double>::max)()), high = -low;
  for (const Vertex_index v : mesh.vertices())
  {
    low = low.cwiseMin(mesh.point(v).point);
    high = high.cwiseMax(mesh.point(v).point);
  }
  const double diagonal = (high - low).norm();
  if (!(diagonal > 0))
    throw std::invalid_argument("all points of the mesh are equal");
  return diagonal;
}

template <typename NamedParameters>
double sigma_parameter(const NamedParameters& np, const double diagonal)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::sigma_t>::value)
    return 0.01 * diagonal;
  else
    return checked_not_negative("sigma", CGAL::to_double(parameters::get_parameter(np, internal_np::sigma)));
}

template <typename NamedParameters>
Remeshing_parameters remeshing_parameters(const NamedParameters& np)
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
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::number_of_iterations_t>::value)
  {
    const auto n = get_parameter(np, internal_np::number_of_iterations);
    if (n < decltype(n)(0) || double(n) > 1e6)
      throw_invalid_argument("number_of_iterations", n, "from 0 to 1000000");
    result.number_of_iterations = static_cast<unsigned int>(n);
  }
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::number_of_relaxation_steps_t>::value)
  {
    const auto n = get_parameter(np, internal_np::number_of_relaxation_steps);
    if (n < decltype(n)(0) || double(n) > 1e6)
      throw_invalid_argument("number_of_relaxation_steps", n, "from 0 to 1000000");
    result.number_of_relaxation_steps = static_cast<unsigned int>(n);
  }
  result.smoothing_ratio = checked_between(
      "smoothing_ratio", choose_parameter(get_parameter(np, internal_np::smoothing_ratio), result.smoothing_ratio), 0, 1);
  result.collapse_ratio = checked_between(
      "collapse_ratio", choose_parameter(get_parameter(np, internal_np::collapse_ratio), result.collapse_ratio), 0, 1);
  result.split_ratio = checked_between(
      "split_ratio", choose_parameter(get_parameter(np, internal_np::split_ratio), result.split_ratio), 1, 100);
  return result;
}

// checks target_edge_length and number_of_target_faces before anything is computed
template <typename NamedParameters>
void check_target(const NamedParameters& np)
{
  constexpr bool has_length =
      !parameters::is_default_parameter<NamedParameters, internal_np::target_edge_length_t>::value;
  constexpr bool has_count =
      !parameters::is_default_parameter<NamedParameters, internal_np::number_of_target_faces_t>::value;
  static_assert(!has_length || !has_count, "target_edge_length and number_of_target_faces exclude each other");
  if constexpr (has_length)
    checked_positive("target_edge_length", CGAL::to_double(parameters::get_parameter(np, internal_np::target_edge_length)));
  if constexpr (has_count)
    checked_count("number_of_target_faces", parameters::get_parameter(np, internal_np::number_of_target_faces));
}

template <typename NamedParameters>
Target_length target_length(const NamedParameters& np, const Working_mesh& mesh)
{
  using parameters::get_parameter;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::target_edge_length_t>::value)
    return Target_length::of_length(CGAL::to_double(get_parameter(np, internal_np::target_edge_length)));
  else if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::number_of_target_faces_t>::value)
    return Target_length::of_number_of_faces(std::size_t(get_parameter(np, internal_np::number_of_target_faces)));
  else
    return Target_length::of_number_of_faces(mesh.number_of_faces());
}

// 1 if the faces of the mesh look along the normals of its vertices, -1 if most of their area looks against them
inline double orientation(const Working_mesh& mesh)
{
  double sum = 0;
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    const Vector &a = mesh.point(t.a).point, &b = mesh.point(t.b).point, &c = mesh.point(t.c).point;
    sum += (b - a).cross(c - a).dot(mesh.point(t.a).normal + mesh.point(t.b).normal + mesh.point(t.c).normal);
  }
  return sum < 0 ? -1 : 1;
}

// the second step, on the copy of the mesh; what the caller sees of it is the visitor
template <typename ConcurrencyTag, typename Function, typename Visitor, typename NamedParameters>
void remesh(Working_mesh& mesh, const Function& function, Visitor& visitor, const NamedParameters& np,
            Remeshing_result& result)
{
  typedef Surface_projection<Function> Projection;
  typedef Remesher<ConcurrencyTag, Normal_embedding, Projection, Visitor> Remesher;
  static constexpr double exact_distance = 1e-9; // of the diagonal; one more step of Newton squares it

  Real_timer timer;
  timer.start();
  visitor.stage_started(Stage::PROJECTION);
  const double diagonal = bounding_box_diagonal(mesh);
  result.sigma = sigma_parameter(np, diagonal);
  const Normal_embedding embedding(result.sigma);
  const Input_surface input(mesh);
  const Boundary_curves boundary(mesh);
  Projection projection(function, input, exact_distance * diagonal);
  Remesher remesher(mesh, embedding, projection, boundary, remeshing_parameters(np), visitor, result);
  remesher.project_exactly();
  if (orientation(mesh) < 0)
  {
    projection.set_orientation(-1);
    for (const Vertex_index v : mesh.vertices())
      mesh.point(v).normal *= -1;
  }
  result.projection_seconds = timer.time();

  timer.reset();
  visitor.stage_started(Stage::REMESHING);
  remesher.run(target_length(np, mesh));
  result.projections = projection.counters();
  result.remeshing_seconds = timer.time();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

remeshes a triangle mesh so that it becomes uniform and isotropic in the embedding \f$ (x, \sigma n(x)) \f$ in \f$ R^6 \f$,
hence adapted to the curvature and stretched along the directions of low curvature in space, by splits, contractions and flips
of edges and smoothing of vertices. Every vertex inside the surface is put on the zero set of `function`, every vertex of the
boundary on the polylines that bound the input; sharp turns of these stay. Components, boundary curves and the Euler
characteristic are kept; no operation folds the surface over.

The result does not depend on the number of threads. If an exception is thrown, `tmesh` is as it was.

\tparam ConcurrencyTag `Sequential_tag` (the default), `Parallel_tag` or `Parallel_if_available_tag`
\tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
\tparam Function a model of `ImplicitFunctionWithGradient`, such as `Rbf_implicit_function` or a function of the user's own
        with a nested type `Point_3`, `FT operator()(Point_3) const` and `Vector_3 gradient(Point_3) const`; both are called
        concurrently unless `ConcurrencyTag` is `Sequential_tag`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh, an orientable manifold, possibly with boundary. Its elements are replaced: descriptors become invalid,
       isolated vertices are dropped.
\param function the surface, whose zero set lies near the mesh
\param np optional named parameters among the ones below

\cgalNamedParamsBegin
  \cgalParamNBegin{sigma}
    \cgalParamDescription{the weight \f$ \sigma \f$ of the normals, a length in the unit of the mesh. A typical radius of
                          curvature is a natural choice; 0 makes the mesh isotropic in space.}
    \cgalParamType{a number, not negative}
    \cgalParamDefault{0.01 of the diagonal of the bounding box}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length that the edges shall have in \f$ R^6 \f$, in the unit of the mesh}
    \cgalParamType{a number, positive}
    \cgalParamDefault{follows from `number_of_target_faces`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_target_faces}
    \cgalParamDescription{how many faces the result shall have; excludes `target_edge_length`}
    \cgalParamType{an integer, at least 1}
    \cgalParamDefault{as many as `tmesh` has}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how often the sequence of operations is done; 0 only projects the vertices}
    \cgalParamType{unsigned int}
    \cgalParamDefault{10}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_relaxation_steps}
    \cgalParamDescription{how often an iteration smooths; not used by the scheme of the paper}
    \cgalParamType{unsigned int}
    \cgalParamDefault{2}
  \cgalParamNEnd
  \cgalParamNBegin{remeshing_scheme}
    \cgalParamDescription{the order of the operations}
    \cgalParamType{`Anisotropic_hde_remeshing::Remeshing_scheme`}
    \cgalParamDefault{`DEFAULT`; `PAPER` is Algorithm 2 of the paper}
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
  \cgalParamNBegin{visitor}
    \cgalParamDescription{hears of the progress and may stop the remeshing}
    \cgalParamType{a class with the members of `Anisotropic_hde_remeshing::Remeshing_visitor`}
    \cgalParamDefault{`Anisotropic_hde_remeshing::Remeshing_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamDefault{`get_property_map(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what was done, and the parameters that were chosen

\throw std::invalid_argument if `tmesh` has no faces, a face that is not a triangle, or coordinates that are not finite, or if
       a parameter is out of its range; the message names it and its value
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
Anisotropic_hde_remeshing::Remeshing_result
anisotropic_hde_remeshing(TriangleMesh& tmesh, const Function& function,
                          const NamedParameters& np = parameters::default_values())
{
  namespace Hde = Anisotropic_hde_remeshing;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Hde::internal::check_target(np);
  Hde::internal::remeshing_parameters(np);
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, tmesh));
  auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Hde::Remeshing_visitor());

  Hde::Remeshing_result result;
  Hde::internal::Working_mesh mesh;
  result.number_of_isolated_vertices = Hde::internal::load_mesh(tmesh, vpm, mesh);
  Hde::internal::remesh<ConcurrencyTag>(mesh, function, visitor, np, result);

  Real_timer timer;
  timer.start();
  visitor.stage_started(Hde::Stage::OUTPUT);
  Hde::internal::store_mesh(mesh, tmesh, vpm);
  result.output_seconds = timer.time();
  return result;
}

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

the same on the smooth surface that `Rbf_implicit_function` lays through the vertices of the mesh. Its named parameters may be
given, too: `number_of_patches`, `patch_overlap`, `offset_distance`, `vertex_normal_map`, and `radial_function`, whose type
selects the kernel.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename T, typename Tag, typename Base>
Anisotropic_hde_remeshing::Remeshing_result
anisotropic_hde_remeshing(TriangleMesh& tmesh, const Named_function_parameters<T, Tag, Base>& np)
{
  namespace Hde = Anisotropic_hde_remeshing;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename boost::property_map<TriangleMesh, vertex_point_t>::type Default_point_map;
  typedef typename internal_np::Lookup_named_param_def<internal_np::vertex_point_t, Named_function_parameters<T, Tag, Base>,
                                                       Default_point_map>::type Point_map;
  typedef typename Kernel_traits<typename boost::property_traits<Point_map>::value_type>::Kernel Kernel;
  typedef std::decay_t<decltype(choose_parameter(get_parameter(np, internal_np::radial_function), Polyharmonic_rbf()))>
      Radial_function;

  Hde::internal::check_target(np);
  Hde::internal::remeshing_parameters(np);
  auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Hde::Remeshing_visitor());
  visitor.stage_started(Hde::Stage::IMPLICIT_FUNCTION);
  Real_timer timer;
  timer.start();
  const Rbf_implicit_function<Kernel, Radial_function, ConcurrencyTag> function(tmesh, np);
  const double seconds = timer.time();
  Hde::Remeshing_result result = anisotropic_hde_remeshing<ConcurrencyTag>(tmesh, function, np);
  result.implicit_function_seconds = seconds;
  return result;
}

/*!
\ingroup PkgAnisotropicHdeRemeshingRef

the same with all parameters at their defaults: as many faces as before.
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh>
Anisotropic_hde_remeshing::Remeshing_result anisotropic_hde_remeshing(TriangleMesh& tmesh)
{
  return anisotropic_hde_remeshing<ConcurrencyTag>(tmesh, parameters::default_values());
}

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_FUNCTION_H
