// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
#include "build_function_with.h"

namespace hde_remesh {

std::vector<Named_kernel> compact_kernels()
{
  return {named_kernel<CGAL::Wendland_C2_rbf>("wendland-c2"), named_kernel<CGAL::Wendland_C4_rbf>("wendland-c4"),
          named_kernel<CGAL::Wendland_C6_rbf>("wendland-c6")};
}

} // namespace hde_remesh
