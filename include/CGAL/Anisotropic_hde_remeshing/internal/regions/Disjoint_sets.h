// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_DISJOINT_SETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_DISJOINT_SETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Union_find.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Sets of the numbers below a size, each in one of its own to begin with. boost::disjoint_sets does not compile after
// boost/graph/compressed_sparse_row_graph.hpp, which CGAL's remeshing and parameterization include.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t size)
  {
    m_handles.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
      m_handles.push_back(m_sets.make_set(i));
  }

  // a number that is the same for all of a set
  std::size_t find_set(const std::size_t i) { return *m_sets.find(m_handles[i]); }
  void union_set(const std::size_t i, const std::size_t j) { m_sets.unify_sets(m_handles[i], m_handles[j]); }

private:
  Union_find<std::size_t> m_sets;
  std::vector<Union_find<std::size_t>::handle> m_handles;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_DISJOINT_SETS_H
