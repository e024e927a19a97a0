// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Meshes of any size with the shape of a scan.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SCANS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SCANS_H

#include "shapes.h"

#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Rbf_function;

inline shapes::Mesh read_scan(const std::string& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  shapes::Mesh mesh;
  if (!PMP::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0 || !CGAL::is_triangle_mesh(mesh))
    throw std::invalid_argument("cannot read a triangle mesh from " + file);
  PMP::remove_isolated_vertices(mesh); // isotropic_remeshing would keep them
  mesh.collect_garbage();
  return mesh;
}

// the scan remeshed to a sixteenth of the faces, subdivided twice and projected on the zero set
inline shapes::Mesh resampled_scan(const shapes::Mesh& scan, const Rbf_function& function, const std::size_t number_of_faces)
{
  shapes::Mesh mesh = scan;
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, function,
                                                                   params::number_of_target_faces(number_of_faces / 16));
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, function, params::number_of_iterations(0));
  return mesh;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SCANS_H
