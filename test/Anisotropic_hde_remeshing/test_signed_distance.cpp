// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The signed distance of the page of hde_remesh --report: its sign beside faces, sharp edges and vertices, and on open meshes.

#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/Signed_distance.h"
#include "check.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using hde_remesh::Kernel;
using hde_remesh::Mesh;
using hde_remesh::Point_3;

// a tetrahedron with a sharp tip, where the normal of the face that is found says little
Mesh spike()
{
  Mesh mesh;
  const Mesh::Vertex_index a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0)),
                           c = mesh.add_vertex(Point_3(0, 1, 0)), tip = mesh.add_vertex(Point_3(4, 0.1, 0.3));
  mesh.add_face(a, c, b);
  mesh.add_face(a, b, tip);
  mesh.add_face(b, c, tip);
  mesh.add_face(c, a, tip);
  return mesh;
}

// two of its sides pushed in, so that an edge is concave
Mesh roof()
{
  Mesh mesh;
  const Mesh::Vertex_index a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(2, 0, 0)),
                           c = mesh.add_vertex(Point_3(2, 2, 0)), d = mesh.add_vertex(Point_3(0, 2, 0)),
                           e = mesh.add_vertex(Point_3(0, 1, -1)), f = mesh.add_vertex(Point_3(2, 1, -1)),
                           g = mesh.add_vertex(Point_3(1, 1, -3));
  mesh.add_face(a, e, f);
  mesh.add_face(a, f, b);
  mesh.add_face(e, d, c);
  mesh.add_face(e, c, f);
  mesh.add_face(a, b, g);
  mesh.add_face(b, f, g);
  mesh.add_face(f, c, g);
  mesh.add_face(c, d, g);
  mesh.add_face(d, e, g);
  mesh.add_face(e, a, g);
  CGAL::Polygon_mesh_processing::orient(mesh);
  return mesh;
}

// against CGAL's test for closed meshes, on a grid that has points nearest to each face, edge and vertex
void check_sides(const Mesh& mesh)
{
  CHECK(mesh.is_valid() && CGAL::is_closed(mesh));
  const hde_remesh::Signed_distance distance(mesh);
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(mesh);
  const int n = 24;
  std::size_t number_inside = 0, number_wrong = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
      {
        const Point_3 p(-1 + 6.013 * i / n, -1 + 4.017 * j / n, -4 + 6.011 * k / n);
        const bool is_inside = side(p) == CGAL::ON_BOUNDED_SIDE;
        number_inside += is_inside;
        number_wrong += (distance(p) < 0) != is_inside;
      }
  CHECK(number_inside > 10);
  CHECK(number_wrong == 0);
}

void check_open_mesh()
{
  Mesh mesh;
  const Mesh::Vertex_index a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(1, 0, 0)),
                           c = mesh.add_vertex(Point_3(0, 1, 0));
  mesh.add_face(a, b, c);
  const hde_remesh::Signed_distance distance(mesh);
  CHECK_CLOSE(distance(Point_3(0.2, 0.2, 0.5)), 0.5, 1e-15);
  CHECK_CLOSE(distance(Point_3(0.2, 0.2, -0.5)), -0.5, 1e-15);
  CHECK_CLOSE(distance(Point_3(0.5, -3, 4)), 5, 1e-14);
  CHECK_CLOSE(distance(Point_3(0.5, -3, -4)), -5, 1e-14);
  CHECK(distance(Point_3(0.2, 0.2, 0)) == 0);
}

// a mesh moved along a normal is as far from the other, with the sign of the way
void check_meshes()
{
  Mesh mesh = spike();
  for (const double way : {0.01, -0.01})
  {
    Mesh moved = mesh;
    for (const Mesh::Vertex_index v : moved.vertices())
      moved.point(v) = Point_3(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z() - way);
    const std::vector<double> distances = hde_remesh::signed_distances(moved, mesh);
    CHECK(distances.size() == mesh.number_of_faces());
    CHECK_CLOSE(distances[0], way, 1e-12); // the face at the bottom
  }
}

} // namespace

int main()
{
  check_sides(spike());
  check_sides(roof());
  check_open_mesh();
  check_meshes();
  return check_summary();
}
