// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How long a call takes.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SECONDS_OF_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SECONDS_OF_H

#include <CGAL/Real_timer.h>

template <typename Call>
double seconds_of(const Call& call)
{
  CGAL::Real_timer timer;
  timer.start();
  call();
  return timer.time();
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SECONDS_OF_H
