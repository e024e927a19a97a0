// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_SIGNED_DISTANCE_H
#define HDE_REMESH_SIGNED_DISTANCE_H

#include "Mesh.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif

#include <vector>

namespace hde_remesh {

// The distance of points to a mesh: positive on the side that its faces look to, negative on the other. Several threads may ask.
class Signed_distance
{
public:
  explicit Signed_distance(const Mesh& mesh);

  double operator()(const Point_3& p) const;

private:
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef CGAL::AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Primitive> Traits;
#endif

  Vector_3 normal_at(const Point_3& q, Mesh::Face_index face) const;

  const Mesh& m_mesh;
  std::vector<Vector_3> m_normals; // of the faces, of length one, by their indices
  CGAL::AABB_tree<Traits> m_tree;
};

// of the centroids of the faces of `mesh` to `other`
std::vector<double> signed_distances(const Mesh& mesh, const Mesh& other);

} // namespace hde_remesh

#endif // HDE_REMESH_SIGNED_DISTANCE_H
