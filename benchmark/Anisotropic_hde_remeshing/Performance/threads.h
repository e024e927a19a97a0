// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How the stages of the whole method share the time, and how much faster they are with more threads, beside what the machine
// gives: as many copies of the evaluation at once as there are threads.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_THREADS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_THREADS_H

#include "Measurement.h"
#include "Table.h"
#include "scans.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// seconds by stage, in the order of the method
typedef std::vector<std::pair<std::string, double>> Stage_seconds;

inline Stage_seconds stages_of(const Hde::Remeshing_result& result)
{
  const double operations = result.split_seconds + result.collapse_seconds + result.flip_seconds + result.smoothing_seconds;
  return {{"implicit function", result.implicit_function_seconds},
          {"projection", result.projection_seconds},
          {"splits", result.split_seconds},
          {"contractions", result.collapse_seconds},
          {"flips", result.flip_seconds},
          {"smoothing", result.smoothing_seconds},
          {"rest of the remeshing", result.remeshing_seconds - operations},
          {"output", result.output_seconds}};
}

// the least of each stage over a few runs, and the mesh
inline Stage_seconds best_stages(const Case& c, const std::size_t threads, shapes::Mesh& mesh)
{
  static constexpr int number_of_runs = 3;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Stage_seconds best;
  for (int run = 0; run < number_of_runs; ++run)
  {
    mesh = c.input;
    const Stage_seconds stages = stages_of(CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, params::relative_sigma(c.relative_sigma).number_of_target_faces(c.number_of_target_faces)));
    if (best.empty())
      best = stages;
    for (std::size_t k = 0; k < stages.size(); ++k)
      best[k].second = (std::min)(best[k].second, stages[k].second);
  }
  return best;
}

// of as many evaluations on each thread
inline double seconds_of_evaluations(const Rbf_function& function, const std::vector<shapes::Point_3>& points,
                                     const std::size_t number_of_threads)
{
  std::vector<double> sums(number_of_threads);
  return seconds_of(
      [&]
      {
        std::vector<std::thread> threads;
        for (std::size_t t = 0; t < number_of_threads; ++t)
          threads.emplace_back(
              [&, t]
              {
                double sum = 0;
                for (const shapes::Point_3& p : points)
                  sum += function.value_and_gradient(p).first;
                sums[t] = sum;
              });
        for (std::thread& thread : threads)
          thread.join();
      });
}

inline double speed_up_of_evaluations(const Case& c, const std::size_t number_of_threads)
{
  static constexpr int number_of_runs = 5;
  const Rbf_function function(c.input);
  const std::vector<shapes::Point_3> points(c.input.points().begin(), c.input.points().end());
  double one = seconds_of_evaluations(function, points, 1), all = seconds_of_evaluations(function, points, number_of_threads);
  for (int run = 1; run < number_of_runs; ++run)
  {
    one = (std::min)(one, seconds_of_evaluations(function, points, 1));
    all = (std::min)(all, seconds_of_evaluations(function, points, number_of_threads));
  }
  return double(number_of_threads) * one / all;
}

inline bool are_equal(const shapes::Mesh& a, const shapes::Mesh& b)
{
  return a.number_of_faces() == b.number_of_faces() &&
         std::equal(a.points().begin(), a.points().end(), b.points().begin(), b.points().end());
}

inline Table threads_table(const Case& c)
{
  static constexpr std::size_t threads = 2;
  shapes::Mesh by_one, by_all;
  const Stage_seconds one = best_stages(c, 1, by_one), all = best_stages(c, threads, by_all);
  double sum_of_one = 0, sum_of_all = 0;
  for (std::size_t k = 0; k < one.size(); ++k)
  {
    sum_of_one += one[k].second;
    sum_of_all += all[k].second;
  }
  Table table("Threads: " + c.name + " to " + std::to_string(c.number_of_target_faces) + " faces");
  table.add("stage", "1 thread [s]", "2 threads [s]", "speed-up", "share of 2 threads");
  for (std::size_t k = 0; k < one.size(); ++k)
    table.add(one[k].first, one[k].second, all[k].second, one[k].second / all[k].second,
              text(100 * all[k].second / sum_of_all) + "%");
  const double of_all = sum_of_one / sum_of_all, of_evaluations = speed_up_of_evaluations(c, threads);
  table.add("all", sum_of_one, sum_of_all, of_all, "100%");
  table.add("two copies of the evaluation", "", "", of_evaluations, "");
  table.add("all over that; asked 0.85", "", "", of_all / of_evaluations, "");
  table.add("the same mesh", "", "", are_equal(by_one, by_all) ? "yes" : "no", "");
  return table;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_THREADS_H
