// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Edges with more than two faces, where closed solids touch each other.

#ifndef HDE_REMESH_SOLIDS_H
#define HDE_REMESH_SOLIDS_H

#include "Soup.h"

#include <cstddef>

namespace hde_remesh {

// Doubles points so that solids that touch each other in edges or points do so no more: at an edge with several faces, a solid lies
// between two that follow each other around it. Edges whose faces do not look out of solids stay. Returns how many points are new.
std::size_t separate_solids(Soup& soup);

} // namespace hde_remesh

#endif // HDE_REMESH_SOLIDS_H
