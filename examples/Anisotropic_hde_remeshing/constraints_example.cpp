// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Keeps a boundary, a closed curve of edges and a vertex: a dome whose rim is a boundary, with a circle of latitude marked.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <iostream>

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

constexpr int rings = 6, sides = 24;

// the pole, then rings of vertices down to the rim
Mesh dome()
{
  Mesh mesh;
  mesh.add_vertex(Kernel::Point_3(0, 0, 1));
  for (int i = 1; i <= rings; ++i)
    for (int k = 0; k < sides; ++k)
    {
      const double polar = 1.2 * i / rings, azimuth = 2 * CGAL_PI * k / sides;
      mesh.add_vertex(
          Kernel::Point_3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)));
    }
  const auto vertex = [](const int i, const int k) { return Mesh::Vertex_index(1 + (i - 1) * sides + k % sides); };
  for (int k = 0; k < sides; ++k)
  {
    mesh.add_face(Mesh::Vertex_index(0), vertex(1, k), vertex(1, k + 1));
    for (int i = 1; i < rings; ++i)
    {
      mesh.add_face(vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1));
      mesh.add_face(vertex(i, k), vertex(i + 1, k + 1), vertex(i, k + 1));
    }
  }
  return mesh;
}

int main()
{
  Mesh mesh = dome();

  // the edges of the third ring are a curve, and stay one
  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const auto ring = [&](const int end) { return (int(mesh.vertex(e, end)) + sides - 1) / sides; };
    is_constrained[e] = ring(0) == 3 && ring(1) == 3;
  }
  auto is_fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed", false).first;
  is_fixed[Mesh::Vertex_index(0)] = true; // the pole

  CGAL::anisotropic_hde_remeshing(
      mesh, Sphere(),
      params::number_of_target_faces(3000).edge_is_constrained_map(is_constrained).vertex_is_constrained_map(is_fixed));

  // the map holds for the new edges
  double length = 0;
  std::size_t number = 0;
  for (const Mesh::Edge_index e : mesh.edges())
    if (is_constrained[e])
    {
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
      ++number;
    }
  std::cout << mesh.number_of_faces() << " faces; the curve has " << number << " edges of the length " << length
            << " together; the pole is at " << mesh.point(Mesh::Vertex_index(0)) << "; written to dome.off" << std::endl;
  return CGAL::IO::write_polygon_mesh("dome.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
