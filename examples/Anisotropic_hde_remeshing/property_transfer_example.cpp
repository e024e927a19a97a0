// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Brings along what the vertices and the faces of the input carry, here a temperature and a material.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <CGAL/Anisotropic_hde_remeshing/transfer_face_property.h>
#include <CGAL/Anisotropic_hde_remeshing/transfer_vertex_property.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

namespace Hde = CGAL::Anisotropic_hde_remeshing;
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
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  auto temperature = mesh.add_property_map<Mesh::Vertex_index, double>("v:temperature", 0).first;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
    temperature[v] = 20 + 5 * mesh.point(v).z();
  }

  auto material = mesh.add_property_map<Mesh::Face_index, std::string>("f:material").first;
  for (const Mesh::Face_index f : mesh.faces())
    material[f] = mesh.point(mesh.target(mesh.halfedge(f))).z() > 0 ? "iron" : "tin";

  // a copy is remeshed, and told for each new vertex where on the input it lies
  Mesh output = mesh;
  auto location = output.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
  CGAL::anisotropic_hde_remeshing(output, Sphere(), params::number_of_target_faces(1500).vertex_location_map(location));

  auto output_temperature = output.add_property_map<Mesh::Vertex_index, double>("v:new_temperature", 0).first;
  Hde::transfer_vertex_property(mesh, temperature, output, location, output_temperature);
  auto output_material = output.add_property_map<Mesh::Face_index, std::string>("f:new_material").first;
  Hde::transfer_face_property(mesh, material, output, output_material);

  double largest = 0;
  for (const Mesh::Vertex_index v : output.vertices())
    largest = (std::max)(largest, std::abs(output_temperature[v] - (20 + 5 * output.point(v).z())));
  std::size_t number_of_iron = 0;
  for (const Mesh::Face_index f : output.faces())
    number_of_iron += output_material[f] == "iron" ? 1 : 0;
  std::cout << output.number_of_vertices() << " vertices; their temperatures are off by " << largest << " at most; "
            << number_of_iron << " of " << output.number_of_faces() << " faces are of iron" << std::endl;
  return largest < 0.05 ? 0 : 1;
}
