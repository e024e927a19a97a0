// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Builds the smooth function with three kernels, and tells how far a sphere of 5,120 triangles then is from the round one.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Rbf_implicit_function.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

Mesh round_mesh()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
  }
  return mesh;
}

// The template argument is the kernel's type, the parameter radial_function its object, with a width of its own perhaps.
template <typename RadialFunction>
void tell(const Mesh& mesh, const RadialFunction& kernel)
{
  const CGAL::Rbf_implicit_function<Kernel, RadialFunction, CGAL::Parallel_if_available_tag> f(mesh,
                                                                                               params::radial_function(kernel));
  double largest = 0; // between the vertices: at the middles of the edges, on the round sphere
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Kernel::Vector_3 middle = CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))) - CGAL::ORIGIN;
    largest = (std::max)(largest, std::abs(f(CGAL::ORIGIN + middle / std::sqrt(middle.squared_length()))));
  }
  std::cout << RadialFunction::name() << ": at most " << largest << " off, " << f.diagnostics().number_of_patches
            << " patches, " << f.diagnostics().patches_on_fallback << " of them answered by the mesh itself\n";
}

int main()
{
  const Mesh mesh = round_mesh();
  tell(mesh, CGAL::Polyharmonic_rbf());  // the default: good for scans, too
  tell(mesh, CGAL::Thin_plate_rbf());    // the paper's
  tell(mesh, CGAL::Wendland_C4_rbf(12)); // of compact support, here of 12 local distances between points
  return 0;
}
