// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Lengths that are wanted at each place: by a function of a point, and by a property of the vertices of the input.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Parallel_if_available_tag Tag;

struct Sphere
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
  Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
};

// the mean length of the edges near a point
double mean_length_near(const Point_3& p, const Mesh& mesh)
{
  double sum = 0, number = 0;
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Point_3 &a = mesh.point(mesh.vertex(e, 0)), &b = mesh.point(mesh.vertex(e, 1));
    if (CGAL::squared_distance(CGAL::midpoint(a, b), p) < 0.04)
      sum += std::sqrt(CGAL::squared_distance(a, b)), ++number;
  }
  return sum / number;
}

int main()
{
  const Point_3 north(0, 0, 1), south(0, 0, -1);
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1);

  // fine near the north pole, and coarser by a tenth of the way from there
  const auto size = [&](const Point_3& p) { return 0.03 + std::sqrt(CGAL::squared_distance(p, north)) / 10; };
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere(), params::sizing_field(size));
  std::cout << mesh.number_of_faces() << " faces, edges of " << mean_length_near(north, mesh) << " in the north and "
            << mean_length_near(south, mesh) << " in the south" << std::endl;

  // The sizes of the vertices jump from 0.2 to 0.05 in the south. The gradation makes them grow gradually from there.
  auto sizes = mesh.add_property_map<Mesh::Vertex_index, double>("v:size", 0.2).first;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.point(v).z() < -0.9)
      sizes[v] = 0.05;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere(), params::sizing_field(sizes).gradation(0.2));
  std::cout << mesh.number_of_faces() << " faces, edges of " << mean_length_near(north, mesh) << " in the north and "
            << mean_length_near(south, mesh) << " in the south" << std::endl;
  return 0;
}
