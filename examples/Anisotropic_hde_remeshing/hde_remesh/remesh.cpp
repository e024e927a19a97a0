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

#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Facet_planes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Facet_regions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace hde_remesh {

namespace Hde_internal = CGAL::Anisotropic_hde_remeshing::internal;
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
  if (sizes.scheme == Remeshing_scheme::MEASURED_ERROR)
    return Embedding::NORMALS; // it has none
  if (!o.field.empty())
    return Embedding::FIELD;
  if (o.adaptive_sigma)
    return Embedding::ADAPTIVE_SIGMA;
  const bool has_sigma = o.sigma || o.absolute_sigma;
  return o.metric || (sizes.error && !has_sigma) ? Embedding::METRIC : Embedding::NORMALS;
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

void build_function(const Mesh& mesh, const Options& options, Progress& progress, Remeshed& remeshed)
{
  progress.stage("building the function");
  Stopwatch stopwatch;
  const Built_function built = build_function(mesh, options, progress);
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

// Whether an embedding keeps to the facets of the mesh, as they are exact. It is for the caller to see whether the number of faces
// allows it.
bool keeps_facets(const Mesh& mesh, const Sizes& sizes, const Options& o)
{
  const bool is_smoothed = o.smoothing.value_or(0) > 0 || o.automatic_smoothing;
  return sizes.scheme == Remeshing_scheme::EMBEDDING && !sizes.error && o.iterations.value_or(1) > 0 && !is_smoothed &&
         (o.sharp || !is_function_asked_for(o)) && Hde_internal::has_long_facets(faces(mesh), mesh, mesh.points());
}

// Whether the measured error may take the place of the embedding: for a number that is asked for, not for other triangles than those of
// IN, which are what loses the least.
bool may_give_way_to_error(const Sizes& sizes, const Options& o)
{
  const Embedding embedding = embedding_of(sizes, o);
  return o.scheme == "default" && (o.faces || o.vertices) &&
         (embedding == Embedding::NORMALS || embedding == Embedding::METRIC);
}

Remeshed remesh_with_function(const Mesh& mesh, const Sizes& sizes, const Options& options, Progress& progress,
                              Remeshed&& remeshed)
{
  remeshed.mesh = mesh;
  progress.stage("remeshing");
  is_listening() = 1;
  remeshed.result = remesh_with_embedding(remeshed.mesh, remeshed.function, sizes, options, progress);
  is_listening() = 0;
  return std::move(remeshed);
}

// With each facet as a region. Returns none, and leaves the mesh as it was, if the number of faces does not allow it.
std::optional<Remeshed> remesh_between_facets(Mesh& mesh, const Sizes& sizes, const Options& options, Progress& progress)
{
  Stopwatch stopwatch;
  progress.stage("looking for facets");
  const Hde_internal::Facet_regions<Mesh, Mesh::Property_map<Mesh::Vertex_index, Point_3>> facets(mesh, mesh.points());
  const double number_of_faces = sizes.edge_length
                                     ? facets.area() / (0.25 * std::sqrt(3.) * *sizes.edge_length * *sizes.edge_length)
                                     : static_cast<double>(*sizes.number_of_faces);
  if (!facets.are_planar() || facets.least_number_of_faces() > number_of_faces)
    return std::nullopt;
  Mesh with_facets = mesh;
  facets.mark(creases_of(with_facets).is_crease, creases_of(with_facets).region);
  const Hde_internal::Facet_planes<Kernel> function(facets.planes());
  Remeshed remeshed;
  remeshed.function = Function_view::of_pieces(function);
  remeshed.pieces = function.diagnostics();
  remeshed.keeps_facets = true;
  remeshed.kernel = "planes of the facets";
  remeshed.function_seconds = stopwatch.seconds();
  remeshed = remesh_with_function(with_facets, sizes, options, progress, std::move(remeshed));
  if (remeshed.result.misses_number_of_faces())
    return std::nullopt;
  mesh = std::move(with_facets);
  return remeshed;
}

} // namespace

Remeshed remesh(Mesh& mesh, Sizes& sizes, const Options& options, Progress& progress)
{
  if (keeps_facets(mesh, sizes, options))
  {
    if (auto remeshed = remesh_between_facets(mesh, sizes, options, progress))
      return std::move(*remeshed);
    if (may_give_way_to_error(sizes, options))
      sizes.scheme = Remeshing_scheme::MEASURED_ERROR;
  }
  Remeshed remeshed;
  if (sizes.scheme == Remeshing_scheme::MEASURED_ERROR)
    remeshed.function = Function_view::without_values(number_of_regions(mesh));
  else
    build_function(mesh, options, progress, remeshed);
  return remesh_with_function(mesh, sizes, options, progress, std::move(remeshed));
}

} // namespace hde_remesh
