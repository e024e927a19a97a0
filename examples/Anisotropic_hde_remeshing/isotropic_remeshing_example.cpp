// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The same task for CGAL's isotropic_remeshing and for this package: a cube whose sharp edges are constrained.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <iostream>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

Mesh cube()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), Point_3(0, 1, 1),
                        Point_3(0, 0, 1), Point_3(1, 0, 1), Point_3(1, 1, 1), mesh);
  PMP::triangulate_faces(mesh);
  return mesh;
}

int main()
{
  Mesh isotropic = cube(), anisotropic = cube();
  auto constrained = isotropic.add_property_map<Mesh::Edge_index, bool>("e:constrained", false).first;
  PMP::detect_sharp_edges(isotropic, 60, constrained);
  PMP::isotropic_remeshing(faces(isotropic), 0.1, isotropic,
                           CGAL::parameters::edge_is_constrained_map(constrained).number_of_iterations(5));

  constrained = anisotropic.add_property_map<Mesh::Edge_index, bool>("e:constrained", false).first;
  PMP::detect_sharp_edges(anisotropic, 60, constrained);
  CGAL::anisotropic_hde_remeshing(
      anisotropic, params::edge_is_constrained_map(constrained).number_of_iterations(5).sigma(0).target_edge_length(0.1));

  for (Mesh* mesh : {&isotropic, &anisotropic})
  {
    mesh->collect_garbage(); // the elements that were replaced
    std::cout << mesh->number_of_faces() << " faces, area " << PMP::area(*mesh) << ", volume " << PMP::volume(*mesh)
              << std::endl;
  }
  return std::abs(PMP::volume(anisotropic) - 1) < 1e-6 ? 0 : 1;
}
