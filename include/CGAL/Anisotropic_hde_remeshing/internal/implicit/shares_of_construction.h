// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SHARES_OF_CONSTRUCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SHARES_OF_CONSTRUCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What is done of the function after each step, as it takes about, to tell who listens.
constexpr double share_of_sample = 0.15, share_of_partition = 0.25, share_of_offsets = 0.35, share_of_first_solution = 0.8,
                 share_of_check = 0.9, share_of_last_solution = 0.99;

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SHARES_OF_CONSTRUCTION_H
