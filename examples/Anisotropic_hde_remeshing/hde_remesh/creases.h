// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The creases of a mesh, and the regions between them.

#ifndef HDE_REMESH_CREASES_H
#define HDE_REMESH_CREASES_H

#include "Mesh.h"
#include "options.h"

namespace hde_remesh {

// gives the mesh its creases and the regions between them; without --sharp one region
void find_creases(Mesh& mesh, const Options& options);

} // namespace hde_remesh

#endif // HDE_REMESH_CREASES_H
