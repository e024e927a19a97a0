// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_SHOWN_MESH_H
#define HDE_REMESH_SHOWN_MESH_H

#include "Element_figures.h"
#include "Mesh.h"

#include <cstddef>
#include <vector>

namespace hde_remesh {

// a mesh as a page shows it
struct Shown_mesh
{
  std::size_t number_of_faces = 0; // of the mesh; that of `soup` is smaller if it had to be simplified
  Soup soup;
  std::vector<std::size_t> origins; // of its faces among those of the mesh, for their figures

  bool is_simplified() const { return soup.faces.size() < number_of_faces; }
};

// The mesh itself, or, if it has too many faces, one of about that many by CGAL's simplification; each face of that has the
// figures of the face of the mesh that is nearest to its centroid.
Shown_mesh shown_mesh(const Mesh& mesh, std::size_t largest_number_of_faces);

} // namespace hde_remesh

#endif // HDE_REMESH_SHOWN_MESH_H
