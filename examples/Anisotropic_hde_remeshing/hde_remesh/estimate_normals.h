// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_ESTIMATE_NORMALS_H
#define HDE_REMESH_ESTIMATE_NORMALS_H

#include "Soup.h"

#include <vector>

namespace hde_remesh {

// Unit normals of points, by CGAL: from quadrics that are fitted to the nearest points, oriented along a minimum spanning tree of
// neighbours, outward at the highest point of each part that hangs together. Zero where a normal could not be found or oriented.
std::vector<Vector_3> estimate_normals(const std::vector<Point_3>& points);

} // namespace hde_remesh

#endif // HDE_REMESH_ESTIMATE_NORMALS_H
