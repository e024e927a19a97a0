// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_RECONSTRUCT_H
#define HDE_REMESH_RECONSTRUCT_H

#include "Mesh.h"
#include "options.h"
#include "progress.h"

#include <CGAL/Anisotropic_hde_remeshing/Reconstruction_result.h>

#include <vector>

namespace hde_remesh {

struct Reconstructed
{
  Mesh mesh;
  CGAL::Anisotropic_hde_remeshing::Reconstruction_result result;
};

// The mesh of points with normals, which are zero where unknown. The options tell the smoothing and what becomes of outliers. Facets
// are of the size of the spacing, larger only where a number of faces is asked for that needs no more of them.
Reconstructed reconstruct(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals, const Options& options,
                          Progress& progress);

} // namespace hde_remesh

#endif // HDE_REMESH_RECONSTRUCT_H
