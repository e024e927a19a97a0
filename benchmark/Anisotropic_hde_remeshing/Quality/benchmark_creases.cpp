// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How well sharp edges are kept:
//
//   benchmark_creases MESH ANGLE COUNT SIGMA...
//
// COUNT is a number of vertices, or, with a % behind, a share of those of MESH; SIGMA a fraction of the diagonal D, or p and a
// number or inf, the metric of the curvature, or `smooth` and one of these for one smooth function in place of one a region;
// an f behind fits the vertices to the surface in the end. Distances are over D; normals, in degrees, are the root mean square over
// the result of the angle between its faces and the nearest faces of MESH. "creases" are the largest distance of the crease edges
// of the result from those of MESH, and the reverse.

#include "creases.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/Piecewise_rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Parallel_if_available_tag Tag;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Crease_map;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Region_map;

std::size_t number_of_self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections<Tag>(mesh, std::back_inserter(pairs));
  return pairs.size();
}

// in degrees
double normal_deviation_from(const Mesh& input, const Mesh& mesh)
{
  using namespace Hde::internal;
  const Measured_mesh reference = read_measured_mesh(input, CGAL::parameters::default_values()),
                      result = read_measured_mesh(mesh, CGAL::parameters::default_values());
  const Closest_facet closest(reference.points, reference.faces);
  const Area_sampler sampler(result, 200000);
  const auto angle = [&](const std::size_t i)
  {
    const Vector n = result.normal(sampler.face(i)).stableNormalized(),
                 m = reference.normal(closest(sampler(i)).facet).stableNormalized();
    return std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / pi;
  };
  return rms_and_max<Tag>(sampler.size(), angle).rms;
}

template <typename Function>
Hde::Remeshing_result remesh(Mesh& mesh, const Function& function, const Crease_map creases, const Region_map regions,
                             const std::size_t faces, std::string sigma)
{
  const bool is_fitted = sigma.back() == 'f' && sigma != "pinf";
  const auto run = [&](const auto& embedding)
  {
    return CGAL::anisotropic_hde_remeshing<Tag>(mesh, function,
                                                CGAL::parameters::embedding(embedding)
                                                    .face_patch_map(regions)
                                                    .edge_is_constrained_map(creases)
                                                    .number_of_target_faces(faces)
                                                    .fit_to_surface(is_fitted));
  };
  if (sigma[0] == 'p')
    return run(Hde::Curvature_metric(std::stod(sigma.substr(1))));
  return run(Hde::Normal_embedding(std::stod(sigma) * bounding_box_diagonal(mesh)));
}

void run(const Mesh& input, const double angle, const std::size_t faces, const std::string& name)
{
  Mesh mesh = input;
  const Crease_map creases = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
  const Region_map regions = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  Hde::Remeshing_result result;
  double seconds = 0, zero_set = 0;
  creases::Segments before;
  std::vector<Point_3> corners;
  if (name.substr(0, 6) == "smooth")
  {
    // the creases are looked for to compare with them only
    Hde::detect_surface_regions(mesh, creases, regions, CGAL::parameters::sharp_angle(angle));
    before = creases::segments(mesh, creases);
    corners = creases::corners(mesh, creases);
    mesh = input;
    seconds = seconds_of(
        [&]
        {
          const CGAL::Rbf_implicit_function<Kernel> function(mesh);
          const double sigma = std::stod(name.substr(6)) * bounding_box_diagonal(mesh);
          result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function,
                                                        CGAL::parameters::sigma(sigma).number_of_target_faces(faces));
          zero_set = Hde::measure_distance_to_zero_set<Tag>(mesh, function).face_rms;
        });
  }
  else
  {
    seconds = seconds_of([&] { Hde::detect_surface_regions(mesh, creases, regions, CGAL::parameters::sharp_angle(angle)); });
    before = creases::segments(mesh, creases);
    corners = creases::corners(mesh, creases);
    seconds += seconds_of(
        [&]
        {
          const CGAL::Piecewise_rbf_implicit_function<Kernel> function(mesh, regions);
          result = remesh(mesh, function, creases, regions, faces, name);
          zero_set = Hde::measure_distance_to_zero_set<Tag>(mesh, function, CGAL::parameters::face_patch_map(regions)).face_rms;
        });
    mesh.collect_garbage();
  }
  const double diagonal = bounding_box_diagonal(input);
  const Hde::Distance_measures distance = Hde::measure_distance<Tag>(mesh, input);
  std::cout << std::setw(12) << name << std::setw(8) << mesh.number_of_vertices() << " v  rms " << std::scientific
            << std::setprecision(2) << distance.rms() / diagonal << "  max " << distance.max() / diagonal << "  zero set "
            << zero_set / diagonal << "  normals " << std::fixed << normal_deviation_from(input, mesh) << "  regions "
            << result.number_of_regions << "  curves " << result.curves_before.number_of_curves << "  length "
            << result.curves_after.length / result.curves_before.length;
  if (name.substr(0, 6) != "smooth")
  {
    const auto after = creases::segments(mesh, creases);
    std::cout << "  corners " << corners.size() << ", lost " << creases::number_of_missing_points(corners, mesh) << "  creases "
              << std::scientific << creases::largest_distance(after, before) / diagonal << " "
              << creases::largest_distance(before, after) / diagonal << std::fixed;
  }
  std::cout << "  folds " << Hde::measure_shape(input).number_of_folded_edges << " "
            << Hde::measure_shape(mesh).number_of_folded_edges << "  intersections " << number_of_self_intersections(input)
            << " " << number_of_self_intersections(mesh) << "  " << seconds << " s" << std::endl;
}

int main(int argc, char** argv)
{
  try
  {
    if (argc < 5)
      throw std::invalid_argument("benchmark_creases MESH ANGLE COUNT SIGMA...");
    Mesh input;
    if (!PMP::IO::read_polygon_mesh(argv[1], input))
      throw std::invalid_argument(std::string("cannot read ") + argv[1]);
    const std::string count = argv[3];
    const double number = std::stod(count) * (count.back() == '%' ? 0.01 * double(input.number_of_vertices()) : 1.);
    const double faces = number / double(input.number_of_vertices()) * double(input.number_of_faces());
    std::cout << argv[1] << ", " << input.number_of_vertices() << " vertices, sharp " << argv[2] << std::endl;
    for (int i = 4; i < argc; ++i)
      run(input, std::stod(argv[2]), std::size_t(faces), argv[i]);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}
