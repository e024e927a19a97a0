// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_FIGURES_H
#define HDE_REMESH_FIGURES_H

#include <CGAL/Anisotropic_hde_remeshing/Measures.h>
#include <CGAL/Anisotropic_hde_remeshing/approximation_bounds.h>

#include <cstddef>
#include <optional>

namespace hde_remesh {

namespace Hde = CGAL::Anisotropic_hde_remeshing;

// the figures that only a function can tell
struct Function_figures
{
  Hde::Embedding_measures embedding;           // shares relative to the mean length
  Hde::Embedding_measures embedding_to_target; // shares relative to the length aimed at
  Hde::Alignment_measures alignment;
  Hde::Zero_set_measures zero_set;
  Hde::Approximation_bounds bounds;
};

// the figures of one mesh: a column of the table
struct Figures
{
  Hde::Topology_measures topology;
  Hde::Shape_measures shape;
  std::optional<Function_figures> of_function;   // where there is one
  std::optional<std::size_t> self_intersections; // pairs of faces, if they were asked for
};

} // namespace hde_remesh

#endif // HDE_REMESH_FIGURES_H
