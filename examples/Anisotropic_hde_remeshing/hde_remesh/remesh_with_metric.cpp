// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "remesh_with.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>

#include <limits>

namespace hde_remesh {

Remeshing_result remesh_with_metric(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                    Progress& progress)
{
  const double p = o.metric.value_or(std::numeric_limits<double>::infinity());
  return remesh_with(CGAL::Anisotropic_hde_remeshing::Curvature_metric(p), mesh, function, sizes, o, progress);
}

} // namespace hde_remesh
