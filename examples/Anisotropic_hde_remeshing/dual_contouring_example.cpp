// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Meshes the surface through points with normals by CGAL's dual contouring, which puts its vertices by means of the
// gradient. Needs CGAL 6.2.

#include <CGAL/Isosurfacing_3/Cartesian_grid_3.h>
#include <CGAL/Isosurfacing_3/Dual_contouring_domain_3.h>
#include <CGAL/Isosurfacing_3/Gradient_function_3.h>
#include <CGAL/Isosurfacing_3/Value_function_3.h>
#include <CGAL/Isosurfacing_3/dual_contouring_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Rbf_implicit_function.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Point_set_3<Point> Point_set;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

typedef CGAL::Isosurfacing::Cartesian_grid_3<Kernel> Grid;
typedef CGAL::Isosurfacing::Value_function_3<Grid> Values;
typedef CGAL::Isosurfacing::Gradient_function_3<Grid> Gradients;
typedef CGAL::Isosurfacing::Dual_contouring_domain_3<Grid, Values, Gradients> Domain;

namespace parameters = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  Point_set points;
  if (!CGAL::IO::read_point_set(input, points) || !points.has_normal_map())
    return std::cerr << "Cannot read points with normals from " << input << std::endl, EXIT_FAILURE;

  const Function f(points, points.parameters());
  const double radius = std::sqrt(f.bounding_sphere().squared_radius());
  // the domain asks for gradients of length 1
  const auto normal = [&f](const Point& p)
  {
    const Vector gradient = f.gradient(p);
    return gradient / std::sqrt(gradient.squared_length());
  };

  const std::size_t n = 50;
  const double cell_size = 2 * radius / double(n - 1);
  const Grid grid(Kernel::Iso_cuboid_3(f.bounding_sphere().bbox()), std::array<std::size_t, 3>{n, n, n});
  const Values values(f, grid);
  const Gradients gradients(normal, grid);
  std::vector<Point> vertices;
  std::vector<std::vector<std::size_t>> triangles;
  CGAL::Isosurfacing::dual_contouring<CGAL::Parallel_if_available_tag>(Domain(grid, values, gradients), 0, vertices, triangles,
                                                                       parameters::constrain_to_cell(true));
  // four triangles may meet in an edge: they are taken apart, and stitched in pairs
  Mesh mesh;
  PMP::orient_polygon_soup(vertices, triangles);
  PMP::polygon_soup_to_polygon_mesh(vertices, triangles, mesh);
  PMP::stitch_borders(mesh);
  if (!CGAL::IO::write_polygon_mesh("dual_contouring.off", mesh, parameters::stream_precision(17)))
    return std::cerr << "Cannot write dual_contouring.off" << std::endl, EXIT_FAILURE;

  // one closed surface, through the points and nowhere far from them?
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t number_of_components = PMP::connected_components(mesh, component);
  const double from_points = PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(points.points(), mesh);
  const double to_points = PMP::approximate_max_distance_to_point_set(mesh, points.points(), 0.01 * radius);
  std::cout << points.size() << " points, " << mesh.number_of_faces() << " triangles in " << number_of_components
            << (CGAL::is_closed(mesh) ? " closed" : " open") << " component(s), written to dual_contouring.off.\n"
            << "In radii of the bounding sphere: the farthest point is " << from_points / radius
            << " away from the surface, the surface at most " << to_points / radius << " from the points." << std::endl;
  const bool is_good =
      CGAL::is_closed(mesh) && number_of_components == 1 && from_points < cell_size && to_points < 0.1 * radius;
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
