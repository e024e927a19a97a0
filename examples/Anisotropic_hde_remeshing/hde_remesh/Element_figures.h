// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_ELEMENT_FIGURES_H
#define HDE_REMESH_ELEMENT_FIGURES_H

#include "Function_view.h"
#include "Mesh.h"

#include <vector>

namespace hde_remesh {

// what can be told of each element of a mesh, in the order of the mesh; lengths in its unit, angles in degrees
struct Element_figures
{
  bool is_by_function = true;          // else the surface is the other mesh, and lengths and angles are those in space
  std::vector<double> aspect_ratios;   // of the faces: q_T, infinite for a degenerate one
  std::vector<double> smallest_angles; // of the faces, in the embedding
  std::vector<double> face_distances;  // of the centroids of the faces from the surface
  std::vector<double> edge_lengths;    // in the embedding
  std::vector<Vector_3> normals;       // of the surface at the vertices, of length one
  std::vector<double> vertex_distances;
};

// Of a mesh on the zero set of a function. Where the function has no values, the surface is the other mesh.
Element_figures figures_of_elements(const Mesh& mesh, const Function_view& function, double sigma, const Mesh& other);

// adds those of the vertices and of the faces to the soup of the same mesh
void add_arrays(const Element_figures& figures, Soup& soup);

} // namespace hde_remesh

#endif // HDE_REMESH_ELEMENT_FIGURES_H
