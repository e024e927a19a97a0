// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_REPORT_H
#define HDE_REMESH_REPORT_H

#include "Figures.h"
#include "Points_figures.h"
#include "flat_faces.h"
#include "repair.h"

#include <CGAL/Anisotropic_hde_remeshing/Piecewise_rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hde_remesh {

// all that the program has to tell
struct Report
{
  std::string input, output, version;
  std::optional<Points_figures> points; // if IN has no faces
  std::size_t number_of_isolated_vertices = 0;
  std::optional<Repair> repair;            // if it was asked for
  std::size_t number_of_merged_points = 0; // within the tolerance of others, which closes cracks
  double tolerance = 0;                    // 0 if none were to be merged
  Flat_faces flat_faces;                   // of the input
  std::string kernel, scheme, embedding;   // no kernel without a function
  bool has_6d_lengths = true;              // the embedding is the paper's
  double diagonal = 0;                     // of the bounding box of the input
  double rounding = 0;                     // of its coordinates, as its file has them
  std::optional<std::size_t> number_of_target_faces;
  std::optional<double> error; // asked for
  Hde::Remeshing_result result;
  std::optional<Hde::Rbf_diagnostics> rbf;              // of the function, where there is one
  std::optional<double> sharp;                          // the angle asked for, in degrees
  std::optional<Hde::Piecewise_rbf_diagnostics> pieces; // in the place of `rbf`, with that angle
  Figures before, after;
  std::optional<Hde::Distance_measures> distance;     // first: the output, second: the input
  std::vector<std::pair<std::string, double>> stages; // their names and wall times in seconds
  std::vector<std::string> notes;                     // of the reading, a line each
  std::vector<std::string> warnings;                  // a line each

  bool has_function() const { return rbf || pieces; }
};

// for people: the verdict, and the most important figures or all of them
void print_table(const Report& report, bool with_details, std::ostream& stream);

// for programs
std::string to_json(const Report& report);

} // namespace hde_remesh

#endif // HDE_REMESH_REPORT_H
