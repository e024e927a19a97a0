// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The runs of the paper's chapter 5 (Dassi, Farrell, Si), with its kernel, overlap and scheme, beside its own figures.
//   paper_example [BUNNY LUCY BRONCHUS]
// Without arguments, meshes of CGAL's data stand for the paper's, which are not part of CGAL.
//
// The shares of the number of faces are the paper's. Its weights sigma and lengths l are not used: those that are printed do not
// fit the printed numbers of faces at any one unit of the meshes. Sigma is a share of the diagonal of the bounding box, as
// given below.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Thin_plate_rbf, Tag> Function;

// one mesh of the paper and what became of it there
struct Run
{
  struct Result
  {
    double number_of_faces, aspect_ratio;
  };

  std::string name;
  std::string substitute; // in CGAL's data
  double relative_sigma;
  std::size_t number_of_patches; // the paper's K
  Result input;
  std::vector<Result> outputs;
};

const std::vector<Run> runs = {
    {"bunny", "bunny00.off", 0.01, 200, {69451, 0}, {{110350, 398.9}}},
    {"Lucy", "armadillo.off", 0.01, 3000, {510180, 1.21}, {{141674, 95.83}, {67888, 65.04}}},
    {"bronchus", "elephant.off", 0.01, 200, {42692, 60.0}, {{34954, 128}, {12026, 753}, {132784, 708}}}};

void print(const std::string& what, const Mesh& mesh, const std::size_t number_of_input_faces, const Run::Result& paper,
           const double paper_input_faces)
{
  const Hde::Shape_measures shape = Hde::measure_shape(mesh);
  std::cout << std::left << std::setw(34) << what << std::right << std::setw(9) << mesh.number_of_faces() << std::setw(7)
            << std::lround(100. * double(mesh.number_of_faces()) / double(number_of_input_faces)) << "%" << std::setw(10)
            << shape.aspect_ratio_max << std::setw(8) << shape.number_of_folded_edges << "   |" << std::setw(9)
            << std::lround(paper.number_of_faces) << std::setw(7)
            << std::lround(100. * paper.number_of_faces / paper_input_faces) << "%" << std::setw(10);
  if (paper.aspect_ratio > 0)
    std::cout << paper.aspect_ratio << std::endl;
  else
    std::cout << "-" << std::endl;
}

bool reproduce(const Run& run, const std::string& file_name)
{
  Mesh input;
  if (!CGAL::IO::read_polygon_mesh(file_name, input))
  {
    std::cerr << "Cannot read " << file_name << std::endl;
    return false;
  }
  const std::string stem = file_name.substr(file_name.find_last_of('/') + 1);
  print(run.name + ": " + stem, input, input.number_of_faces(), run.input, run.input.number_of_faces);

  // K is the paper's where the mesh is as large; Ov = 3; eps is left to the default, a share of the local edge length
  const std::size_t number_of_patches =
      1 + std::size_t(double(run.number_of_patches) * double(input.number_of_faces()) / run.input.number_of_faces);
  const Function function(input, params::number_of_patches(number_of_patches).patch_overlap(3));
  for (const Run::Result& paper : run.outputs)
  {
    Mesh mesh = input;
    const double share = paper.number_of_faces / run.input.number_of_faces;
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, function,
                                         params::relative_sigma(run.relative_sigma)
                                             .number_of_target_faces(std::size_t(share * double(input.number_of_faces())))
                                             .remeshing_scheme(Hde::Remeshing_scheme::PAPER));
    print("", mesh, input.number_of_faces(), paper, run.input.number_of_faces);
  }
  return true;
}

int main(int argc, char* argv[])
{
  if (argc != 1 && argc != 1 + int(runs.size()))
  {
    std::cerr << "usage: paper_example [BUNNY LUCY BRONCHUS]" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << std::setprecision(4) << std::left << std::setw(34) << "mesh" << std::right << std::setw(9) << "faces"
            << std::setw(8) << "share" << std::setw(10) << "q" << std::setw(8) << "folds"
            << "   |" << std::setw(9) << "paper" << std::setw(8) << "share" << std::setw(10) << "q" << std::endl;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!reproduce(runs[i], argc > 1 ? argv[i + 1] : CGAL::data_file_path("meshes/" + runs[i].substitute)))
      return 1;
  std::cout << "share: of the faces of the input; q: the largest aspect ratio; folds: edges over which two faces lie on each "
               "other\n";
  return 0;
}
