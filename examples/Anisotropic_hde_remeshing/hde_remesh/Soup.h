// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_SOUP_H
#define HDE_REMESH_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <vector>

namespace hde_remesh {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;

// a number for every vertex or every face
struct Array
{
  std::string name;
  std::vector<double> values;
  bool are_bytes = false; // whole numbers from 0 to 255, as parts of colours are
};

// what a mesh file holds, before anybody asks whether it is a mesh
struct Soup
{
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<Array> vertex_arrays, face_arrays; // written to PLY and VTP; only read of points
  std::vector<Vector_3> normals;                 // of the points, if there are no faces, as the file has them
  double rounding = 0;                           // the unit in the last place of the largest coordinate in the file
  std::vector<std::string> notes;                // what its reader has to say, a line each

  // whether the file has no faces: a cloud, of which a surface has yet to be made
  bool is_of_points() const { return faces.empty() && !points.empty(); }
};

} // namespace hde_remesh

#endif // HDE_REMESH_SOUP_H
