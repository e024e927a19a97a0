// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_DESCRIBE_H
#define HDE_REMESH_DESCRIBE_H

#include "Mesh.h"
#include "Report.h"
#include "options.h"
#include "remesh.h"

namespace hde_remesh {

// Measures both meshes and writes all into the report, but for what reading the input has written there, and the times.
void describe(const Options& options, const Checked_mesh& input, const Sizes& sizes, const Remeshed& remeshed, Report& report,
              Progress& progress);

} // namespace hde_remesh

#endif // HDE_REMESH_DESCRIBE_H
