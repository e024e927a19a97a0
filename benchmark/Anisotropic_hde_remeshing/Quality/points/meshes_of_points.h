// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MESHES_OF_POINTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MESHES_OF_POINTS_H

#include "Table.h"
#include "scanned_shapes.h"

// Meshes of clean points, noisy ones, with outliers, and with a cap or a half missing, by this package and by CGAL's Poisson
// reconstruction: their distance to the shape, the largest one of the shape to them, the time, and the memory.
void add_rows_of_meshes(Table& table, const Shape& shape);

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MESHES_OF_POINTS_H
