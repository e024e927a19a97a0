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

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

namespace hde_remesh {

using CGAL::Anisotropic_hde_remeshing::Remeshing_scheme;

namespace {

enum class Embedding
{
  NORMALS,
  FIELD,
  ADAPTIVE_SIGMA,
  METRIC
};

Embedding embedding_of(const Sizes& sizes, const Options& o)
{
  if (!o.field.empty())
    return Embedding::FIELD;
  if (o.adaptive_sigma)
    return Embedding::ADAPTIVE_SIGMA;
  const bool has_sigma = o.sigma || o.absolute_sigma;
  const bool leaves_embedding_open = !has_sigma && sizes.scheme != Remeshing_scheme::MEASURED_ERROR;
  return o.metric || (sizes.error && leaves_embedding_open) ? Embedding::METRIC : Embedding::NORMALS;
}

Remeshing_result remesh_with_embedding(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                       Progress& progress)
{
  switch (embedding_of(sizes, o))
  {
  case Embedding::FIELD:
    return remesh_with_field(mesh, function, sizes, o, progress);
  case Embedding::ADAPTIVE_SIGMA:
    return remesh_with_adaptive_sigma(mesh, function, sizes, o, progress);
  case Embedding::METRIC:
    return remesh_with_metric(mesh, function, sizes, o, progress);
  case Embedding::NORMALS:
    break;
  }
  return remesh_with_normals(mesh, function, sizes, o, progress);
}

} // namespace

Remeshing_scheme scheme_of(const Sizes& sizes, const Options& o, const Mesh& mesh)
{
  if (o.scheme == "paper")
    return Remeshing_scheme::PAPER;
  if (o.scheme == "embedding")
    return Remeshing_scheme::EMBEDDING;
  const bool is_count_given = (o.faces || o.vertices) && !sizes.edge_length;
  if (o.metric || o.adaptive_sigma || !o.field.empty() || !(is_count_given || sizes.error))
    return Remeshing_scheme::EMBEDDING;
  const bool is_asked_for = o.scheme == "measured-error";
  const bool is_embedding_given =
      o.sigma || o.absolute_sigma || o.relaxation_steps || o.smoothing_ratio || o.collapse_ratio || o.split_ratio;
  const Remeshing_scheme scheme = is_asked_for ? Remeshing_scheme::MEASURED_ERROR : Remeshing_scheme::DEFAULT;
  namespace Hde_internal = CGAL::Anisotropic_hde_remeshing::internal;
  const bool is_by_measured_error =
      (is_asked_for || !(is_embedding_given || is_function_asked_for(o))) &&
      (sizes.error ? Hde_internal::keeps_measured_error(scheme)
                   : Hde_internal::is_by_measured_error(
                         scheme, static_cast<double>(sizes.number_of_faces.value()), mesh.number_of_faces(),
                         [&] { return Hde_internal::has_long_facets(faces(mesh), mesh, mesh.points()); }));
  return is_by_measured_error ? Remeshing_scheme::MEASURED_ERROR : Remeshing_scheme::EMBEDDING;
}

std::string scheme_text(const Remeshing_scheme scheme)
{
  switch (scheme)
  {
  case Remeshing_scheme::PAPER:
    return "paper";
  case Remeshing_scheme::MEASURED_ERROR:
    return "measured-error";
  default:
    return "embedding";
  }
}

std::string embedding_text(const Sizes& sizes, const Options& options)
{
  if (sizes.scheme == Remeshing_scheme::MEASURED_ERROR)
    return "by measured error, no embedding";
  std::ostringstream text;
  switch (embedding_of(sizes, options))
  {
  case Embedding::FIELD:
    text << "sigma " << sizes.sigma << ", field " << options.field << " with tau " << sizes.tau;
    break;
  case Embedding::ADAPTIVE_SIGMA:
    text << "sigma 1 / sqrt|K|";
    break;
  case Embedding::METRIC:
    text << "metric of the curvature, p = " << options.metric.value_or(std::numeric_limits<double>::infinity());
    break;
  case Embedding::NORMALS:
    text << "sigma " << sizes.sigma;
    break;
  }
  return text.str();
}

bool has_6d_lengths(const Sizes& sizes, const Options& options)
{
  return embedding_of(sizes, options) == Embedding::NORMALS && sizes.scheme != Remeshing_scheme::MEASURED_ERROR;
}

namespace {

void build_function(const Mesh& mesh, const Options& options, Remeshed& remeshed)
{
  Stopwatch stopwatch;
  const Built_function built = build_function(mesh, options);
  remeshed.function_seconds = stopwatch.seconds();
  remeshed.function = built.function;
  remeshed.kernel = built.kernel;
  remeshed.rbf = built.rbf;
  remeshed.pieces = built.pieces;
}

std::size_t number_of_regions(const Mesh& mesh)
{
  const Creases creases = creases_of(mesh);
  std::size_t number = 1;
  for (const Mesh::Face_index f : mesh.faces())
    number = (std::max)(number, creases.region[f] + 1);
  return number;
}

} // namespace

Remeshed remesh(const Mesh& mesh, const Sizes& sizes, const Options& options, Progress& progress)
{
  Remeshed remeshed;
  if (sizes.scheme == Remeshing_scheme::MEASURED_ERROR)
    remeshed.function = Function_view::without_values(number_of_regions(mesh));
  else
  {
    progress.stage("smooth function");
    build_function(mesh, options, remeshed);
  }
  remeshed.mesh = mesh;
  is_listening() = 1;
  remeshed.result = remesh_with_embedding(remeshed.mesh, remeshed.function, sizes, options, progress);
  is_listening() = 0;
  return remeshed;
}

} // namespace hde_remesh
