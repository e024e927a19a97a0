// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHING_REPORT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHING_REPORT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Local_operations.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What the second step did, in the unit of the working mesh. `write_report()` is the only one to write this into the caller's
// result.
struct Remeshing_report
{
  double target_length = 0; // in the embedding
  double error = 0;         // the bound on the distance; 0 if no error was asked for
  Target binding_target = Target::NUMBER_OF_FACES;
  unsigned int number_of_iterations = 0;
  std::size_t number_of_regions = 0;
  std::size_t number_of_unprojected_vertices = 0;
  Feature_curves curves_before, curves_after;
  Operation_statistics operations;
  Projection_counters projections;
  double projection_seconds = 0, remeshing_seconds = 0;
};

inline Feature_curves in_unit_of_caller(Feature_curves curves, const double unit)
{
  curves.length *= unit;
  return curves;
}

// `unit` is that of the working mesh, `unit_of_lengths` that of lengths in the embedding, both in the caller's unit.
inline void write_report(const Remeshing_report& report, const double unit, const double unit_of_lengths,
                         Remeshing_result& result)
{
  result.target_edge_length = report.target_length * unit_of_lengths;
  result.approximation_error = report.error * unit;
  result.binding_target = report.binding_target;
  result.number_of_iterations = report.number_of_iterations;
  result.number_of_regions = report.number_of_regions;
  result.number_of_unprojected_vertices = report.number_of_unprojected_vertices;
  result.curves_before = in_unit_of_caller(report.curves_before, unit);
  result.curves_after = in_unit_of_caller(report.curves_after, unit);
  result.number_of_splits = report.operations.number_of_splits;
  result.number_of_collapses = report.operations.number_of_collapses;
  result.number_of_flips = report.operations.number_of_flips;
  result.split_seconds = report.operations.split_seconds;
  result.collapse_seconds = report.operations.collapse_seconds;
  result.flip_seconds = report.operations.flip_seconds;
  result.smoothing_seconds = report.operations.smoothing_seconds;
  result.projections = report.projections;
  result.projection_seconds = report.projection_seconds;
  result.remeshing_seconds = report.remeshing_seconds;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_REMESHING_REPORT_H
