// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_BUILD_FUNCTION_H
#define HDE_REMESH_BUILD_FUNCTION_H

#include "Function_view.h"
#include "Mesh.h"
#include "options.h"
#include "progress.h"

#include <CGAL/Anisotropic_hde_remeshing/Piecewise_rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>

#include <optional>
#include <string>

namespace hde_remesh {

struct Built_function
{
  Function_view function;
  std::string kernel;
  std::optional<CGAL::Anisotropic_hde_remeshing::Rbf_diagnostics> rbf;
  std::optional<CGAL::Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics> pieces; // in its place with --sharp, or of facets
};

// Builds the function of the mesh with the kernel that the options name.
Built_function build_function(const Mesh& mesh, const Options& options, Progress& progress);

} // namespace hde_remesh

#endif // HDE_REMESH_BUILD_FUNCTION_H
