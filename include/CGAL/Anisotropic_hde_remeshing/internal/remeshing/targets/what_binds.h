// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_WHAT_BINDS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_WHAT_BINDS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What kept the mesh from a number of faces; that number itself if the mesh has reached it.
template <typename Mesh>
Target what_binds(const Mesh& mesh, const double number_of_faces)
{
  static constexpr double largest_miss = 0.01;                             // of the number of faces asked for
  const double tolerance = (std::max)(largest_miss * number_of_faces, 2.); // a split adds two faces
  if (!(std::abs(double(mesh.number_of_faces()) - number_of_faces) > tolerance))
    return Target::NUMBER_OF_FACES;
  const auto is_kept = [&](const Vertex_index v) { return mesh.point(v).is_on_curve || mesh.point(v).is_fixed; };
  std::size_t number_at_curves = 0;
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    number_at_curves += is_kept(t.a) || is_kept(t.b) || is_kept(t.c);
  }
  return 2 * number_at_curves > mesh.number_of_faces() ? Target::FEATURE_CURVES : Target::GUARDS;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_WHAT_BINDS_H
