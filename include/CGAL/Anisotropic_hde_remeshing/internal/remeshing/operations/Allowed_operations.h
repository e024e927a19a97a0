// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ALLOWED_OPERATIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ALLOWED_OPERATIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// what the caller lets the remeshing do
struct Allowed_operations
{
  bool split = true, collapse = true, flip = true;
  // along boundaries, constrained edges and creases
  bool collapse_on_curves = true, smooth_on_curves = true;

  // all that the remeshing by measured error is made of
  bool has_all_of_mesh() const { return split && collapse && flip; }
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_OPERATIONS_ALLOWED_OPERATIONS_H
