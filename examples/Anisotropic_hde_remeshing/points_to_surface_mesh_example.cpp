// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// From points with normals to a mesh that follows the curvature. The noise is found out, outliers are left out, and where points
// are missing, the surface is closed.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/rbf_surface_reconstruction.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace AHR = CGAL::Anisotropic_hde_remeshing;
namespace params = AHR::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  Point_set points;
  if (!CGAL::IO::read_point_set(input, points) || !points.has_normal_map())
    return std::cerr << "Cannot read points with normals from " << input << std::endl, EXIT_FAILURE;

  Mesh mesh;
  const AHR::Reconstruction_result result =
      CGAL::rbf_surface_reconstruction<CGAL::Parallel_if_available_tag>(points, mesh,
                                                                        params::begin_with(points.parameters())
                                                                            .smoothing(AHR::AUTOMATIC_SMOOTHING)
                                                                            .detect_outliers(true)
                                                                            .number_of_target_faces(points.size()));
  if (!CGAL::IO::write_polygon_mesh("surface_of_points.off", mesh, CGAL::parameters::stream_precision(17)))
    return std::cerr << "Cannot write surface_of_points.off" << std::endl, EXIT_FAILURE;
  std::cout << points.size() << " points, of which " << result.number_of_outliers << " are outliers, with noise of "
            << result.noise << ": " << result.number_of_faces << " triangles in " << result.number_of_components
            << " component(s), " << result.number_of_closed_holes << " hole(s) closed" << std::endl;

  // is it one closed surface, and through the points?
  const double distance = PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(points.points(), mesh);
  std::cout << "The farthest point is " << distance / result.spacing << " of the spacing away." << std::endl;
  return CGAL::is_closed(mesh) && result.number_of_components == 1 && distance < result.spacing ? EXIT_SUCCESS : EXIT_FAILURE;
}
