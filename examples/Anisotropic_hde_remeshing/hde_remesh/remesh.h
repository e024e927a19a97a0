// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_REMESH_H
#define HDE_REMESH_REMESH_H

#include "Function_view.h"
#include "Mesh.h"
#include "options.h"
#include "progress.h"

#include <CGAL/Anisotropic_hde_remeshing/Piecewise_rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_scheme.h>

#include <cstddef>
#include <optional>
#include <string>

namespace hde_remesh {

// the sizes to remesh to, in numbers of the library
struct Sizes
{
  double sigma = 0;
  std::optional<double> edge_length; // one of these three, or the last two
  std::optional<double> error;
  std::optional<std::size_t> number_of_faces;
  double tau = 0; // of the field, where there is one
  CGAL::Anisotropic_hde_remeshing::Remeshing_scheme scheme = CGAL::Anisotropic_hde_remeshing::Remeshing_scheme::DEFAULT;
};

struct Remeshed
{
  Mesh mesh;
  Function_view function;    // without values by measured error
  std::string kernel;        // none without a function
  bool keeps_facets = false; // whether the function is the planes of exact facets, each a region
  double function_seconds = 0;
  std::optional<CGAL::Anisotropic_hde_remeshing::Rbf_diagnostics> rbf;
  std::optional<CGAL::Anisotropic_hde_remeshing::Piecewise_rbf_diagnostics> pieces; // in its place with --sharp, or of facets
  CGAL::Anisotropic_hde_remeshing::Remeshing_result result;
};

// The scheme of the library, and its name on the command line. By default the measured error leads where a number of triangles is
// asked for, and nothing that concerns an embedding or the function, if that number is not too near to that of IN, or the facets of IN
// are exact.
CGAL::Anisotropic_hde_remeshing::Remeshing_scheme scheme_of(const Sizes& sizes, const Options& options, const Mesh& mesh);
std::string scheme_text(CGAL::Anisotropic_hde_remeshing::Remeshing_scheme scheme);

// the embedding in words, and whether it is the paper's
std::string embedding_text(const Sizes& sizes, const Options& options);
bool has_6d_lengths(const Sizes& sizes, const Options& options);

// Remeshes a copy of the mesh, on a function with the kernel asked for. By measured error there is none. Where the facets of the mesh
// are exact, an embedding keeps to them: each becomes a region of the mesh. If the number of faces does not allow that, the measured
// error leads, and the scheme is that one afterwards.
Remeshed remesh(Mesh& mesh, Sizes& sizes, const Options& options, Progress& progress);

} // namespace hde_remesh

#endif // HDE_REMESH_REMESH_H
