// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "remesh_with.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>

namespace hde_remesh {

Remeshing_result remesh_with_adaptive_sigma(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                            Progress& progress)
{
  return remesh_with(CGAL::Anisotropic_hde_remeshing::Adaptive_normal_embedding(), mesh, function, sizes, o, progress);
}

} // namespace hde_remesh
