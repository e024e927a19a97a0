// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The sections on the build: its time and memory, and threads.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_BUILD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_BUILD_H

#include "Peak_memory.h"
#include "Table.h"
#include "common.h"
#include "isotropic_remeshing.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// several runs of a build
struct Build
{
  std::vector<double> seconds;
  double peak_megabytes = 0;
  Hde::Rbf_diagnostics diagnostics; // of the last run

  void run(const Mesh& mesh)
  {
    const Peak_memory memory;
    CGAL::Real_timer timer;
    timer.start();
    const Rbf_function function(mesh);
    seconds.push_back(timer.time());
    peak_megabytes = (std::max)(peak_megabytes, memory.megabytes());
    diagnostics = function.diagnostics();
  }
};

// a finer mesh of the same surface: long edges are split until there are so many faces, and all vertices are moved onto the
// zero set by Newton's method
inline Mesh subdivided(const Mesh& input, const std::size_t number_of_faces)
{
  const Rbf_function function(input);
  Mesh mesh = input;
  double length = 3 * length_of_edges(input, number_of_faces);
  for (; mesh.number_of_faces() < number_of_faces; length *= 0.98)
    CGAL::Polygon_mesh_processing::split_long_edges(edges(mesh), length, mesh);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    Point_3 p = mesh.point(v);
    for (int step = 0; step < 4; ++step)
    {
      const auto at_p = function.value_and_gradient(p);
      p = p - at_p.first / at_p.second.squared_length() * at_p.second;
    }
    if (CGAL::squared_distance(p, mesh.point(v)) < length * length) // not a number where the gradient vanishes
      mesh.point(v) = p;
  }
  return mesh;
}

// --- (d) ---

inline void add_build(Table& table, const std::string& what, const std::size_t number_of_faces, const Build& build,
                      const std::string& memory_asked)
{
  const Hde::Rbf_diagnostics& diagnostics = build.diagnostics;
  table.add(what + ", faces", number_of_faces);
  table.add(what + ", seconds", median(build.seconds));
  table.add("  of the last run: input, partition, constraints, solve",
            text(diagnostics.input_seconds) + " " + text(diagnostics.partition_seconds) + " " +
                text(diagnostics.constraint_seconds) + " " + text(diagnostics.solve_seconds));
  table.add("  patches, those on fallback, repaired", text(diagnostics.number_of_patches) + " " +
                                                          text(diagnostics.patches_on_fallback) + " " +
                                                          text(diagnostics.patches_repaired));
  table.add("  centres of a patch, mean and largest", text(diagnostics.mean_centres) + " " + text(diagnostics.max_centres));
  table.add("  MB of the function", 1e-6 * double(diagnostics.memory_bytes));
  table.add("  MB of the process while building, at its highest", build.peak_megabytes, memory_asked);
}

inline void run_build_section(const Input& input)
{
  static constexpr int number_of_runs = 3;
  static constexpr std::size_t faces_of_fine_mesh = 400000;
  Table table("(d) build: " + input.name + ", medians of 3 runs in turn; asked of the Stanford bunny");
  table.add("", "measured", "asked");
  Build build, fine_build;
  const double length = isotropic_length(input.mesh, input.number_of_target_faces);
  const Mesh fine = subdivided(input.mesh, faces_of_fine_mesh);
  std::vector<double> isotropic_seconds;
  std::size_t isotropic_faces = 0;
  for (int run = 0; run < number_of_runs; ++run)
  {
    build.run(input.mesh);
    isotropic_seconds.push_back(
        seconds_of([&] { isotropic_faces = isotropically_remeshed(input.mesh, length).number_of_faces(); }));
    fine_build.run(fine);
  }
  add_build(table, "the mesh", input.mesh.number_of_faces(), build, "");
  table.add("isotropic_remeshing, 10 iterations, faces", isotropic_faces);
  table.add("isotropic_remeshing, seconds", median(isotropic_seconds));
  table.add("build over isotropic_remeshing", median(build.seconds) / median(isotropic_seconds), "0.5");
  add_build(table, "the mesh subdivided", fine.number_of_faces(), fine_build, "300");
  table.add("faces subdivided over faces", double(fine.number_of_faces()) / double(input.mesh.number_of_faces()));
  table.add("build subdivided over build", median(fine_build.seconds) / median(build.seconds), "12");
  table.print();
}

// --- (f) ---

#ifdef CGAL_LINKED_WITH_TBB

struct Build_with_threads
{
  double seconds = 0;
  std::vector<double> values; // of value and gradient at the points
};

inline Build_with_threads build_with_threads(const Mesh& mesh, const std::vector<Point_3>& points,
                                             const std::size_t number_of_threads)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, number_of_threads);
  Build_with_threads result;
  result.seconds = best_seconds_of([&] { Rbf_function function(mesh); }, 3);
  const Rbf_function function(mesh);
  for (const Point_3& p : points)
  {
    const auto at_p = function.value_and_gradient(p);
    result.values.insert(result.values.end(), {at_p.first, at_p.second.x(), at_p.second.y(), at_p.second.z()});
  }
  return result;
}

inline bool are_bitwise_equal(const std::vector<double>& first, const std::vector<double>& second)
{
  return first.size() == second.size() && std::memcmp(first.data(), second.data(), first.size() * sizeof(double)) == 0;
}

inline void run_thread_section(const std::vector<Input>& inputs)
{
  Table table("(f) threads: build, best of 3; values and gradients of the two functions at 20000 points of the mesh");
  table.add("mesh", "1 thread, s", "2 threads, s", "speedup", "bitwise equal", "asked");
  for (const Input& input : inputs)
  {
    const std::vector<Point_3> points = points_on(input.mesh, 20000);
    const Build_with_threads one = build_with_threads(input.mesh, points, 1), two = build_with_threads(input.mesh, points, 2);
    table.add(input.name, one.seconds, two.seconds, one.seconds / two.seconds,
              are_bitwise_equal(one.values, two.values) ? "yes" : "NO", "yes");
  }
  table.print();
}

#else

inline void run_thread_section(const std::vector<Input>&) { Table("(f) threads: not measured, as TBB is not linked").print(); }

#endif

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_BUILD_H
