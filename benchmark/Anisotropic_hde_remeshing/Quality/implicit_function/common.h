// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the sections of benchmark_implicit_function share: the meshes, points on them, and how long a call takes.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_COMMON_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_COMMON_H

#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Rbf_function;

struct Input
{
  std::string name;
  Mesh mesh;
  std::size_t number_of_target_faces = 0; // of the remeshing that the build is compared with
};

// points spread evenly over the area, in the order of the faces
inline std::vector<Point_3> points_on(const Mesh& mesh, const std::size_t number_of_points)
{
  const Hde::internal::Measured_mesh measured = Hde::internal::read_measured_mesh(mesh, CGAL::parameters::default_values());
  const Hde::internal::Area_sampler sampler(measured, number_of_points);
  std::vector<Point_3> points;
  points.reserve(sampler.size());
  for (std::size_t i = 0; i < sampler.size(); ++i)
  {
    const Hde::internal::Vector p = sampler(i);
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

// the least of several runs: what else runs on the machine only adds to it
template <typename Call>
double best_seconds_of(const Call& call, const int number_of_runs)
{
  double best = seconds_of(call);
  for (int i = 1; i < number_of_runs; ++i)
    best = (std::min)(best, seconds_of(call));
  return best;
}

// Microseconds of an evaluation of value and gradient, in one thread. The points are run through several times, in their
// order; of each short stretch of them the best time counts, so that most of what else runs on the machine falls out.
template <typename Function>
double microseconds_of_evaluation(const Function& function, const std::vector<Point_3>& points)
{
  static constexpr std::size_t stretch = 500;
  static constexpr int number_of_runs = 5;
  std::vector<double> best((points.size() + stretch - 1) / stretch, (std::numeric_limits<double>::max)());
  double sum = 0;
  for (int run = 0; run < number_of_runs; ++run)
    for (std::size_t k = 0; k < best.size(); ++k)
    {
      const auto evaluate = [&]
      {
        for (std::size_t i = k * stretch; i < (std::min)((k + 1) * stretch, points.size()); ++i)
          sum += function.value_and_gradient(points[i]).first;
      };
      best[k] = (std::min)(best[k], seconds_of(evaluate));
    }
  const volatile double use_of_sum = sum; // so that nothing is optimised away
  (void)use_of_sum;
  return 1e6 * std::accumulate(best.begin(), best.end(), 0.) / double(points.size());
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_COMMON_H
