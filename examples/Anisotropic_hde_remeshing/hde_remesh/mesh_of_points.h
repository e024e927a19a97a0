// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MESH_OF_POINTS_H
#define HDE_REMESH_MESH_OF_POINTS_H

#include "Mesh.h"
#include "Report.h"
#include "options.h"
#include "progress.h"

namespace hde_remesh {

// The mesh of the surface through the points of a soup without faces, trimmed and without smaller components if the options ask for
// that; a field comes from the nearest points. Tells the report what was found.
Mesh mesh_of_points(const Soup& points, const Options& options, Report& report, Progress& progress);

// Adds what points carry to the soup of a mesh, whose vertices have it of the nearest point.
void carry_to(Soup& soup, const Soup& points, Report& report);

// the options of the rest of the program, which has a mesh without noise
Options without_noise(Options options);

// fails if the options ask for something that only points have
void check_options_of_mesh(const Options& options);

} // namespace hde_remesh

#endif // HDE_REMESH_MESH_OF_POINTS_H
