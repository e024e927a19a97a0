// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// A user's program without the package's CMake target, which has only named parameters of the package and of CGAL.

#include <CGAL/Named_function_parameters.h>

#include <CGAL/anisotropic_hde_remeshing.h>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

int main()
{
  const auto np = params::number_of_iterations(3).sigma(0.1).number_of_target_faces(80);
  return params::get_parameter(np, CGAL::Anisotropic_hde_remeshing::internal_np::sigma) == 0.1 ? 0 : 1;
}
