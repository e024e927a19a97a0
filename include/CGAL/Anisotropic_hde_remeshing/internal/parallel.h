// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/Interruption.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/blocked_range.h>
#  include <tbb/parallel_for.h>
#  include <tbb/parallel_sort.h>
#endif

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Calls `f(i)` for every i in [0, n), by TBB if the tag asks for it and TBB is linked. `f` writes to places of its own, so
// that the result is the same for any number of threads. Below `grain` calls a thread is not worth waking. Once
// `interruption` is requested the calls that have not begun are left out.
template <typename ConcurrencyTag, typename Function>
void parallel_for(const std::size_t n, const Function& f, const std::size_t grain, Interruption& interruption)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    if (n > grain)
    {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                        [&](const tbb::blocked_range<std::size_t>& range)
                        {
                          for (std::size_t i = range.begin(); i != range.end(); ++i)
                          {
                            if (interruption.poll())
                              return;
                            f(i);
                          }
                        });
      return;
    }
  }
#else
  static_assert(!(std::is_convertible<ConcurrencyTag, Parallel_tag>::value),
                "Parallel_tag is asked for but TBB is not linked.");
  (void)grain;
#endif
  for (std::size_t i = 0; i < n && !interruption.poll(); ++i)
    f(i);
}

template <typename ConcurrencyTag, typename Function>
void parallel_for(const std::size_t n, const Function& f, const std::size_t grain = 256)
{
  Interruption never;
  parallel_for<ConcurrencyTag>(n, f, grain, never);
}

// the same result with and without threads, as no two elements may be equal
template <typename ConcurrencyTag, typename Vector>
void parallel_sort(Vector& elements)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::parallel_sort(elements.begin(), elements.end());
    return;
  }
#endif
  std::sort(elements.begin(), elements.end());
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_H
