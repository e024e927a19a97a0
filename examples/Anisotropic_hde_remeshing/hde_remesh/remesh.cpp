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
#include "remesh_with.h"

namespace hde_remesh {

namespace {

Remeshing_result remesh_with_embedding(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                       Progress& progress)
{
  const bool has_sigma = o.sigma || o.absolute_sigma;
  if (!o.field.empty())
    return remesh_with_field(mesh, function, sizes, o, progress);
  if (o.adaptive_sigma)
    return remesh_with_adaptive_sigma(mesh, function, sizes, o, progress);
  if (o.metric || (sizes.error && !has_sigma))
    return remesh_with_metric(mesh, function, sizes, o, progress);
  return remesh_with_normals(mesh, function, sizes, o, progress);
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
  remeshed.result = remesh_with_embedding(remeshed.mesh, remeshed.function, sizes, options, progress);
  is_listening() = 0;
  return remeshed;
}

} // namespace hde_remesh
