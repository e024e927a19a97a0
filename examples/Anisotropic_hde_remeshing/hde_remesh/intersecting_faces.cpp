// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "intersecting_faces.h"
#include "have_same_topology.h"

#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

std::size_t number_of_pairs(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  return pairs.size();
}

std::size_t number_of_new_points(const Mesh& before, const Mesh& after)
{
  const std::set<Point_3> points(before.points().begin(), before.points().end());
  return static_cast<std::size_t>(std::count_if(after.vertices().begin(), after.vertices().end(),
                                                [&](const Mesh::Vertex_index v) { return points.count(after.point(v)) == 0; }));
}

} // namespace

Intersecting_faces untangle(Mesh& mesh)
{
  Intersecting_faces result;
  result.number = result.number_left = number_of_pairs(mesh);
  if (result.number == 0)
    return result;
  Mesh repaired = mesh; // CGAL may give up half the way
  try
  {
    PMP::experimental::remove_self_intersections(repaired, CGAL::parameters::preserve_genus(true));
  }
  catch (const std::exception&)
  {
    return result;
  }
  repaired.collect_garbage();
  if (!repaired.is_valid(false) || !CGAL::is_triangle_mesh(repaired) || !have_same_topology(mesh, repaired))
    return result;
  const std::size_t number = number_of_pairs(repaired);
  if (number >= result.number)
    return result;
  result.number_left = number;
  result.number_of_new_points = number_of_new_points(mesh, repaired);
  mesh = repaired;
  return result;
}

} // namespace hde_remesh
