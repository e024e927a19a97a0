// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How long a call takes: by the clock, and of the processor, all threads together.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SECONDS_OF_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SECONDS_OF_H

#include <CGAL/Real_timer.h>
#include <CGAL/Timer.h>

template <typename Timer, typename Call>
double seconds_by(const Call& call)
{
  Timer timer;
  timer.start();
  call();
  return timer.time();
}

template <typename Call>
double seconds_of(const Call& call)
{
  return seconds_by<CGAL::Real_timer>(call);
}

template <typename Call>
double processor_seconds_of(const Call& call)
{
  return seconds_by<CGAL::Timer>(call);
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SECONDS_OF_H
