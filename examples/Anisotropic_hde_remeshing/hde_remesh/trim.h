// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_TRIM_H
#define HDE_REMESH_TRIM_H

#include "Nearest_points.h"
#include "Soup.h"

namespace hde_remesh {

// The part of a mesh where a point is no further than the distance. Faces are cut along the line of this distance. Vertices next to
// the line are moved onto it along an edge, so that no narrow face comes to be. The soup is that of a manifold mesh, and may be empty.
Soup trimmed(const Soup& mesh, const Nearest_points& points, double distance);

} // namespace hde_remesh

#endif // HDE_REMESH_TRIM_H
