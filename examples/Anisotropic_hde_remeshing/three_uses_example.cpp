// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The three uses of the paper: to simplify a mesh, to improve it with as many triangles, and to fill it in.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh input;
  if (!CGAL::IO::read_polygon_mesh(name, input))
  {
    std::cerr << "Cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  // one function for all three: new vertices lie on it, not on the flat triangles of the input
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> function(input);

  for (const double share : {0.25, 1., 4.})
  {
    Mesh mesh = input;
    const auto number_of_faces = std::size_t(share * double(input.number_of_faces()));
    CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
        mesh, function, params::number_of_target_faces(number_of_faces).relative_sigma(0.02));

    const std::string output = "remeshed_" + std::to_string(mesh.number_of_faces()) + ".off";
    std::cout << input.number_of_faces() << " to " << mesh.number_of_faces() << " faces, largest aspect ratio "
              << CGAL::Anisotropic_hde_remeshing::measure_shape(mesh).aspect_ratio_max << ", written to " << output
              << std::endl;
    if (!CGAL::IO::write_polygon_mesh(output, mesh, CGAL::parameters::stream_precision(17)))
      return 1;
  }
  return 0;
}
