// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_RUN_IN_PARALLEL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_RUN_IN_PARALLEL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Loop_body.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <cstddef>

// All that the package asks of TBB. ThreadSanitizer cannot see TBB's own synchronisation, which is in a library. So the test of
// the threads has another file of this name.

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

inline void run_in_parallel(const std::size_t n, const Loop_body& body, const std::size_t grain)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
}

template <typename Vector>
void sort_in_parallel(Vector& elements)
{
  tbb::parallel_sort(elements.begin(), elements.end());
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_RUN_IN_PARALLEL_H
