// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// CGAL_AHR_WRITE_STAGES: each stage of the remeshing is written to a file with the whole mesh and its states. The program is
// compiled without the shared instantiations, see CMakeLists.txt.

#define CGAL_AHR_WRITE_STAGES "test_stages"

#include <CGAL/anisotropic_hde_remeshing.h>

#include "check.h"
#include "shapes.h"

#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// the number after a word of the file
std::size_t number_after(const std::string& word, const std::string& name)
{
  std::ifstream in(name);
  std::string w;
  while (in >> w)
    if (w == word)
    {
      std::size_t number = 0;
      in >> number;
      return number;
    }
  return 0;
}

int main()
{
  shapes::Mesh mesh = shapes::icosphere(0);
  CGAL::anisotropic_hde_remeshing(mesh, shapes::Sphere_function(), params::number_of_target_faces(200).number_of_iterations(2));

  const std::string beginning = CGAL_AHR_WRITE_STAGES;
  const std::vector<std::string> names = {"000_input", "001_projected",  "002_split",    "003_contracted", "004_smoothed",
                                          "005_split", "006_contracted", "007_smoothed", "008_exact",      "009_finished"};
  for (const std::string& name : names)
  {
    const std::string file = beginning + "_" + name + ".vtk";
    std::cout << file << ": " << number_after("POINTS", file) << " points, " << number_after("POLYGONS", file) << " faces"
              << std::endl;
    CHECK(number_after("POINTS", file) >= 12);
    CHECK(number_after("POLYGONS", file) == 2 * number_after("POINTS", file) - 4); // a closed surface of genus 0
    CHECK(number_after("POINT_DATA", file) == number_after("POINTS", file));
    CHECK(number_after("CELL_DATA", file) == number_after("POLYGONS", file));
  }
  CHECK(number_after("POLYGONS", beginning + "_000_input.vtk") == 20);
  CHECK(number_after("POLYGONS", beginning + "_009_finished.vtk") == mesh.number_of_faces());
  return check_summary();
}
