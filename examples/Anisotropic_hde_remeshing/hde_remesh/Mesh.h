// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MESH_H
#define HDE_REMESH_MESH_H

#include "Soup.h"

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hde_remesh {

typedef CGAL::Surface_mesh<Point_3> Mesh;

struct Checked_mesh
{
  Mesh mesh;
  std::size_t number_of_isolated_vertices = 0; // points without a face, which the mesh does not have
  std::vector<std::size_t> positions;          // of its vertices among the points
  Soup points;                                 // of which the mesh was made, if the file has no faces
};

// The triangle mesh of a soup, with the vertices and faces in their order. Fails, with the name of the file and the
// place, if the soup is no manifold, consistently oriented mesh of triangles.
// the first thing wrong with the soup ends the program: with the points, and which of them the faces name; with the rest, which
// --repair may mend
void check_points(const Soup& soup, const std::string& file_name);
Checked_mesh mesh_of_soup(const Soup& soup, const std::string& file_name);

Soup soup_of_mesh(const Mesh& mesh);

// the mesh of a soup that was made of one, with the arrays as properties
Mesh mesh_with_arrays(const Soup& soup);

// the vertex property of a mesh that a field comes from
typedef Mesh::Property_map<Mesh::Vertex_index, double> Field;
Field add_field(Mesh& mesh);
std::optional<Field> field_of(const Mesh& mesh);

// the edges and faces of a mesh that has them: whether an edge is a crease, and the region of a face
struct Creases
{
  Mesh::Property_map<Mesh::Edge_index, bool> is_crease;
  Mesh::Property_map<Mesh::Face_index, std::size_t> region;
};
Creases add_creases(Mesh& mesh); // none, and one region
Creases creases_of(const Mesh& mesh);

} // namespace hde_remesh

#endif // HDE_REMESH_MESH_H
