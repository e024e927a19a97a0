// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
#include "build_function_with.h"

namespace hde_remesh {

std::vector<Named_kernel> global_kernels()
{
  return {named_kernel<CGAL::Polyharmonic_rbf>("r3"), named_kernel<CGAL::Thin_plate_rbf>("thin-plate"),
          named_kernel<CGAL::Gaussian_rbf>("gaussian"), named_kernel<CGAL::Multiquadric_rbf>("multiquadric"),
          named_kernel<CGAL::Inverse_multiquadric_rbf>("inverse-multiquadric")};
}

} // namespace hde_remesh
