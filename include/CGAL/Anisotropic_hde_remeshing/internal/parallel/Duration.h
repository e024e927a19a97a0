// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_DURATION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_DURATION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// adds the wall time of its scope to a sum
class Duration
{
public:
  explicit Duration(double& seconds) : m_seconds(seconds) { m_timer.start(); }
  ~Duration() { m_seconds += m_timer.time(); }

  Duration(const Duration&) = delete;
  Duration& operator=(const Duration&) = delete;

private:
  double& m_seconds;
  Real_timer m_timer;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARALLEL_DURATION_H
