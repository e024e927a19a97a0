// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_HAVE_SAME_TOPOLOGY_H
#define HDE_REMESH_HAVE_SAME_TOPOLOGY_H

#include "Mesh.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>

namespace hde_remesh {

inline bool have_same_topology(const Mesh& a, const Mesh& b)
{
  const CGAL::Anisotropic_hde_remeshing::Topology_measures of_a = CGAL::Anisotropic_hde_remeshing::measure_topology(a),
                                                           of_b = CGAL::Anisotropic_hde_remeshing::measure_topology(b);
  return of_a.number_of_components == of_b.number_of_components &&
         of_a.number_of_boundary_loops == of_b.number_of_boundary_loops &&
         of_a.euler_characteristic == of_b.euler_characteristic;
}

} // namespace hde_remesh

#endif // HDE_REMESH_HAVE_SAME_TOPOLOGY_H
