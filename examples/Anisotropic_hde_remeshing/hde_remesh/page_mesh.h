// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_PAGE_MESH_H
#define HDE_REMESH_PAGE_MESH_H

#include "Mesh.h"

#include <CGAL/Bbox_3.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace hde_remesh {

// the figure of each face of a mesh
struct Face_figure
{
  std::string key;
  const std::vector<double>& values;
  bool is_logarithmic;
};

// A mesh as the page has it: about 23 bytes for a face with four figures. Coordinates are in steps of 2^-24 of the longest side
// of `box`, figures in steps of 2^-16 of their range. The creases and boundaries of the mesh are two points an edge. A mesh of
// more than `largest_number_of_faces` is simplified.
nlohmann::ordered_json page_mesh(const Mesh& mesh, const CGAL::Bbox_3& box, const std::vector<Face_figure>& figures,
                                 std::size_t largest_number_of_faces);

} // namespace hde_remesh

#endif // HDE_REMESH_PAGE_MESH_H
