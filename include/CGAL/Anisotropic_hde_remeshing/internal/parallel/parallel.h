// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_PARALLEL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_PARALLEL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Loop_body.h>
#ifdef CGAL_LINKED_WITH_TBB
#  include <CGAL/Anisotropic_hde_remeshing/internal/parallel/run_in_parallel.h>
#endif

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Calls `f(i)` for every i in [0, n), by TBB if the tag asks for it and TBB is linked. `f` writes to places of its own, so the
// result is the same for any number of threads. Below `grain` calls a thread is not worth waking. Once `interruption` is
// requested, no further call begins.
template <typename ConcurrencyTag, typename Function>
void parallel_for(const std::size_t n, const Function& f, const std::size_t grain, Interruption& interruption)
{
  const Loop_body body(f, interruption);
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    if (n > grain)
    {
      run_in_parallel(n, body, grain);
      return;
    }
  }
#else
  static_assert(!(std::is_convertible<ConcurrencyTag, Parallel_tag>::value),
                "Parallel_tag is asked for but TBB is not linked.");
  (void)grain;
#endif
  body(0, n);
}

template <typename ConcurrencyTag, typename Function>
void parallel_for(const std::size_t n, const Function& f, const std::size_t grain = 256)
{
  Interruption never;
  parallel_for<ConcurrencyTag>(n, f, grain, never);
}

// the sum of `f(i)` over i in [0, n), always in the same order of addition
template <typename ConcurrencyTag, typename Function>
double parallel_sum(const std::size_t n, const Function& f)
{
  static constexpr std::size_t part = 4096;
  std::vector<double> sums((n + part - 1) / part, 0.);
  parallel_for<ConcurrencyTag>(
      sums.size(),
      [&](const std::size_t k)
      {
        double sum = 0;
        for (std::size_t i = k * part; i < (std::min)(n, (k + 1) * part); ++i)
          sum += f(i);
        sums[k] = sum;
      },
      1);
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

// No two elements may be equal. So the result is the same with and without threads.
template <typename ConcurrencyTag, typename Vector>
void parallel_sort(Vector& elements)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    sort_in_parallel(elements);
    return;
  }
#endif
  std::sort(elements.begin(), elements.end());
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_PARALLEL_H
