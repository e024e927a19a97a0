// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "build_function_with.h"

namespace hde_remesh {

Built_function build_with_compact_kernel(const Mesh& mesh, const Options& o)
{
  if (o.kernel == "wendland-c2")
    return build_with<CGAL::Wendland_C2_rbf>(mesh, o);
  if (o.kernel == "wendland-c4")
    return build_with<CGAL::Wendland_C4_rbf>(mesh, o);
  return build_with<CGAL::Wendland_C6_rbf>(mesh, o);
}

Built_function build_function(const Mesh& mesh, const Options& o)
{
  return o.kernel.rfind("wendland", 0) == 0 ? build_with_compact_kernel(mesh, o) : build_with_global_kernel(mesh, o);
}

} // namespace hde_remesh
