// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The package's headers among those of CGAL's other packages: after all of them, and compiled once more before them.

#ifdef CGAL_AHR_TEST_BEFORE_CGAL
#  include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#  include <CGAL/Rbf_implicit_function.h>
#  include <CGAL/anisotropic_hde_remeshing.h>
#endif

#include "headers_of_cgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#ifndef CGAL_AHR_TEST_BEFORE_CGAL
#  include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#  include <CGAL/Rbf_implicit_function.h>
#  include <CGAL/anisotropic_hde_remeshing.h>
#endif

#include "check.h"

#include <CGAL/boost/graph/generators.h>

#include <cmath>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// What creases are made of is all compiled. A cube remains one.
int main()
{
  Mesh mesh;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0), Kernel::Point_3(0, 1, 0),
                        Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1), Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1),
                        mesh);
  PMP::triangulate_faces(mesh);
  CGAL::anisotropic_hde_remeshing<CGAL::Sequential_tag>(mesh, params::sharp_angle(30.).number_of_target_faces(200));
  CHECK(CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_closed(mesh));
  CHECK(std::abs(PMP::volume(mesh) - 1) < 1e-9);
  CHECK(mesh.number_of_faces() > 100);
  return check_summary();
}
