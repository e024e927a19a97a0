// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MEASURE_H
#define HDE_REMESH_MEASURE_H

#include "Figures.h"
#include "Function_view.h"
#include "Mesh.h"

#include <functional>
#include <vector>

namespace hde_remesh {

Hde::Topology_measures measure_topology(const Mesh& mesh);

// of the bounding box
double diagonal(const Mesh& mesh);

// What the steps of `measure()` take of the time, in microseconds or so.
std::vector<double> costs_of_measures(const Mesh& mesh, const Function_view& function, bool with_self_intersections);

Figures measure(const Mesh& mesh, const Function_view& function, double sigma, double target_edge_length,
                bool with_self_intersections, const std::function<void()>& step_is_done);

// of the ends and the middles of the edges of `mesh` that turn by so much, the largest one to `other`
double distance_of_sharp_edges(const Mesh& mesh, const Mesh& other, double degrees);

Hde::Distance_measures measure_distance(const Mesh& first, const Mesh& second);

} // namespace hde_remesh

#endif // HDE_REMESH_MEASURE_H
