// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes a part of a machine, whose edges stay sharp, with 8,000 triangles.

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
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(input, mesh))
  {
    std::cerr << "Cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // edges are sharp where the normals of their faces differ by 40 degrees or more
  const auto parameters = params::sharp_angle(40).number_of_target_faces(8000);
  const auto result = CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, parameters);

  std::cout << result.number_of_regions << " smooth regions, " << result.curves_after.number_of_curves << " curves between "
            << result.curves_after.number_of_corners << " corners, " << result.curves_after.length << " long (they were "
            << result.curves_before.length << "); " << mesh.number_of_faces() << " faces, written to sharp.off" << std::endl;
  return CGAL::IO::write_polygon_mesh("sharp.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
