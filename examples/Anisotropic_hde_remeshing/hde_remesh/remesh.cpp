// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "remesh.h"
#include "Stopwatch.h"
#include "build_function.h"

#include <CGAL/anisotropic_hde_remeshing.h>

namespace hde_remesh {

namespace {

namespace parameters = CGAL::parameters;
typedef CGAL::Anisotropic_hde_remeshing::Remeshing_scheme Remeshing_scheme;
typedef CGAL::Anisotropic_hde_remeshing::Remeshing_result Remeshing_result;

template <typename NamedParameters>
Remeshing_result run(Mesh& mesh, const Function_view& function, const Options& o, const NamedParameters& np)
{
  // what the scheme has where nothing is given
  const auto defaults = CGAL::Anisotropic_hde_remeshing::internal::remeshing_parameters(np);
  return CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
      mesh, function,
      np.number_of_iterations(o.iterations.value_or(defaults.number_of_iterations))
          .number_of_relaxation_steps(o.relaxation_steps.value_or(defaults.number_of_relaxation_steps))
          .smoothing_ratio(o.smoothing_ratio.value_or(defaults.smoothing_ratio))
          .collapse_ratio(o.collapse_ratio.value_or(defaults.collapse_ratio))
          .split_ratio(o.split_ratio.value_or(defaults.split_ratio)));
}

Remeshing_result run_with_sizes(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                Progress& progress)
{
  const auto np = parameters::sigma(sizes.sigma)
                      .remeshing_scheme(o.scheme == "paper" ? Remeshing_scheme::PAPER : Remeshing_scheme::DEFAULT)
                      .visitor(Progress_visitor(progress));
  return sizes.edge_length ? run(mesh, function, o, np.target_edge_length(*sizes.edge_length))
                           : run(mesh, function, o, np.number_of_target_faces(*sizes.number_of_faces));
}

} // namespace

Remeshed remesh(const Mesh& mesh, const Sizes& sizes, const Options& options, Progress& progress)
{
  Remeshed remeshed;
  progress.stage("smooth function");
  Stopwatch stopwatch;
  Built_function built = build_function(mesh, options);
  remeshed.function_seconds = stopwatch.seconds();
  remeshed.function = built.function;
  remeshed.kernel = built.kernel;
  remeshed.rbf = built.rbf;
  remeshed.mesh = mesh;
  is_listening() = 1;
  remeshed.result = run_with_sizes(remeshed.mesh, remeshed.function, sizes, options, progress);
  is_listening() = 0;
  return remeshed;
}

} // namespace hde_remesh
