// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Fills the surface through points with normals with tetrahedra by CGAL's make_mesh_3(), which takes the function as it is.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <CGAL/Rbf_implicit_function.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> Complex;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;

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

  // lengths in fractions of the radius; angles in degrees
  const double size = 0.06 * radius, facet_distance = 0.003 * radius, bisection_error = 1e-5;
  const Domain domain =
      Domain::create_implicit_mesh_domain(f, f.bounding_sphere(), parameters::relative_error_bound = bisection_error);
  const Criteria criteria(parameters::facet_angle = 25, parameters::facet_size = size,
                          parameters::facet_distance = facet_distance, parameters::cell_radius_edge_ratio = 2,
                          parameters::cell_size = size);
  const Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::manifold());
  std::ofstream out("tetrahedra_of_points.mesh");
  complex.output_to_medit(out);
  if (!out)
    return std::cerr << "Cannot write tetrahedra_of_points.mesh" << std::endl, EXIT_FAILURE;

  // one closed surface around the tetrahedra, through the points and nowhere far from them?
  Mesh mesh;
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t number_of_components = PMP::connected_components(mesh, component);
  const double from_points = PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(points.points(), mesh);
  const double to_points = PMP::approximate_max_distance_to_point_set(mesh, points.points(), 0.01 * radius);
  std::cout << points.size() << " points, " << complex.number_of_cells_in_complex() << " tetrahedra inside "
            << mesh.number_of_faces() << " triangles in " << number_of_components
            << (CGAL::is_closed(mesh) ? " closed" : " open") << " component(s), written to tetrahedra_of_points.mesh.\n"
            << "In radii of the bounding sphere: the farthest point is " << from_points / radius
            << " away from the surface, the surface at most " << to_points / radius << " from the points." << std::endl;
  const bool is_good =
      CGAL::is_closed(mesh) && number_of_components == 1 && from_points < 5 * facet_distance && to_points < 0.1 * radius;
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
