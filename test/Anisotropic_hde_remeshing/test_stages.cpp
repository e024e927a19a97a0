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

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include "check.h"

#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Sphere
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
  Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
};

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
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  CGAL::anisotropic_hde_remeshing(mesh, Sphere(), params::number_of_target_faces(200).number_of_iterations(2));

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
