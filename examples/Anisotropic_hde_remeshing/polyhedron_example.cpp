// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Any model of MutableFaceGraph is remeshed, here a CGAL::Polyhedron_3.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel> Polyhedron;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Polyhedron polyhedron;
  if (!CGAL::IO::read_polygon_mesh(input, polyhedron))
  {
    std::cerr << "Cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  CGAL::anisotropic_hde_remeshing(polyhedron, params::number_of_target_faces(4000).relative_sigma(0.03));

  std::cout << polyhedron.size_of_facets() << " facets, written to polyhedron.off" << std::endl;
  return CGAL::IO::write_polygon_mesh("polyhedron.off", polyhedron, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
