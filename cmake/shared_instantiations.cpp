// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the headers declare as compiled elsewhere, where CGAL_AHR_WITH_SHARED_INSTANTIATIONS is defined.

#include <CGAL/anisotropic_hde_remeshing.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

template class Patchwise_interpolant<Polyharmonic_rbf, Parallel_if_available_tag>;

template void remesh<Parallel_if_available_tag>(Working_mesh<Normal_embedding::Vertex_data>&, const Normal_embedding&,
                                                const Surface_function&, const Input_surface&, No_intersections&, double,
                                                double, Visitor_reference, Interruption&, const Remeshing_parameters&,
                                                Target_length, Remeshing_result&);
template void remesh<Parallel_if_available_tag>(Working_mesh<Curvature_metric::Vertex_data>&, const Curvature_metric&,
                                                const Surface_function&, const Input_surface&, No_intersections&, double,
                                                double, Visitor_reference, Interruption&, const Remeshing_parameters&,
                                                Target_length, Remeshing_result&);

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL
