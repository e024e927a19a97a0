// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes a surface that a function of one's own gives, here an ellipsoid: from 20 triangles to 10,000.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// x^2 + (y/2)^2 + (z/5)^2 - 1: negative inside, its gradient points outward. It need not be a distance.
struct Ellipsoid
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return p.x() * p.x() + p.y() * p.y() / 4 + p.z() * p.z() / 25 - 1; }
  Vector_3 gradient(const Point_3& p) const { return Vector_3(2 * p.x(), p.y() / 2, 2 * p.z() / 25); }
};

int main()
{
  // the mesh to begin with lies near the zero set and has its topology
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Point_3 p = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(p.x(), 2 * p.y(), 5 * p.z());
  }

  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, Ellipsoid(),
                                                                   params::sigma(1.6).number_of_target_faces(10000));

  double largest = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    largest = (std::max)(largest, std::abs(Ellipsoid()(mesh.point(v))));
  std::cout << mesh.number_of_faces() << " faces, written to ellipsoid.off; the function at their vertices: at most " << largest
            << std::endl;
  return CGAL::IO::write_polygon_mesh("ellipsoid.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
