// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Repair of soups that are no manifold triangle mesh, most of it by CGAL, as far as it goes without moving a point further than a
// tolerance.

#ifndef HDE_REMESH_REPAIR_H
#define HDE_REMESH_REPAIR_H

#include "Soup.h"

#include <cstddef>
#include <functional>
#include <string>

namespace hde_remesh {

// what was changed
struct Repair
{
  std::size_t merged_points = 0; // that were equal to another
  std::size_t near_points = 0;   // that were within the tolerance of another
  double tolerance = 0;
  std::size_t wall_faces = 0;     // removed, as they were inside a solid
  std::size_t removed_points = 0; // without a face in the end
  std::size_t removed_faces = 0;  // that were there twice, or had fewer than three vertices
  std::size_t turned_faces = 0;
  std::size_t doubled_points = 0; // where more sheets met than a manifold has
  std::size_t divided_faces = 0;  // that had more than three vertices
  std::size_t added_points = 0;   // where a face could not be divided without
  std::size_t stitched_edges = 0;

  std::string text() const;
};

// The points are finite, and the faces name no others. Points within the tolerance of each other close cracks.
// `step_is_done` is called after each of the `number_of_repair_steps` steps.
constexpr std::size_t number_of_repair_steps = 8;
Soup repaired(
    Soup soup, double tolerance, Repair& repair, const std::function<void()>& step_is_done = [] {});

} // namespace hde_remesh

#endif // HDE_REMESH_REPAIR_H
