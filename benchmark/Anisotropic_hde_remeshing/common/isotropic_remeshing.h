// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// CGAL's isotropic_remeshing, the yardstick for the time of the build.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_ISOTROPIC_REMESHING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_ISOTROPIC_REMESHING_H

#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <cstddef>
#include <iostream>

inline shapes::Mesh isotropically_remeshed(const shapes::Mesh& input, const double length)
{
  shapes::Mesh mesh = input;
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), length, mesh, CGAL::parameters::number_of_iterations(10));
  return mesh;
}

// the side of the equilateral triangles that cover the mesh, so many of them
inline double length_of_edges(const shapes::Mesh& mesh, const std::size_t number_of_faces)
{
  return std::sqrt(CGAL::Polygon_mesh_processing::area(mesh) / double(number_of_faces) * 4 / std::sqrt(3.));
}

// the edge length that gives the number of faces within 2%
inline double isotropic_length(const shapes::Mesh& input, const std::size_t wanted)
{
  double length = length_of_edges(input, wanted);
  for (int attempt = 0; attempt < 12; ++attempt)
  {
    const double ratio = double(isotropically_remeshed(input, length).number_of_faces()) / double(wanted);
    if (std::abs(ratio - 1) <= 0.02)
      return length;
    length *= std::sqrt(ratio);
  }
  std::cerr << "isotropic_remeshing does not come within 2% of the number of faces" << std::endl;
  return length;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_ISOTROPIC_REMESHING_H
