// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_THREADS_RUN_IN_PARALLEL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_THREADS_RUN_IN_PARALLEL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Loop_body.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

// The package's file of this name with threads of the standard library in place of TBB, all of whose synchronisation
// ThreadSanitizer sees. More threads than cores, so that they meet in many ways.

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

inline std::size_t number_of_threads = 4; // the test changes it

inline void run_in_parallel(const std::size_t n, const Loop_body& body, const std::size_t grain)
{
  if (number_of_threads == 1)
    return body(0, n);
  const std::size_t part = (std::max)(grain, n / (4 * number_of_threads));
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> errors(number_of_threads);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < number_of_threads; ++k)
    threads.emplace_back(
        [&, k]
        {
          try
          {
            for (std::size_t begin = next.fetch_add(part); begin < n; begin = next.fetch_add(part))
              body(begin, (std::min)(begin + part, n));
          }
          catch (...)
          {
            errors[k] = std::current_exception();
          }
        });
  for (std::thread& thread : threads)
    thread.join();
  for (const std::exception_ptr& error : errors)
    if (error)
      std::rethrow_exception(error);
}

template <typename Vector>
void sort_in_parallel(Vector& elements)
{
  std::sort(elements.begin(), elements.end());
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_THREADS_RUN_IN_PARALLEL_H
