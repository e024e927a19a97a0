// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_INTERSECTING_FACES_H
#define HDE_REMESH_INTERSECTING_FACES_H

#include "Mesh.h"

#include <cstddef>

namespace hde_remesh {

struct Intersecting_faces
{
  std::size_t number = 0, number_left = 0; // of pairs
  std::size_t number_of_new_points = 0;    // that have moved, or come
};

// Untangles faces that intersect, by CGAL: smooths around them, or fills holes in their place. The topology stays. The mesh is only
// changed if fewer pairs are left.
Intersecting_faces untangle(Mesh& mesh);

} // namespace hde_remesh

#endif // HDE_REMESH_INTERSECTING_FACES_H
