// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_POINTS_FIGURES_H
#define HDE_REMESH_POINTS_FIGURES_H

#include <CGAL/Anisotropic_hde_remeshing/Reconstruction_result.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hde_remesh {

// what became of the points of IN
struct Points_figures
{
  std::size_t number = 0;
  bool are_normals_estimated = false;
  std::size_t number_without_normal = 0; // unknown in the file, or not to be oriented
  CGAL::Anisotropic_hde_remeshing::Reconstruction_result found;
  std::optional<double> trim;                     // the distance asked for
  std::size_t number_of_faces_after_trimming = 0; // if it was asked for
  std::size_t number_of_removed_components = 0;   // smaller ones than the largest, if only that was asked for
  std::vector<std::string> carried;               // names of the numbers that OUT has from the points
};

} // namespace hde_remesh

#endif // HDE_REMESH_POINTS_FIGURES_H
