// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "flat_faces.h"
#include "have_same_topology.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

namespace hde_remesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

double length(const Mesh& mesh, const Mesh::Halfedge_index h)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

// the side that is the longest one, or the shortest one if the sign is -1
Mesh::Halfedge_index longest_side(const Mesh& mesh, const Mesh::Face_index f, const double sign)
{
  const Mesh::Halfedge_index a = mesh.halfedge(f), b = mesh.next(a), c = mesh.next(b);
  const auto is_less = [&](const Mesh::Halfedge_index h, const Mesh::Halfedge_index g)
  { return sign * length(mesh, h) < sign * length(mesh, g); };
  return (std::max)({a, b, c}, is_less);
}

// whether the least height is not above the tolerance
bool is_flat(const Mesh& mesh, const Mesh::Face_index f, const double tolerance)
{
  const Mesh::Halfedge_index h = longest_side(mesh, f, 1);
  const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) <= tolerance * length(mesh, h);
}

std::size_t number_of_flat_faces(const Mesh& mesh, const double tolerance)
{
  return static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(),
                                                [&](const Mesh::Face_index f) { return is_flat(mesh, f, tolerance); }));
}

// A short edge is contracted, so that vertices of the boundary stay.
bool contract(Mesh& mesh, const Mesh::Halfedge_index h)
{
  const Mesh::Edge_index e = mesh.edge(h);
  if (!CGAL::Euler::does_satisfy_link_condition(e, mesh))
    return false;
  const Point_3 stays = mesh.point(mesh.is_border(mesh.source(h)) ? mesh.source(h) : mesh.target(h));
  mesh.point(CGAL::Euler::collapse_edge(e, mesh)) = stays;
  return true;
}

// The longest side of a face whose third vertex lies on it: the face beyond is divided there.
bool flip(Mesh& mesh, const Mesh::Halfedge_index h)
{
  if (mesh.is_border(mesh.opposite(h)))
    return false;
  const Mesh::Vertex_index a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
  if (a == b || mesh.halfedge(a, b) != Mesh::null_halfedge())
    return false;
  CGAL::Euler::flip_edge(h, mesh);
  return true;
}

// Faces that are flat but for rounding. Some need others to go first.
void remove_nearly_flat_faces(Mesh& mesh, const double tolerance)
{
  static constexpr int largest_number_of_passes = 10;
  bool has_changed = true;
  for (int pass = 0; has_changed && pass < largest_number_of_passes; ++pass)
  {
    has_changed = false;
    const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
    for (const Mesh::Face_index f : faces)
    {
      if (mesh.is_removed(f) || !is_flat(mesh, f, tolerance))
        continue;
      const Mesh::Halfedge_index shortest = longest_side(mesh, f, -1);
      has_changed = (length(mesh, shortest) <= tolerance ? contract(mesh, shortest) : flip(mesh, longest_side(mesh, f, 1))) ||
                    has_changed;
    }
  }
}

} // namespace

Flat_faces remove_flat_faces(Mesh& mesh, const double tolerance)
{
  Flat_faces result;
  result.number = result.number_left = number_of_flat_faces(mesh, tolerance);
  if (result.number == 0)
    return result;
  Mesh repaired = mesh; // CGAL may cut holes, or give up half the way
  try
  {
    remove_nearly_flat_faces(repaired, tolerance);
    PMP::remove_degenerate_faces(repaired);
  }
  catch (const std::exception&)
  {
    return result;
  }
  repaired.collect_garbage();
  if (!repaired.is_valid(false) || !have_same_topology(mesh, repaired))
    return result;
  result.number_left = number_of_flat_faces(repaired, tolerance);
  mesh = repaired;
  return result;
}

} // namespace hde_remesh
