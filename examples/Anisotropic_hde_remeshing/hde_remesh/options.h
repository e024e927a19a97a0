// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_OPTIONS_H
#define HDE_REMESH_OPTIONS_H

#include <optional>
#include <string>

namespace hde_remesh {

// The command line. What is not given stays empty: the library has the default.
struct Options
{
  std::string command_line; // as a shell would read it
  std::string input, output;
  std::optional<double> sigma, absolute_sigma; // a fraction of the diagonal; a length
  bool adaptive_sigma = false;
  std::optional<double> metric; // the norm, perhaps infinite
  std::string field;            // the name of a vertex property
  std::optional<double> tau;
  std::optional<double> error, absolute_error; // a fraction of the diagonal; a length
  std::optional<double> sharp;                 // an angle in degrees
  bool fit = false, avoid_self_intersections = true;
  std::optional<double> shape_weight, aspect_ratio;
  std::optional<long long> faces, vertices; // signed, so that a negative count can be named
  std::optional<double> length;
  std::string kernel = "r3";
  std::optional<long long> patches;
  std::optional<double> shape, overlap, offset, smoothing;
  bool automatic_smoothing = false, vertices_only = false, smooth_edges = false;
  std::optional<double> trim; // a length; this and what follows is for points
  bool detect_outliers = true, keep_largest = false;
  std::optional<long long> iterations, relaxation_steps;
  std::optional<double> smoothing_ratio, collapse_ratio, split_ratio;
  std::string scheme = "default";
  std::optional<long long> threads;
  std::string json, report;
  bool arrays = false;
  bool repair = false;
  std::optional<double> merge; // a length
  bool self_intersections = false, no_distance = false, details = false, quiet = false;
};

// whether the options ask for anything of the implicit function
bool is_function_asked_for(const Options& options);

// the versions of this program and of CGAL
std::string version_text();

// Reads the command line; empty if it only asked for help or the version, which are then printed.
std::optional<Options> read_command_line(int argc, char** argv);

} // namespace hde_remesh

#endif // HDE_REMESH_OPTIONS_H
