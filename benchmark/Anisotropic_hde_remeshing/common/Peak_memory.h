// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_PEAK_MEMORY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_PEAK_MEMORY_H

#if defined(__linux__)
#  include <malloc.h>
#  include <sys/resource.h>

#  include <fstream>
#endif

// By how much the memory of the process grows at its highest from the construction on. Freed memory is given back to the
// system and the high-water mark put down to what is in use first; where the system does not let it be put down, the
// growth is one of the mark, and too small. Measured on Linux only, elsewhere 0.
class Peak_memory
{
public:
  Peak_memory()
  {
#if defined(__linux__)
#  if defined(__GLIBC__)
    malloc_trim(0);
#  endif
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
#endif
    m_before = peak();
  }

  double megabytes() const { return peak() - m_before; }

private:
  static double peak()
  {
#if defined(__linux__)
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) * 1024 / 1e6;
#else
    return 0;
#endif
  }

  double m_before = 0;
};

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_PEAK_MEMORY_H
