// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "Failure.h"
#include "remesh_with.h"

#include <CGAL/Anisotropic_hde_remeshing/Interpolated_vertex_field.h>
#include <CGAL/Anisotropic_hde_remeshing/Scalar_field_embedding.h>

namespace hde_remesh {

Remeshing_result remesh_with_field(Mesh& mesh, const Function_view& function, const Sizes& sizes, const Options& o,
                                   Progress& progress)
{
  namespace Hde = CGAL::Anisotropic_hde_remeshing;
  const Hde::Interpolated_vertex_field field(mesh, *field_of(mesh));
  return remesh_with(Hde::scalar_field_embedding<Point_3>(sizes.sigma, sizes.tau, field), mesh, function, sizes, o, progress);
}

} // namespace hde_remesh
