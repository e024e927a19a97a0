// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Meshes the surface through points with normals by CGAL's make_surface_mesh(), which takes the function as it is. Where points
// are missing, the surface is closed.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <CGAL/Rbf_implicit_function.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Point_set_3<Kernel::Point_3> Point_set;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

// The function, which may be evaluated only so many times. CGAL's mesher asks for ever where the zero set is rough, as of noise
// and outliers.
class Limited_function
{
public:
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point;

  Limited_function(const Function& function, const std::size_t number)
    : m_function(function), m_number(std::make_shared<std::size_t>(number))
  {
  }

  FT operator()(const Point& p) const
  {
    if ((*m_number)-- == 0)
      throw std::runtime_error(
          "The surface is too rough to be meshed: are there outliers, or is there noise? See detect_outliers and smoothing.");
    return m_function(p);
  }

private:
  Function m_function;
  std::shared_ptr<std::size_t> m_number; // that is left
};

typedef CGAL::Surface_mesh_default_triangulation_3 Triangulation;
typedef CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation> Complex;
typedef CGAL::Surface_mesh_default_criteria_3<Triangulation> Criteria;
typedef CGAL::Implicit_surface_3<Kernel, Limited_function> Surface;

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
  const double facet_size = 0.04 * radius, facet_distance = 0.002 * radius, bisection_error = 1e-5;
  Triangulation triangulation;
  Complex complex(triangulation);
  try
  {
    CGAL::make_surface_mesh(complex, Surface(Limited_function(f, 3000000), f.bounding_sphere(), bisection_error),
                            Criteria(25, facet_size, facet_distance), CGAL::Manifold_tag());
  }
  catch (const std::runtime_error& error)
  {
    return std::cerr << error.what() << std::endl, EXIT_FAILURE;
  }
  Mesh mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  if (!CGAL::IO::write_polygon_mesh("surface_of_points.off", mesh, CGAL::parameters::stream_precision(17)))
    return std::cerr << "Cannot write surface_of_points.off" << std::endl, EXIT_FAILURE;

  // one closed surface, through the points and nowhere far from them?
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t number_of_components = PMP::connected_components(mesh, component);
  const double from_points = PMP::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(points.points(), mesh);
  const double to_points = PMP::approximate_max_distance_to_point_set(mesh, points.points(), 0.01 * radius);
  const std::size_t number_of_holes = f.diagnostics().number_of_holes;
  std::cout << points.size() << " points, " << mesh.number_of_faces() << " triangles in " << number_of_components
            << (CGAL::is_closed(mesh) ? " closed" : " open") << " component(s), written to surface_of_points.off. "
            << number_of_holes << " hole(s) are closed.\n"
            << "In radii of the bounding sphere: the farthest point is " << from_points / radius
            << " away from the surface, the surface at most " << to_points / radius << " from the points." << std::endl;
  const bool is_good = CGAL::is_closed(mesh) && number_of_components == 1 && from_points < 5 * facet_distance &&
                       (number_of_holes > 0 || to_points < 0.1 * radius);
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
