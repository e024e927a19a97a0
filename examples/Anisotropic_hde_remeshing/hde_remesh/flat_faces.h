// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_FLAT_FACES_H
#define HDE_REMESH_FLAT_FACES_H

#include "Mesh.h"

#include <cstddef>

namespace hde_remesh {

struct Flat_faces
{
  std::size_t number = 0, number_left = 0;
};

// Contracts or flips edges of the faces that have no area, or a height of no more than the tolerance. The surface changes by no more
// than that, its topology stays. What is left of them are faces that cannot go.
Flat_faces remove_flat_faces(Mesh& mesh, double tolerance);

} // namespace hde_remesh

#endif // HDE_REMESH_FLAT_FACES_H
