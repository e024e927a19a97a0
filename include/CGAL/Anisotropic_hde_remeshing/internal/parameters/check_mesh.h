// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_MESH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_MESH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Throws std::invalid_argument if the face of `h` is not a triangle. `position` is that of the face among all faces.
template <typename TriangleMesh>
void check_triangle(const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const TriangleMesh& tmesh,
                    const std::size_t position)
{
  if (next(next(next(h, tmesh), tmesh), tmesh) != h)
    throw std::invalid_argument("face " + std::to_string(position) + " is not a triangle");
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_CHECK_MESH_H
