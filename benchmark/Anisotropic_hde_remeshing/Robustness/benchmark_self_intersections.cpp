// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the tests of self-intersection do and cost: remeshes each mesh with and without them, in all modes, at its own number of faces,
// half and a tenth of it, and counts the pairs of faces that intersect by CGAL. Prints a line for each, and in the end, for each mode, how
// many results have more pairs than the input, and the time with the tests over that without. The times are those of the processor, of
// all threads: so other work beside counts for little. With --pairs each mesh is remeshed once, with the tests, and only the pairs are
// counted. The exit status is 0 if none has more.
//
// benchmark_self_intersections [--pairs] MESH...

#include "mesh_quality.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <string>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Function;

struct Sum
{
  int number = 0, with_more_pairs = 0, with_more_pairs_without_tests = 0;
  double log_of_ratios = 0, largest_ratio = 0;
};
typedef std::map<std::string, Sum> Sums; // by mode

// remeshes once, with the tests
template <typename Remesh>
void count_pairs(const std::string& mode, const Mesh& input, const std::size_t before, const std::size_t number_of_faces,
                 const Remesh& remesh, Sums& sums)
{
  Mesh mesh = input;
  remesh(mesh, true);
  mesh.collect_garbage();
  const std::size_t pairs = number_of_self_intersections(mesh);
  std::cout << "  " << std::left << std::setw(14) << mode << std::right << std::setw(8) << number_of_faces
            << " faces: " << mesh.number_of_faces() << ", pairs before " << before << ", after " << pairs
            << (pairs > before ? "  MORE" : "") << std::endl;
  ++sums[mode].number;
  sums[mode].with_more_pairs += pairs > before ? 1 : 0;
}

// remeshes with and without the tests, and takes the times
template <typename Remesh>
void compare(const std::string& mode, const Mesh& input, const std::size_t before, const std::size_t number_of_faces,
             const Remesh& remesh, Sums& sums)
{
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  static constexpr double least_seconds = 0.1; // of a run that tells the time
  static constexpr double enough_seconds = 3;  // of all runs: short ones are run again, the least time counts
  static constexpr int largest_number_of_runs = 5;
  std::array<double, 2> seconds{{infinity, infinity}};
  std::array<std::size_t, 2> pairs{{0, 0}};
  Mesh mesh;
  double all_seconds = 0;
  for (int i = 0; i < largest_number_of_runs && all_seconds < enough_seconds; ++i)
    for (const bool has_tests : {false, true})
    {
      mesh = input;
      const double s = processor_seconds_of([&] { remesh(mesh, has_tests); });
      seconds[has_tests] = (std::min)(seconds[has_tests], s);
      all_seconds += s;
      mesh.collect_garbage();
      pairs[has_tests] = number_of_self_intersections(mesh);
    }
  std::cout << "  " << std::left << std::setw(14) << mode << std::right << std::setw(8) << number_of_faces
            << " faces: " << mesh.number_of_faces() << ", pairs before " << before << ", without tests " << pairs[0]
            << ", with " << pairs[1] << ", " << std::fixed << std::setprecision(2) << seconds[0] << " s, " << seconds[1] << " s"
            << (pairs[1] > before ? "  MORE" : "") << std::endl;
  Sum& sum = sums[mode];
  sum.with_more_pairs += pairs[1] > before ? 1 : 0;
  sum.with_more_pairs_without_tests += pairs[0] > before ? 1 : 0;
  if (seconds[0] < least_seconds)
    return;
  ++sum.number;
  sum.log_of_ratios += std::log(seconds[1] / seconds[0]);
  sum.largest_ratio = (std::max)(sum.largest_ratio, seconds[1] / seconds[0]);
}

void run_all(const Mesh& input, const bool has_times, Sums& sums)
{
  const Function function(input);
  const std::size_t before = number_of_self_intersections(input);
  for (const double share : {1., 0.5, 0.1})
  {
    const std::size_t n = (std::max)(std::size_t(share * double(input.number_of_faces())), std::size_t(1));
    const auto with = [&](const std::string& mode, const auto& remesh)
    { has_times ? compare(mode, input, before, n, remesh, sums) : count_pairs(mode, input, before, n, remesh, sums); };
    const auto on_function = [&](const auto& np)
    {
      return [&function, np](Mesh& mesh, const bool has_tests)
      { CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, np.do_self_intersection_tests(has_tests)); };
    };
    const auto on_mesh = [&](const auto& np)
    {
      return [np](Mesh& mesh, const bool has_tests)
      { CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.do_self_intersection_tests(has_tests)); };
    };
    const auto np = params::number_of_target_faces(n);
    with("sigma .01", on_function(np.relative_sigma(0.01)));
    with("sigma .05", on_function(np.relative_sigma(0.05)));
    with("metric 2", on_function(np.embedding(Hde::Curvature_metric(2))));
    with("sharp 30", on_mesh(np.relative_sigma(0.02).sharp_angle(30)));
    if (share == 1)
      continue; // by measured error the mesh would stay
    with("no option", on_mesh(np));
    with("fit", on_mesh(np.fit_to_surface(true)));
  }
}

int main(int argc, char* argv[])
{
  Sums sums;
  const bool has_times = argc < 2 || std::string(argv[1]) != "--pairs";
  for (int i = has_times ? 1 : 2; i < argc; ++i)
    try
    {
      Mesh mesh;
      if (!PMP::IO::read_polygon_mesh(argv[i], mesh) || !CGAL::is_triangle_mesh(mesh))
        continue;
      PMP::remove_isolated_vertices(mesh);
      mesh.collect_garbage();
      std::cout << argv[i] << std::endl;
      run_all(mesh, has_times, sums);
    }
    catch (const std::exception& e)
    {
      std::cout << argv[i] << " is refused: " << e.what() << std::endl;
    }
  int number = 0;
  for (const auto& [mode, sum] : sums)
  {
    number += sum.with_more_pairs;
    if (!has_times)
    {
      std::cout << std::left << std::setw(14) << mode << std::right << "more pairs than before: " << sum.with_more_pairs
                << " of " << sum.number << " results" << std::endl;
      continue;
    }
    std::cout << std::left << std::setw(14) << mode << std::right << "more pairs than before: " << sum.with_more_pairs
              << " results, without tests " << sum.with_more_pairs_without_tests << "; time over that without: mean "
              << std::exp(sum.log_of_ratios / (std::max)(sum.number, 1)) << ", largest " << sum.largest_ratio << std::endl;
  }
  return number > 0;
}
