// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Resolves a field on a surface: a steep front on a sphere.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/Anisotropic_hde_remeshing/Scalar_field_embedding.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

struct Sphere
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
  Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
};

// it changes from -1 to 1 near the plane z = 0.2
double front(const Point_3& p) { return std::tanh(20 * (p.z() - 0.2)); }

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);

  // the edges of the mesh will be as long as the front is steep: tau = 0.5, a length over the unit of the field
  const auto embedding =
      CGAL::Anisotropic_hde_remeshing::scalar_field_embedding<Point_3>(0, 0.5, [](const Point_3& p) { return front(p); });
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, Sphere(),
                                                                   params::embedding(embedding).number_of_target_faces(3000));

  std::size_t in_front = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    in_front += std::abs(front(mesh.point(v))) < 0.99 ? 1 : 0;
  std::cout << mesh.number_of_faces() << " faces; " << in_front << " of " << mesh.number_of_vertices()
            << " vertices are in the front; written to front.off" << std::endl;
  return CGAL::IO::write_polygon_mesh("front.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
