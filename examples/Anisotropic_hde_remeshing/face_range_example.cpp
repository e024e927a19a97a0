// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes a part of a mesh only: the upper half of a sphere. The lower half keeps its faces, and its descriptors.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Sphere
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
  Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
};

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
  }

  std::vector<Mesh::Face_index> upper, lower;
  for (const Mesh::Face_index f : mesh.faces())
    (mesh.point(mesh.target(mesh.halfedge(f))).z() > 0 ? upper : lower).push_back(f);

  // the number is that of the faces of the range
  CGAL::anisotropic_hde_remeshing(upper, mesh, Sphere(), params::number_of_target_faces(4 * upper.size()));

  bool is_kept = true;
  for (const Mesh::Face_index f : lower)
    is_kept = is_kept && !mesh.is_removed(f);
  std::cout << "of " << upper.size() << " faces " << mesh.number_of_faces() - lower.size() << ", " << lower.size()
            << (is_kept ? " are as they were" : " should be as they were") << "; written to half.off" << std::endl;
  return is_kept && CGAL::IO::write_polygon_mesh("half.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
