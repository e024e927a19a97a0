// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_LOCAL_OPERATIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_LOCAL_OPERATIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Duration.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Allowed_operations.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_collapser.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_flipper.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Edge_splitter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/operations/Vertex_smoother.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// how many operations were done, and the wall time that they took
struct Operation_statistics
{
  std::size_t number_of_splits = 0, number_of_collapses = 0, number_of_flips = 0;
  double split_seconds = 0, collapse_seconds = 0, flip_seconds = 0, smoothing_seconds = 0;
};

// The paper's four local operations on one mesh, behind one guard, counted and timed.
template <typename ConcurrencyTag, typename Embedding, typename Projection, typename Guard>
class Local_operations
{
  typedef Working_mesh<typename Embedding::Vertex_data> Mesh;

public:
  Local_operations(Mesh& mesh, const Embedding& embedding, const Projection& projection, const Curve_network& curves,
                   const Guard& guard, const Allowed_operations& allowed, Interruption& interruption)
    : m_allowed(allowed),
      m_split(mesh, embedding, projection, curves, guard, interruption),
      m_collapse(mesh, embedding, curves, guard, interruption),
      m_flip(mesh, embedding, guard, interruption),
      m_smooth(mesh, embedding, projection, curves, guard, interruption)
  {
  }

  // returns the number of splits
  template <typename... Arguments>
  std::size_t split(const Arguments&... arguments)
  {
    if (!m_allowed.split)
      return 0;
    const Duration duration(m_statistics.split_seconds);
    const std::size_t count = m_split(arguments...);
    m_statistics.number_of_splits += count;
    return count;
  }

  template <typename... Arguments>
  std::size_t collapse(const Arguments&... arguments)
  {
    if (!m_allowed.collapse)
      return 0;
    const Duration duration(m_statistics.collapse_seconds);
    const std::size_t count = m_collapse(arguments...);
    m_statistics.number_of_collapses += count;
    return count;
  }

  void flip(const Flip_criterion criterion)
  {
    if (!m_allowed.flip)
      return;
    const Duration duration(m_statistics.flip_seconds);
    m_statistics.number_of_flips += m_flip(criterion);
  }

  void smooth(const double ratio, const Smoothing_step kind)
  {
    const Duration duration(m_statistics.smoothing_seconds);
    m_smooth(ratio, kind);
  }

  const Operation_statistics& statistics() const { return m_statistics; }

private:
  const Allowed_operations m_allowed;
  const Edge_splitter<ConcurrencyTag, Embedding, Projection, Guard> m_split;
  const Edge_collapser<ConcurrencyTag, Embedding, Guard> m_collapse;
  const Edge_flipper<ConcurrencyTag, Embedding, Guard> m_flip;
  Vertex_smoother<ConcurrencyTag, Embedding, Projection, Guard> m_smooth;
  Operation_statistics m_statistics;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_LOCAL_OPERATIONS_H
