// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How near meshes come to a surface that is known exactly, by embedding:
//
//   benchmark_embeddings ellipsoid|torus|MESH FACES EMBEDDING...
//
// `ellipsoid` is an icosphere of level 6 scaled by 1, 2 and 5; `torus` has the radii 1 and 1/4 and 65,536 vertices; a
// MESH is a file, remeshed through its RBF, from whose zero set distances are measured. An EMBEDDING is
// a number, sigma of the paper's embedding as a fraction of the diagonal D; `auto`, the adaptive one; or `p` and a number or
// `inf`, the metric of the curvature; with an `f` behind, the vertices are fitted to the surface in the end; or `e` and a number, the error
// asked for as a fraction of D, whatever FACES is, beside the faces that CGAL's isotropic_remeshing needs for it. Distances are printed over D and, in brackets, over the asymptotic bound; normals in degrees.

#include "exact_surfaces.h"
#include "isotropic_remeshing.h"
#include "seconds_of.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/approximation_bounds.h>
#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Parallel_if_available_tag Tag;

// how many faces isotropic_remeshing needs so that its faces are nearer than `error`; as many as four times the input's are tried
template <typename Distance>
std::size_t isotropic_faces_for(const Mesh& input, const Distance& exact, const double error)
{
  static constexpr int steps = 9;
  std::size_t few = 100, many = 4 * std::size_t(input.number_of_faces()), result = 0;
  for (int i = 0; i < steps; ++i)
  {
    const std::size_t middle = std::size_t(std::sqrt(double(few) * double(many)));
    const Mesh mesh = isotropically_remeshed(input, length_of_edges(input, middle));
    if (Hde::measure_distance_to_zero_set<Tag>(mesh, exact).face_max > error)
      few = middle;
    else
    {
      many = middle;
      result = mesh.number_of_faces();
    }
  }
  return result > 0 ? result : many;
}

// `fine` stands for the surface where its points are to be near the mesh
template <typename Function, typename Distance, typename NamedParameters>
void run(const Mesh& input, const Mesh& fine, const Function& function, const Distance& exact, const std::string& name,
         const NamedParameters& np)
{
  Mesh mesh = input;
  Hde::Remeshing_result result;
  const double seconds = seconds_of([&] { result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, np); });
  const double diagonal = bounding_box_diagonal(fine);
  const Hde::Topology_measures topology = Hde::measure_topology(mesh);
  const Hde::Zero_set_measures from_faces = Hde::measure_distance_to_zero_set<Tag>(mesh, exact);
  const Hde::Distance_measures both = Hde::measure_distance<Tag>(fine, mesh);
  const Hde::Approximation_bounds bounds = Hde::approximation_bounds<Tag>(mesh, exact);
  const double rms = (std::max)(from_faces.face_rms, both.rms_from_first),
               max = (std::max)(from_faces.face_max, both.max_from_first);
  std::cout << std::setw(8) << name << std::setw(8) << mesh.number_of_faces() << std::scientific << std::setprecision(2)
            << "  rms " << rms / diagonal << std::fixed << " (" << rms / bounds.rms_on_surface << ", free "
            << rms / bounds.rms_off_surface << ")" << std::scientific << "  max " << max / diagonal << std::fixed << " ("
            << max / bounds.max_on_surface << ")  normals " << std::setprecision(3) << normal_deviation(mesh, exact)
            << "  folds " << Hde::measure_embedding(mesh, exact).number_of_folded_faces << "  valence 6 "
            << topology.valence_6_share << std::setprecision(3);
  if (name[0] == 'e')
  {
    const double error = std::stod(name.substr(1)) * diagonal;
    const std::size_t isotropic = isotropic_faces_for(input, exact, error);
    std::cout << "  error at most " << std::scientific << result.approximation_error / diagonal << std::fixed
              << ", faces over the bound's " << error / bounds.max_on_surface << ", over the " << isotropic
              << " of isotropic_remeshing " << double(mesh.number_of_faces()) / double(isotropic);
  }
  std::cout << std::setprecision(2) << "  " << seconds << " s" << std::endl;
}

template <typename Function, typename Distance>
void run(const Mesh& input, const Mesh& fine, const Function& function, const Distance& exact, const std::size_t faces,
         const std::string& name)
{
  const auto run_embedding = [&](const auto& embedding)
  {
    run(input, fine, function, exact, name,
        params::embedding(embedding).number_of_target_faces(faces).fit_to_surface(name.back() == 'f' && name != "pinf"));
  };
  if (name.substr(0, 4) == "auto")
    run_embedding(Hde::Adaptive_normal_embedding());
  else if (name[0] == 'p')
    run_embedding(Hde::Curvature_metric(std::stod(name.substr(1))));
  else if (name[0] == 'e')
    run(input, fine, function, exact, name, params::relative_approximation_error(std::stod(name.substr(1))));
  else
    run_embedding(Hde::Normal_embedding(std::stod(name) * bounding_box_diagonal(input)));
}

int main(int argc, char* argv[])
{
  try
  {
    if (argc < 4)
      throw std::invalid_argument("usage: benchmark_embeddings ellipsoid|torus|MESH FACES EMBEDDING...");
    const std::string shape = argv[1];
    const std::size_t faces = std::stoul(argv[2]);
    const auto run_all = [&](const Mesh& input, const Mesh& fine, const auto& function, const auto& exact)
    {
      for (int i = 3; i < argc; ++i)
        run(input, fine, function, exact, faces, argv[i]);
    };
    if (shape == "ellipsoid")
      run_all(ellipsoid(6), ellipsoid(7), Ellipsoid_function(), Ellipsoid_distance());
    else if (shape == "torus")
      run_all(torus(512, 128), torus(1024, 256), Torus_function(), Torus_function());
    else
    {
      Mesh input;
      if (!PMP::IO::read_polygon_mesh(shape, input))
        throw std::invalid_argument("cannot read " + shape);
      PMP::remove_isolated_vertices(input);
      input.collect_garbage();
      const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(input);
      run_all(input, input, function, function);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
