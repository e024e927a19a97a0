// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_WORKING_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_WORKING_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Jet.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <iostream>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A vertex as the operations see it: where it is, and its unit normal, the direction of the function's gradient.
struct Vertex_state
{
  Vector point = Vector::Zero();
  Vector normal = Vector::Zero();
  int curve = -1;           // the boundary curve on which the vertex lies, -1 inside
  double parameter = 0;     // where on that curve
  bool is_fixed = false;    // never moved nor removed

  bool is_on_boundary() const { return curve >= 0; }
};

// for the input and output that Surface_mesh declares for its points; nothing here uses them
inline std::ostream& operator<<(std::ostream& out, const Vertex_state& v) { return out << v.point.transpose(); }
inline std::istream& operator>>(std::istream& in, Vertex_state& v) { return in >> v.point[0] >> v.point[1] >> v.point[2]; }

// The mesh that is modified: a copy of the caller's, whatever its type, so that the caller's is untouched until the end and
// the result does not depend on how it numbers and recycles its elements.
typedef CGAL::Surface_mesh<Vertex_state> Working_mesh;
typedef Working_mesh::Vertex_index Vertex_index;
typedef Working_mesh::Halfedge_index Halfedge_index;
typedef Working_mesh::Edge_index Edge_index;
typedef Working_mesh::Face_index Face_index;

// the numbers of places that vectors indexed by vertices, edges, faces need, removed elements included
inline std::size_t vertex_capacity(const Working_mesh& mesh) { return mesh.num_vertices(); }
inline std::size_t edge_capacity(const Working_mesh& mesh) { return mesh.num_edges(); }
inline std::size_t face_capacity(const Working_mesh& mesh) { return mesh.num_faces(); }

// the three vertices of the face of a halfedge that is not on the border
struct Triangle
{
  Vertex_index a, b, c;

  Triangle(const Halfedge_index h, const Working_mesh& mesh)
    : a(mesh.source(h)), b(mesh.target(h)), c(mesh.target(mesh.next(h)))
  {
  }
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_WORKING_MESH_H
