// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Prints the figures of the implicit function by radial basis functions, measured and, where something is asked, asked:
//
//   benchmark_implicit_function [--sections abcdef] [MESH[:FACES]...]
//
// --sections  those wanted, by default all:
//   a  every kernel on an ellipsoid: accuracy, residuals, derivatives, how its systems were solved, time
//   b  convergence of r^3 on the ellipsoid
//   c  an evaluation on each mesh: time, terms of the kernel sums, the share of the machine's square roots
//   d  the build of each mesh: time, beside CGAL's isotropic_remeshing, and memory; of the same, subdivided
//   e  the sign near each mesh and in its box
//   f  the build with one and with two threads
// MESH        a file (OFF, OBJ, PLY, STL); c to f are of the meshes
// FACES       to how many isotropic_remeshing goes in d (default: those of the mesh)

#include "Table.h"
#include "implicit_function/accuracy.h"
#include "implicit_function/build.h"
#include "implicit_function/common.h"
#include "implicit_function/evaluation.h"
#include "implicit_function/sign.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

struct Options
{
  std::string sections = "abcdef";
  std::vector<std::string> meshes;

  bool wants(const char section) const { return sections.find(section) != std::string::npos; }
};

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i] == "--sections" && i + 1 < arguments.size())
      options.sections = arguments[++i];
    else if (arguments[i].rfind("--", 0) == 0)
      throw std::invalid_argument("usage: benchmark_implicit_function [--sections abcdef] [MESH[:FACES]...]");
    else
      options.meshes.push_back(arguments[i]);
  if (options.sections.find_first_not_of("abcdef") != std::string::npos)
    throw std::invalid_argument("the sections are a to f, not " + options.sections);
  return options;
}

Input read_input(const std::string& argument)
{
  const std::size_t colon = argument.rfind(':');
  const std::string file = argument.substr(0, colon);
  Input input;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, input.mesh) || !CGAL::is_triangle_mesh(input.mesh) ||
      input.mesh.number_of_faces() == 0)
    throw std::invalid_argument("cannot read a triangle mesh from " + file);
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(input.mesh); // isotropic_remeshing would keep them
  input.mesh.collect_garbage();
  input.name = file.substr(file.find_last_of('/') + 1);
  input.number_of_target_faces =
      colon == std::string::npos ? input.mesh.number_of_faces() : std::size_t(std::stoul(argument.substr(colon + 1)));
  return input;
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    std::vector<Input> inputs;
    for (const std::string& mesh : options.meshes)
      inputs.push_back(read_input(mesh));
    if (options.wants('a'))
      run_kernel_section();
    if (options.wants('b'))
      run_convergence_section();
    if (options.wants('c'))
      run_evaluation_section(inputs);
    if (options.wants('d'))
      for (const Input& input : inputs)
        run_build_section(input);
    if (options.wants('e'))
      run_sign_section(inputs);
    if (options.wants('f'))
      run_thread_section(inputs);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
