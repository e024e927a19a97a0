// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// A small program of a user: it remeshes a sphere given by a function, with named parameters of the package and of CGAL.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Unit_sphere
{
  typedef Kernel Geom_traits;
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Point_3 Point;
  typedef Kernel::Vector_3 Vector_3;
  typedef Kernel::Sphere_3 Sphere_3;

  FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
  Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
  Sphere_3 bounding_sphere() const { return Sphere_3(CGAL::ORIGIN, 1); }
};

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);

  CGAL::anisotropic_hde_remeshing(
      mesh, Unit_sphere(),
      params::sigma(0.1).number_of_iterations(3).number_of_target_faces(80).vertex_point_map(mesh.points()));

  double farthest = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    farthest = (std::max)(farthest, std::abs(Unit_sphere()(mesh.point(v))));
  std::cout << mesh.number_of_faces() << " faces, at most " << farthest << " off the sphere" << std::endl;
  return mesh.number_of_faces() > 40 && farthest < 1e-9 ? 0 : 1;
}
