// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "flat_faces.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <algorithm>
#include <exception>

namespace hde_remesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

std::size_t number_of_flat_faces(const Mesh& mesh)
{
  return static_cast<std::size_t>(std::count_if(mesh.faces().begin(), mesh.faces().end(),
                                                [&](const Mesh::Face_index f)
                                                { return PMP::is_degenerate_triangle_face(f, mesh); }));
}

bool have_same_topology(const Mesh& a, const Mesh& b)
{
  const CGAL::Anisotropic_hde_remeshing::Topology_measures of_a = CGAL::Anisotropic_hde_remeshing::measure_topology(a),
                                                           of_b = CGAL::Anisotropic_hde_remeshing::measure_topology(b);
  return of_a.number_of_components == of_b.number_of_components &&
         of_a.number_of_boundary_loops == of_b.number_of_boundary_loops &&
         of_a.euler_characteristic == of_b.euler_characteristic;
}

} // namespace

Flat_faces remove_flat_faces(Mesh& mesh)
{
  Flat_faces result;
  result.number = result.number_left = number_of_flat_faces(mesh);
  if (result.number == 0)
    return result;
  Mesh repaired = mesh; // CGAL may cut holes, or give up half the way
  try
  {
    PMP::remove_degenerate_faces(repaired);
  }
  catch (const std::exception&)
  {
    return result;
  }
  repaired.collect_garbage();
  if (!repaired.is_valid(false) || !have_same_topology(mesh, repaired))
    return result;
  result.number_left = number_of_flat_faces(repaired);
  mesh = repaired;
  return result;
}

} // namespace hde_remesh
