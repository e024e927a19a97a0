// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The section on the time of an evaluation.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_EVALUATION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_EVALUATION_H

#include "Table.h"
#include "common.h"

#include <CGAL/Radial_basis_functions.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

// r^3 that counts for how many centres it is evaluated, those that fill up the last block of a patch included
struct Counting_rbf : CGAL::Polyharmonic_rbf
{
  static std::size_t& counter() // a thread, as functions are built in parallel
  {
    static thread_local std::size_t count = 0;
    return count;
  }

  static std::size_t number_of_terms(const double&) { return 1; }
  template <typename Derived>
  static std::size_t number_of_terms(const Eigen::ArrayBase<Derived>& array)
  {
    return std::size_t(array.size());
  }

  template <class T>
  CGAL::Rbf_jet<T> operator()(const T& squared_radius) const
  {
    counter() += number_of_terms(squared_radius);
    return Polyharmonic_rbf::operator()(squared_radius);
  }
};

// The terms of the kernel sums of one evaluation, in the mean over the points and over all the patches that are blended at
// them: a function that is the same but for its counting kernel is evaluated.
inline double mean_number_of_terms(const Mesh& mesh, const std::vector<Point_3>& points)
{
  const CGAL::Rbf_implicit_function<Kernel, Counting_rbf, CGAL::Parallel_if_available_tag> function(mesh);
  Counting_rbf::counter() = 0;
  for (const Point_3& p : points)
    function.value_and_gradient(p);
  return double(Counting_rbf::counter()) / double(points.size());
}

// of one of many square roots, as fast as the machine takes them from a block that fits into its fastest cache
inline double nanoseconds_of_square_root()
{
  static constexpr int size = 1024, passes = 2000;
  Eigen::Array<double, size, 1> numbers = Eigen::Array<double, size, 1>::LinSpaced(1, 2);
  const double seconds = best_seconds_of(
      [&numbers]
      {
        for (int pass = 0; pass < passes; ++pass)
          numbers = (numbers + 1.).sqrt();
      },
      20);
  const volatile double use_of_numbers = numbers.sum(); // so that nothing is optimised away
  (void)use_of_numbers;
  return 1e9 * seconds / (double(size) * passes);
}

// --- (c) ---

inline void run_evaluation_section(const std::vector<Input>& inputs)
{
  static constexpr std::size_t number_of_points = 100000;
  Table table("(c) an evaluation of value and gradient at points of the mesh, one thread; a term is a centre of a patch that "
              "counts at the point, counted by the kernel; ns/sqrt is the machine's throughput");
  table.add("mesh", "faces", "us", "terms", "ns/term", "ns/sqrt", "ns/sqrt over ns/term");
  for (const Input& input : inputs)
  {
    const std::vector<Point_3> points = points_on(input.mesh, number_of_points);
    const double microseconds = microseconds_of_evaluation(Rbf_function(input.mesh), points);
    const double terms = mean_number_of_terms(input.mesh, points), of_term = 1000 * microseconds / terms,
                 of_root = nanoseconds_of_square_root();
    table.add(input.name, input.mesh.number_of_faces(), microseconds, terms, of_term, of_root,
              text(100 * of_root / of_term) + "%");
  }
  table.print();
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_EVALUATION_H
