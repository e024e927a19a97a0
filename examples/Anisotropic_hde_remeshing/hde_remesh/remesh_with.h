// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The remeshing with an embedding of a type; a translation unit has few of these, as each takes long to compile.

#ifndef HDE_REMESH_REMESH_WITH_H
#define HDE_REMESH_REMESH_WITH_H

#include "remesh.h"

#include <CGAL/anisotropic_hde_remeshing.h>

#include <limits>

namespace hde_remesh {

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Anisotropic_hde_remeshing::Remeshing_result Remeshing_result;

// what the embeddings are made for
Remeshing_result remesh_with_normals(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                     Progress& progress);
Remeshing_result remesh_with_metric(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                    Progress& progress);
Remeshing_result remesh_with_adaptive_sigma(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                            Progress& progress);
Remeshing_result remesh_with_field(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                   Progress& progress);

template <typename NamedParameters>
Remeshing_result remesh_with_all(Mesh& mesh, const Function_view& function, const Options& o, const NamedParameters& np,
                                 const bool is_split_only = false)
{
  namespace Hde_internal = CGAL::Anisotropic_hde_remeshing::internal;
  // what the scheme has where nothing is given
  const auto defaults = Hde_internal::iteration_parameters(np);
  const unsigned int number_of_iterations =
      is_split_only
          ? 0
          : Hde_internal::default_number_of_iterations(defaults.scheme, Hde_internal::is_error_given<NamedParameters>);
  const Creases creases = creases_of(mesh);
  const Remeshing_result result = CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
      mesh, function,
      np.face_patch_map(creases.region)
          .edge_is_constrained_map(creases.is_crease)
          .number_of_iterations(o.iterations.value_or(number_of_iterations))
          .number_of_relaxation_steps(o.relaxation_steps.value_or(defaults.number_of_relaxation_steps))
          .smoothing_ratio(o.smoothing_ratio.value_or(defaults.smoothing_ratio))
          .collapse_ratio(o.collapse_ratio.value_or(defaults.collapse_ratio))
          .split_ratio(o.split_ratio.value_or(defaults.split_ratio))
          .fit_to_surface(o.fit)
          .shape_weight(o.shape_weight.value_or(Hde_internal::default_shape_weight(o.fit)))
          .aspect_ratio_bound(o.aspect_ratio.value_or(std::numeric_limits<double>::infinity()))
          .do_self_intersection_tests(o.avoid_self_intersections));
  if (mesh.has_garbage())
    mesh.collect_garbage();
  return result;
}

template <typename Embedding>
Remeshing_result remesh_with(const Embedding& embedding, Mesh& mesh, const Function_view& function, const Sizes& sizes,
                             const Options& o, Progress& progress)
{
  const auto np = params::embedding(embedding).remeshing_scheme(sizes.scheme).visitor(Progress_visitor(progress));
  if (sizes.edge_length)
    return remesh_with_all(mesh, function, o, np.target_edge_length(*sizes.edge_length));
  if (!sizes.error)
    return remesh_with_all(mesh, function, o, np.number_of_target_faces(*sizes.number_of_faces),
                           sizes.scheme == CGAL::Anisotropic_hde_remeshing::Remeshing_scheme::MEASURED_ERROR &&
                               *sizes.number_of_faces > mesh.number_of_faces());
  const std::size_t most = CGAL::Anisotropic_hde_remeshing::internal::largest_number_of_faces;
  return remesh_with_all(mesh, function, o,
                         np.approximation_error(*sizes.error).number_of_target_faces(sizes.number_of_faces.value_or(most)));
}

} // namespace hde_remesh

#endif // HDE_REMESH_REMESH_WITH_H
