// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How stretched faces lie to the curvature, on shapes where that is known.

#include "check.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/alignment_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <iostream>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// long faces along a cylinder, and across it
void test_alignment()
{
  const Hde::Alignment_measures along = Hde::measure_alignment(cylinder(80, 5, 6), Cylinder_function());
  std::cout << "along: " << along.number_of_faces << " faces, " << along.angle_mean << " degrees" << std::endl;
  CHECK(along.number_of_faces == 800);
  CHECK(along.angle_mean < 5);
  CHECK(along.share_within_15_degrees == 1);
  const Hde::Alignment_measures across = Hde::measure_alignment(cylinder(12, 100, 6), Cylinder_function());
  std::cout << "across: " << across.number_of_faces << " faces, " << across.angle_mean << " degrees" << std::endl;
  CHECK(across.number_of_faces == 2400);
  CHECK(across.angle_mean > 80);
  CHECK(across.share_within_15_degrees == 0);
  // on a sphere the curvatures do not differ
  CHECK(Hde::measure_alignment(ellipsoid(3), Sphere_function()).number_of_faces == 0);
  // the remeshed ellipsoid follows its curvature
  Mesh mesh = ellipsoid(4);
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, Ellipsoid_function(), params::relative_sigma(0.15));
  const Hde::Alignment_measures remeshed = Hde::measure_alignment(mesh, Ellipsoid_function());
  std::cout << "remeshed: " << remeshed.number_of_faces << " faces, " << remeshed.angle_mean << " degrees" << std::endl;
  CHECK(remeshed.number_of_faces > 1000);
  CHECK(remeshed.angle_mean < 15);
}

int main()
{
  test_alignment();
  return check_summary();
}
