// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Creases with the metric of the curvature: vertices fitted to the surface, and an error as the target, without self-intersections.

#include "crease_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>

#include <cmath>
#include <cstddef>

using namespace crease_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

Remeshing<Function> remesh_by_metric(Mesh mesh, const std::size_t faces, const bool is_fitted)
{
  const Function function = detect(mesh, 40);
  Remeshing<Function> r{mesh, mesh, function, {}};
  r.result = CGAL::anisotropic_hde_remeshing<Tag>(r.after, function,
                                                  params::number_of_target_faces(faces)
                                                      .embedding(Hde::Curvature_metric(2))
                                                      .fit_to_surface(is_fitted)
                                                      .do_self_intersection_tests(true)
                                                      .face_patch_map(regions_of(r.after))
                                                      .edge_is_constrained_map(creases_of(r.after)));
  return r;
}

Remeshing<Function> remesh_by_error(Mesh mesh, const double error)
{
  const Function function = detect(mesh, 40);
  Remeshing<Function> r{mesh, mesh, function, {}};
  r.result = CGAL::anisotropic_hde_remeshing<Tag>(r.after, function,
                                                  params::approximation_error(error)
                                                      .do_self_intersection_tests(true)
                                                      .face_patch_map(regions_of(r.after))
                                                      .edge_is_constrained_map(creases_of(r.after)));
  return r;
}

// creases become circles up to the accuracy of the function, see test_piecewise_function: over the diagonal
double deviation_from_polygon(const Mesh& mesh)
{
  return largest_deviation + (1 - std::cos(pi / 64) + 1e-4) / bounding_box_diagonal(mesh);
}

Hde::Zero_set_measures distance(Remeshing<Function>& r)
{
  return Hde::measure_distance_to_zero_set<Tag>(r.after, r.function, params::face_patch_map(regions_of(r.after)));
}

void test_metric()
{
  const Mesh mesh = can(64, 32); // fine enough for its edges to become circles
  Remeshing<Function> r = remesh_by_metric(mesh, 1500, false), fitted = remesh_by_metric(mesh, 1500, true);
  check("metric", r, deviation_from_polygon(mesh));
  check_creases_on_surface(r);
  CHECK(promises::number_of_self_intersections(fitted.after) == 0);
  CHECK(Hde::measure_shape(fitted.after).number_of_folded_edges == 0);
  CHECK(distance(fitted).face_rms < 0.7 * distance(r).face_rms);
  // curves do not move, and planes are flat
  CHECK(creases::segments(fitted.after, creases_of(fitted.after)) == creases::segments(r.after, creases_of(r.after)));
  for (Remeshing<Function>* remeshing : {&r, &fitted})
    for (const auto& region : vertices_of_regions(remeshing->after))
      if (remeshing->function.piece(region.first).kind() == Hde::Piece_kind::PLANE)
        for (const Mesh::Vertex_index v : region.second)
          CHECK_CLOSE(std::abs(remeshing->after.point(v).z()), 1, 1e-9);
}

void test_error()
{
  const Mesh mesh = can(64, 32); // fine enough for its edges to become circles
  const double diagonal = bounding_box_diagonal(mesh);
  for (const double error : {0.01, 0.001})
  {
    Remeshing<Function> r = remesh_by_error(mesh, error);
    check("error", r, deviation_from_polygon(mesh));
    check_creases_on_surface(r);
    CHECK(r.result.binding_target == Hde::Target::APPROXIMATION_ERROR);
    CHECK(r.result.approximation_error <= error);
    CHECK(distance(r).face_max <= error + 1e-4 * diagonal);
  }
}

int main()
{
  test_metric();
  test_error();
  return check_summary();
}
