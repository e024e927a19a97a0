// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The program of the README with CGAL's isotropic_remeshing instead: what remeshing by CGAL takes to compile.

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc != 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << "usage: remesh_isotropically IN OUT LENGTH" << std::endl, 1;
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), std::atof(argv[3]), mesh);
  return CGAL::IO::write_polygon_mesh(argv[2], mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
