// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_STOPWATCH_H
#define HDE_REMESH_STOPWATCH_H

#include <chrono>

namespace hde_remesh {

// wall time
class Stopwatch
{
  typedef std::chrono::steady_clock Clock;

public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // the seconds so far; begins anew
  double lap()
  {
    const double result = seconds();
    m_start = Clock::now();
    return result;
  }

private:
  Clock::time_point m_start = Clock::now();
};

} // namespace hde_remesh

#endif // HDE_REMESH_STOPWATCH_H
