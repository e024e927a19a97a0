// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "build_function_with.h"

namespace hde_remesh {

Built_function build_with_global_kernel(const Mesh& mesh, const Options& o)
{
  if (o.kernel == "thin-plate")
    return build_with<CGAL::Thin_plate_rbf>(mesh, o);
  if (o.kernel == "gaussian")
    return build_with<CGAL::Gaussian_rbf>(mesh, o);
  if (o.kernel == "multiquadric")
    return build_with<CGAL::Multiquadric_rbf>(mesh, o);
  if (o.kernel == "inverse-multiquadric")
    return build_with<CGAL::Inverse_multiquadric_rbf>(mesh, o);
  return build_with<CGAL::Polyharmonic_rbf>(mesh, o);
}

} // namespace hde_remesh
