// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Fewer triangles for real meshes, beside CGAL's edge collapse:
//
//   benchmark_real_meshes MESH...
//
// remeshes each to a quarter, a tenth and a twenty-fifth of its vertices, 500 at least: without an option; with fit_to_surface, for
// the least distance; and uniform in the embedding with sigma at 0.02 of the diagonal. CGAL's edge collapse by Lindstrom and Turk,
// with a bounded change of normals, goes to the same number of vertices as the first. "rms" and "max" are the distances between the
// result and MESH, the larger ones of both ways, over the diagonal; "normals" is the root mean square over the result of the angle
// between its faces and the nearest faces of MESH, in degrees; "aspect" are the mean and the 99th percentile of the aspect ratios;
// "folds" and "intersections" are edges and pairs of faces, MESH and result. Geometric means over those of Lindstrom and Turk, and
// the worst ones, come last.

#include "mesh_quality.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iomanip>
#include <iostream>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

struct Figures
{
  double rms, max, normals, seconds;
};

struct At_number_of_vertices
{
  std::size_t n;
  template <typename FT, typename Profile>
  bool operator()(const FT&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_vertices() <= n;
  }
};

void collapse(Mesh& mesh, const std::size_t number_of_vertices)
{
  SMS::edge_collapse(mesh, At_number_of_vertices{number_of_vertices},
                     CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                         .get_placement(SMS::LindstromTurk_placement<Mesh>())
                         .filter(SMS::Bounded_normal_change_filter<>()));
}

template <typename Remesh>
Figures run(const std::string& name, const Mesh& input, Mesh& mesh, const Remesh& remesh)
{
  Figures figures;
  mesh = input;
  figures.seconds = seconds_of([&] { remesh(mesh); });
  mesh.collect_garbage();
  const double diagonal = bounding_box_diagonal(input);
  const Hde::Distance_measures distance = Hde::measure_distance<Tag>(mesh, input);
  const Hde::Shape_measures shape = Hde::measure_shape(mesh);
  figures.rms = distance.rms() / diagonal;
  figures.max = distance.max() / diagonal;
  figures.normals = normal_deviation_from(input, mesh);
  std::cout << "  " << std::left << std::setw(16) << name << std::right << mesh.number_of_vertices() << " vertices  rms "
            << std::scientific << std::setprecision(2) << figures.rms << "  max " << figures.max << std::fixed << "  normals "
            << figures.normals << "  aspect " << shape.aspect_ratio_mean << " " << shape.aspect_ratio_p99 << "  folds "
            << Hde::measure_shape(input).number_of_folded_edges << " " << shape.number_of_folded_edges << "  intersections "
            << number_of_self_intersections(input) << " " << number_of_self_intersections(mesh) << "  " << figures.seconds
            << " s" << std::endl;
  return figures;
}

typedef std::map<std::string, std::vector<Figures>> Ratios; // by setting

void run_all(const Mesh& input, const std::size_t number_of_vertices, Ratios& ratios)
{
  const std::size_t number_of_faces =
      input.number_of_faces() * number_of_vertices / (std::max)(input.number_of_vertices(), Mesh::size_type(1));
  const double diagonal = bounding_box_diagonal(input);
  Mesh mesh;
  std::map<std::string, Figures> figures;
  figures["no option"] =
      run("no option", input, mesh,
          [&](Mesh& m) { CGAL::anisotropic_hde_remeshing<Tag>(m, params::number_of_target_faces(number_of_faces)); });
  const std::size_t n = mesh.number_of_vertices();
  figures["least distance"] =
      run("least distance", input, mesh,
          [&](Mesh& m)
          {
            CGAL::anisotropic_hde_remeshing<Tag>(m, params::number_of_target_faces(number_of_faces)
                                                        .remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR)
                                                        .fit_to_surface(true));
          });
  figures["sigma .02"] =
      run("sigma .02", input, mesh,
          [&](Mesh& m)
          { CGAL::anisotropic_hde_remeshing<Tag>(m, params::number_of_target_faces(number_of_faces).sigma(.02 * diagonal)); });
  const Figures other = run("Lindstrom-Turk", input, mesh, [&](Mesh& m) { collapse(m, n); });
  if (!(other.rms > 1e-9)) // it is exact: there is no ratio
    return;
  for (const auto& f : figures)
    ratios[f.first].push_back(Figures{f.second.rms / other.rms, f.second.max / other.max, f.second.normals / other.normals,
                                      f.second.seconds / other.seconds});
}

// how many faces Garland and Heckbert's planes need for the same largest distance, by bisection of their number
std::size_t number_of_collapsed_faces(const Mesh& input, const double largest_distance)
{
  typedef SMS::GarlandHeckbert_plane_policies<Mesh, Mesh::Point::R> Policies;
  double too_few = std::log(50.), enough = std::log(double(input.number_of_vertices()));
  std::size_t result = input.number_of_faces();
  for (int step = 0; step < 7; ++step)
  {
    Mesh mesh = input;
    const double middle = (too_few + enough) / 2;
    const Policies policies(mesh);
    SMS::edge_collapse(mesh, At_number_of_vertices{std::size_t(std::exp(middle))},
                       CGAL::parameters::get_cost(policies.get_cost())
                           .get_placement(policies.get_placement())
                           .filter(SMS::Bounded_normal_change_filter<>()));
    mesh.collect_garbage();
    const bool is_near = Hde::measure_distance<Tag>(mesh, input).max() <= largest_distance;
    (is_near ? enough : too_few) = middle;
    if (is_near)
      result = (std::min)(result, std::size_t(mesh.number_of_faces()));
  }
  return result;
}

// Errors that are asked for: whether they are kept, and for how many faces. Returns the logarithms of the ratios of the numbers.
std::vector<double> run_errors(const Mesh& input)
{
  std::vector<double> ratios;
  const double diagonal = bounding_box_diagonal(input);
  for (const double error : {3e-3, 1e-3, 3e-4})
  {
    Mesh mesh = input;
    Hde::Remeshing_result result;
    const double seconds =
        seconds_of([&] { result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::relative_approximation_error(error)); });
    mesh.collect_garbage();
    const double distance = Hde::measure_distance<Tag>(mesh, input).max() / diagonal;
    const std::size_t collapsed = number_of_collapsed_faces(input, error * diagonal);
    const Hde::Shape_measures shape = Hde::measure_shape(mesh);
    std::cout << "  error " << std::scientific << std::setprecision(2) << error << "  bound "
              << result.approximation_error / diagonal << "  measured " << distance
              << (result.approximation_error <= error * diagonal * (1 + 1e-12) ? "  kept" : "  NOT KEPT") << std::fixed << "  "
              << mesh.number_of_faces() << " faces, Garland-Heckbert " << collapsed << "  aspect " << shape.aspect_ratio_mean
              << " " << shape.aspect_ratio_p99 << "  intersections " << number_of_self_intersections(input) << " "
              << number_of_self_intersections(mesh) << "  " << seconds << " s" << std::endl;
    ratios.push_back(std::log(double(mesh.number_of_faces()) / double(collapsed)));
  }
  return ratios;
}

void print_mean_and_worst(const char* name, const std::vector<Figures>& ratios, double Figures::*figure)
{
  double sum = 0, worst = 0;
  for (const Figures& f : ratios)
  {
    sum += std::log(f.*figure);
    worst = (std::max)(worst, f.*figure);
  }
  std::cout << "  " << name << " " << std::exp(sum / double(ratios.size())) << " (" << worst << ")";
}

int main(int argc, char** argv)
{
  try
  {
    const bool asks_for_errors = argc > 1 && argv[1] == std::string("--errors");
    if (argc < 2 + asks_for_errors)
      throw std::invalid_argument("benchmark_real_meshes [--errors] MESH...");
    Ratios ratios;
    std::vector<double> ratios_of_faces;
    for (int i = 1 + asks_for_errors; i < argc; ++i)
    {
      Mesh input;
      if (!PMP::IO::read_polygon_mesh(argv[i], input))
        throw std::invalid_argument(std::string("cannot read ") + argv[i]);
      PMP::remove_isolated_vertices(input);
      input.collect_garbage();
      std::cout << argv[i] << ", " << input.number_of_vertices() << " vertices" << std::endl;
      if (asks_for_errors)
      {
        const std::vector<double> logarithms = run_errors(input);
        ratios_of_faces.insert(ratios_of_faces.end(), logarithms.begin(), logarithms.end());
        continue;
      }
      std::size_t last = 0;
      for (const std::size_t part : {4, 10, 25})
      {
        const std::size_t n = (std::max)(std::size_t(input.number_of_vertices()) / part, std::size_t(500));
        if (n != last && 2 * n <= input.number_of_vertices())
          run_all(input, n, ratios);
        last = n;
      }
    }
    if (asks_for_errors)
    {
      std::cout << "faces over Garland-Heckbert, geometric mean: " << std::setprecision(3)
                << std::exp(std::accumulate(ratios_of_faces.begin(), ratios_of_faces.end(), 0.) /
                            double(ratios_of_faces.size()))
                << std::endl;
      return 0;
    }
    std::cout << "over Lindstrom-Turk: geometric mean (largest)" << std::fixed << std::setprecision(2) << std::endl;
    for (const auto& r : ratios)
    {
      std::cout << std::left << std::setw(16) << r.first;
      print_mean_and_worst("rms", r.second, &Figures::rms);
      print_mean_and_worst("max", r.second, &Figures::max);
      print_mean_and_worst("normals", r.second, &Figures::normals);
      print_mean_and_worst("time", r.second, &Figures::seconds);
      std::cout << std::endl;
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}
