// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Named_function_parameters.h>

// Without the names, every use of them would fail with pages of errors. Here one line says what is wrong.
#ifndef CGAL_AHR_NAMED_PARAMETERS_OVERLAY
#  error "Anisotropic_hde_remeshing: put this package's include folder before CGAL's, as its CMake target does"
#endif

#include <CGAL/boost/graph/named_params_helper.h>

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
