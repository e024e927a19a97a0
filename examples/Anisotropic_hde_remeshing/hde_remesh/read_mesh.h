// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_READ_MESH_H
#define HDE_REMESH_READ_MESH_H

#include "Mesh.h"
#include "Report.h"
#include "options.h"
#include "progress.h"

namespace hde_remesh {

// Reads IN, mends it as far as the options say, and finds its creases. What there is to tell of it goes into the report: what was
// repaired, and notes and warnings, a line each.
// the mesh of IN, or that of the surface through its points, if it has no faces
Checked_mesh read_mesh(const Options& options, Report& report, Progress& progress);

} // namespace hde_remesh

#endif // HDE_REMESH_READ_MESH_H
