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
// number or inf, the metric of the curvature; an f behind fits the vertices to the surface in the end; `smooth` and a fraction is
// one smooth function in place of one a region. Distances are over D; normals, in degrees, are the root mean square over the
// result of the angle between its faces and the nearest faces of MESH. "creases" are the largest distance of the crease edges of
// the result from those of MESH, and the reverse.

#include "creases.h"
#include "mesh_quality.h"
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

#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Crease_map;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Region_map;

template <typename Function>
Hde::Remeshing_result remesh(Mesh& mesh, const Function& function, const Crease_map creases, const Region_map regions,
                             const std::size_t faces, std::string sigma)
{
  const bool is_fitted = sigma.back() == 'f' && sigma != "pinf";
  const auto run = [&](const auto& embedding)
  {
    return CGAL::anisotropic_hde_remeshing<Tag>(mesh, function,
                                                params::embedding(embedding)
                                                    .face_patch_map(regions)
                                                    .edge_is_constrained_map(creases)
                                                    .number_of_target_faces(faces)
                                                    .fit_to_surface(is_fitted));
  };
  if (sigma[0] == 'p')
    return run(Hde::Curvature_metric(std::stod(sigma.substr(1))));
  return run(Hde::Normal_embedding(std::stod(sigma) * bounding_box_diagonal(mesh)));
}

// a remeshed input, and what there is to tell of it
struct Run
{
  Mesh mesh;
  Hde::Remeshing_result result;
  double zero_set = 0, seconds = 0;
  // none of one smooth function
  creases::Segments creases_before, creases_after;
  std::vector<Point_3> corners;
};

Run run_with_one_function(const Mesh& input, const std::size_t faces, const double relative_sigma)
{
  Run run;
  run.mesh = input;
  run.seconds = seconds_of(
      [&]
      {
        const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(run.mesh);
        run.result = CGAL::anisotropic_hde_remeshing<Tag>(run.mesh, function,
                                                          params::relative_sigma(relative_sigma).number_of_target_faces(faces));
        run.zero_set = Hde::measure_distance_to_zero_set<Tag>(run.mesh, function).face_rms;
      });
  return run;
}

Run run_with_regions(const Mesh& input, const double angle, const std::size_t faces, const std::string& sigma)
{
  Run run;
  run.mesh = input;
  const Crease_map creases = run.mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
  const Region_map regions = run.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  run.seconds = seconds_of([&] { Hde::detect_surface_regions(run.mesh, creases, regions, params::sharp_angle(angle)); });
  run.creases_before = creases::segments(run.mesh, creases);
  run.corners = creases::corners(run.mesh, creases);
  run.seconds += seconds_of(
      [&]
      {
        const CGAL::Piecewise_rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(run.mesh, regions);
        run.result = remesh(run.mesh, function, creases, regions, faces, sigma);
        run.zero_set = Hde::measure_distance_to_zero_set<Tag>(run.mesh, function, params::face_patch_map(regions)).face_rms;
      });
  run.creases_after = creases::segments(run.mesh, creases);
  run.mesh.collect_garbage();
  return run;
}

void print(const std::string& name, const Mesh& input, const Run& run)
{
  const double diagonal = bounding_box_diagonal(input);
  const Hde::Distance_measures distance = Hde::measure_distance<Tag>(run.mesh, input);
  std::cout << std::setw(12) << name << std::setw(8) << run.mesh.number_of_vertices() << " v  rms " << std::scientific
            << std::setprecision(2) << distance.rms() / diagonal << "  max " << distance.max() / diagonal << "  zero set "
            << run.zero_set / diagonal << "  normals " << std::fixed << normal_deviation_from(input, run.mesh) << "  regions "
            << run.result.number_of_regions << "  curves " << run.result.curves_before.number_of_curves;
  if (!run.creases_before.empty())
    std::cout << "  length " << run.result.curves_after.length / run.result.curves_before.length << "  corners "
              << run.corners.size() << ", lost " << creases::number_of_missing_points(run.corners, run.mesh) << "  creases "
              << std::scientific << creases::largest_distance(run.creases_after, run.creases_before) / diagonal << " "
              << creases::largest_distance(run.creases_before, run.creases_after) / diagonal << std::fixed;
  std::cout << "  folds " << Hde::measure_shape(input).number_of_folded_edges << " "
            << Hde::measure_shape(run.mesh).number_of_folded_edges << "  intersections " << number_of_self_intersections(input)
            << " " << number_of_self_intersections(run.mesh) << "  " << run.seconds << " s" << std::endl;
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
    const std::string smooth = "smooth";
    for (int i = 4; i < argc; ++i)
    {
      const std::string name = argv[i];
      const bool is_smooth = name.compare(0, smooth.size(), smooth) == 0;
      print(name, input,
            is_smooth ? run_with_one_function(input, std::size_t(faces), std::stod(name.substr(smooth.size())))
                      : run_with_regions(input, std::stod(argv[2]), std::size_t(faces), name));
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}
