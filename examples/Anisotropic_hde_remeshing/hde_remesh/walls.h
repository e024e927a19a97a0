// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Edges with more than two faces, where closed solids have a wall between them.

#ifndef HDE_REMESH_WALLS_H
#define HDE_REMESH_WALLS_H

#include "Soup.h"

#include <cstddef>

namespace hde_remesh {

// Removes walls between two solids, which are one then: faces that are there twice, once each way, if their edges are edges of two
// other faces each. Returns how many faces are gone.
std::size_t remove_double_walls(Soup& soup);

// The same for walls that are there once. Of three surfaces that meet in all their edges, the smallest one is the wall.
std::size_t remove_single_walls(Soup& soup);

} // namespace hde_remesh

#endif // HDE_REMESH_WALLS_H
