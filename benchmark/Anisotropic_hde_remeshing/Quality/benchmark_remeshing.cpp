// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes one mesh and prints what has come out, and how long it took:
//
//   benchmark_remeshing MESH FACES SIGMA [--iso] [--runs N]
//
// MESH       a file (OFF, OBJ, PLY, STL), remeshed through its RBF; or
//            `ellipsoid`: an icosphere of level 6 scaled by 1, 2 and 5, remeshed with its exact function and compared with the
//            exact surface; `coarse-ellipsoid`: of level 4, remeshed through its RBF and compared likewise;
//            `torus`: of radii 1 and 1/4, 65,536 vertices, with its exact function
// FACES      the number of faces wanted; with a percent sign, in percent of those of the input
// SIGMA      sigma as a fraction of the diagonal of the bounding box
// --iso      in turn with CGAL's isotropic_remeshing (10 iterations, the same number of faces); prints the ratio of times, and
//            the mean of the smallest angles in space of both
// --runs N   how often to run; times are medians (default: 1, with --iso 3)

#include "exact_surfaces.h"
#include "isotropic_remeshing.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Rbf_function;

struct Options
{
  std::string mesh;
  std::string faces;
  double sigma = 0; // over the diagonal
  bool with_isotropic_remeshing = false;
  int number_of_runs = 0;
};

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  std::vector<std::string> positional;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i] == "--iso")
      options.with_isotropic_remeshing = true;
    else if (arguments[i] == "--runs" && i + 1 < arguments.size())
      options.number_of_runs = std::stoi(arguments[++i]);
    else
      positional.push_back(arguments[i]);
  if (positional.size() != 3)
    throw std::invalid_argument(
        "usage: benchmark_remeshing MESH|ellipsoid|torus|coarse-ellipsoid FACES[%] SIGMA [--iso] [--runs N]");
  options.mesh = positional[0];
  options.faces = positional[1];
  options.sigma = std::stod(positional[2]);
  if (options.number_of_runs < 1)
    options.number_of_runs = options.with_isotropic_remeshing ? 3 : 1;
  return options;
}

std::size_t number_of_faces(const Options& options, const Mesh& input)
{
  const double number = std::stod(options.faces);
  return std::size_t(std::lround(options.faces.back() == '%' ? 0.01 * number * input.number_of_faces() : number));
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// --- The figures ---

void print_figures(const Mesh& input, const Mesh& mesh, const std::size_t wanted, const Hde::Remeshing_result& result)
{
  const Hde::Topology_measures before = Hde::measure_topology(input), after = Hde::measure_topology(mesh);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> intersections;
  PMP::self_intersections(mesh, std::back_inserter(intersections));
  std::cout << " faces=" << after.number_of_faces << " vertices=" << after.number_of_vertices
            << " count_error=" << 100 * (double(after.number_of_faces) / double(wanted) - 1) << "%"
            << " self_intersections=" << intersections.size() << " loops=" << before.number_of_boundary_loops << "->"
            << after.number_of_boundary_loops << " euler=" << before.euler_characteristic << "->" << after.euler_characteristic
            << " components=" << before.number_of_components << "->" << after.number_of_components
            << " valence_6=" << after.valence_6_share << " splits=" << result.number_of_splits
            << " collapses=" << result.number_of_collapses << " flips=" << result.number_of_flips
            << " projections=" << result.projections.newton << "/" << result.projections.bisection << "/"
            << result.projections.descent << "/" << result.projections.closest_point;
}

template <typename Function>
void print_figures_of_embedding(const Mesh& input, const Mesh& mesh, const Function& function,
                                const Hde::Remeshing_result& result)
{
  const double diagonal = bounding_box_diagonal(input);
  const Hde::Embedding_measures embedding =
      Hde::measure_embedding<Tag>(mesh, function, params::sigma(result.sigma).target_edge_length(result.target_edge_length));
  const Hde::Shape_measures shape = Hde::measure_shape(mesh);
  const Hde::Zero_set_measures distance = Hde::measure_distance_to_zero_set<Tag>(mesh, function);
  std::cout << " folds=" << embedding.number_of_folded_faces << " lengths[.7,1.41]=" << 100 * embedding.share_within_sqrt_2
            << "% lengths[.5,1.5]=" << 100 * embedding.share_within_half << "% mean_angle=" << embedding.minimum_angle_mean
            << " least_angle=" << embedding.minimum_angle_least << " q_mean=" << shape.aspect_ratio_mean
            << " q_p99=" << shape.aspect_ratio_p99 << " q_Gamma=" << shape.aspect_ratio_max
            << " vertex/D=" << distance.interior_vertex_max / diagonal
            << " boundary_vertex/D=" << distance.boundary_vertex_max / diagonal
            << " face_rms/D=" << distance.face_rms / diagonal << " face_max/D=" << distance.face_max / diagonal;
}

// both ways: exactly from the faces, and from a mesh so fine that it counts as the surface
void print_distance_to_ellipsoid(const Mesh& mesh)
{
  const Ellipsoid_distance exact;
  const Mesh fine = ellipsoid(7);
  const double diagonal = bounding_box_diagonal(fine);
  const Hde::Zero_set_measures from_faces = Hde::measure_distance_to_zero_set<Tag>(mesh, exact);
  const Hde::Distance_measures both = Hde::measure_distance<Tag>(fine, mesh);
  std::cout << " exact_rms/D=" << (std::max)(from_faces.face_rms, both.rms_from_first) / diagonal
            << " exact_max/D=" << (std::max)(from_faces.face_max, both.max_from_first) / diagonal
            << " normals=" << normal_deviation(mesh, exact);
}

// `build` returns the function; its time counts
template <typename Build>
void run(const Options& options, const Mesh& input, const Build& build)
{
  const std::size_t wanted = number_of_faces(options, input);
  const double sigma = options.sigma * bounding_box_diagonal(input);
  const double length = options.with_isotropic_remeshing ? isotropic_length(input, wanted) : 0;
  std::vector<double> function_seconds, remeshing_seconds, isotropic_seconds;
  Mesh mesh;
  Hde::Remeshing_result result;
  for (int i = 0; i < options.number_of_runs; ++i)
  {
    mesh = input;
    CGAL::Real_timer timer;
    timer.start();
    const auto function = build();
    function_seconds.push_back(timer.time());
    remeshing_seconds.push_back(seconds_of(
        [&] {
          result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::sigma(sigma).number_of_target_faces(wanted));
        }));
    if (options.with_isotropic_remeshing)
      isotropic_seconds.push_back(seconds_of([&] { isotropically_remeshed(input, length); }));
  }

  std::cout << options.mesh << " (" << input.number_of_faces() << " faces) to " << wanted << ", sigma " << options.sigma
            << " D:";
  print_figures(input, mesh, wanted, result);
  print_figures_of_embedding(input, mesh, build(), result);
  if (options.mesh == "ellipsoid" || options.mesh == "coarse-ellipsoid")
    print_distance_to_ellipsoid(mesh);
  const double rbf = median(function_seconds), remeshing = median(remeshing_seconds);
  std::cout << " seconds=" << rbf << "+" << remeshing;
  if (options.with_isotropic_remeshing)
  {
    const double isotropic = median(isotropic_seconds);
    const Mesh other = isotropically_remeshed(input, length);
    // without the normals the embedding is space
    const Hde::Embedding_measures in_space = Hde::measure_embedding(other, Sphere_function(), params::sigma(0));
    std::cout << " iso_seconds=" << isotropic << " ratio=" << (rbf + remeshing) / isotropic
              << " iso_faces=" << other.number_of_faces() << " iso_mean_angle_3D=" << in_space.minimum_angle_mean
              << " mean_angle_3D=" << Hde::measure_embedding(mesh, Sphere_function(), params::sigma(0)).minimum_angle_mean;
  }
  std::cout << std::endl;
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    if (options.mesh == "ellipsoid")
    {
      run(options, ellipsoid(6), [] { return Ellipsoid_function(); });
      return EXIT_SUCCESS;
    }
    if (options.mesh == "torus")
    {
      run(options, torus(512, 128), [] { return Torus_function(); });
      return EXIT_SUCCESS;
    }
    if (options.mesh == "coarse-ellipsoid") // of 2,562 vertices, its surface by radial basis functions
    {
      const Mesh input = ellipsoid(4);
      run(options, input, [&input] { return Rbf_function(input); });
      return EXIT_SUCCESS;
    }
    Mesh input;
    if (!PMP::IO::read_polygon_mesh(options.mesh, input))
      throw std::invalid_argument("cannot read " + options.mesh);
    PMP::remove_isolated_vertices(input); // isotropic_remeshing would keep them
    input.collect_garbage();
    run(options, input, [&input] { return Rbf_function(input); });
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
