// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes the surface of a mesh file with 20,000 triangles that follow its curvature.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bunny00.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh))
  {
    std::cerr << "Cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  const auto parameters = params::number_of_target_faces(20000);
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, parameters);

  if (!CGAL::IO::write_polygon_mesh("remeshed.off", mesh, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << "Cannot write remeshed.off" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << mesh.number_of_faces() << " faces, written to remeshed.off" << std::endl;
  return EXIT_SUCCESS;
}
