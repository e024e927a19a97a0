// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_LOOP_BODY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_LOOP_BODY_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>

#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The body of a loop, called for parts of its range. It does not have the type of the function, so TBB's loop is compiled once
// for all bodies.
class Loop_body
{
public:
  template <typename Function>
  Loop_body(const Function& f, Interruption& interruption) : m_function(&f), m_interruption(interruption), m_run(&run<Function>)
  {
  }

  void operator()(const std::size_t begin, const std::size_t end) const { m_run(m_function, m_interruption, begin, end); }

private:
  template <typename Function>
  static void run(const void* f, Interruption& interruption, const std::size_t begin, const std::size_t end)
  {
    for (std::size_t i = begin; i != end && !interruption.poll(); ++i)
      (*static_cast<const Function*>(f))(i);
  }

  const void* m_function;
  Interruption& m_interruption;
  void (*m_run)(const void*, Interruption&, std::size_t, std::size_t);
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_LOOP_BODY_H
