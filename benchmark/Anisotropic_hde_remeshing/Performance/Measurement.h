// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// One remeshing beside CGAL's isotropic_remeshing of the same input to as many faces, in the same run: time, memory, quality.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MEASUREMENT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MEASUREMENT_H

#include "Peak_memory.h"
#include "isotropic_remeshing.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

struct Case
{
  std::string name;
  shapes::Mesh input;
  std::size_t number_of_target_faces = 0;
  double relative_sigma = 0.01;
};

struct Measurement
{
  std::size_t number_of_faces = 0, isotropic_faces = 0;
  double function_seconds = 0, remeshing_seconds = 0, isotropic_seconds = 0;
  double megabytes = 0, isotropic_megabytes = 0; // at most, beyond what is in use before
  Hde::Embedding_measures embedding;
  double relative_rms = 0, isotropic_rms = 0; // distance of the faces to the zero set, over the diagonal

  double seconds() const { return function_seconds + remeshing_seconds; }
  double ratio() const { return seconds() / isotropic_seconds; }
};

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// `isotropic_length` gives about as many faces; `build` makes the function, in the time that counts
template <typename Build>
Measurement measure(const Case& c, const double isotropic_length, const int number_of_runs, const Build& build)
{
  Measurement m;
  const double sigma = c.relative_sigma * shapes::bounding_box_diagonal(c.input);
  std::vector<double> function_seconds, remeshing_seconds, isotropic_seconds;
  for (int run = 0; run < number_of_runs; ++run)
  {
    shapes::Mesh mesh = c.input, isotropic;
    const Peak_memory memory;
    CGAL::Real_timer timer;
    timer.start();
    const auto function = build();
    function_seconds.push_back(timer.time());
    timer.reset();
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, function, params::sigma(sigma).number_of_target_faces(c.number_of_target_faces));
    remeshing_seconds.push_back(timer.time());
    m.megabytes = (std::max)(m.megabytes, memory.megabytes());

    const Peak_memory isotropic_memory;
    isotropic_seconds.push_back(seconds_of([&] { isotropic = isotropically_remeshed(c.input, isotropic_length); }));
    m.isotropic_megabytes = (std::max)(m.isotropic_megabytes, isotropic_memory.megabytes());
    if (run + 1 < number_of_runs)
      continue;
    m.number_of_faces = mesh.number_of_faces();
    m.isotropic_faces = isotropic.number_of_faces();
    m.embedding =
        Hde::measure_embedding<Tag>(mesh, function, params::sigma(sigma).target_edge_length(result.target_edge_length));
    const double diagonal = shapes::bounding_box_diagonal(c.input);
    m.relative_rms = Hde::measure_distance_to_zero_set<Tag>(mesh, function).face_rms / diagonal;
    m.isotropic_rms = Hde::measure_distance_to_zero_set<Tag>(isotropic, function).face_rms / diagonal;
  }
  m.function_seconds = median(function_seconds);
  m.remeshing_seconds = median(remeshing_seconds);
  m.isotropic_seconds = median(isotropic_seconds);
  return m;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MEASUREMENT_H
