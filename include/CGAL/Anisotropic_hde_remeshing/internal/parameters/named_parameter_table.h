// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The table of the named parameters: those of this package, and those of CGAL's that it reads. A line says the name, for CGAL's
// also the tag, what type is accepted (a condition of parameter_types.h), and the same in words. Who includes this file defines
// what becomes of a line. So there is no include guard here, and the two macros are undefined in the end.

#ifndef CGAL_AHR_NAMED_PARAMETER
#  error "define CGAL_AHR_NAMED_PARAMETER and CGAL_AHR_NAMED_PARAMETER_OF_CGAL before this file is included"
#endif

// clang-format off
// of the remeshing
CGAL_AHR_NAMED_PARAMETER(sigma, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(relative_sigma, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(embedding, Is_embedding_or_metric, "a model of RemeshingEmbedding or RemeshingMetric, such as Curvature_metric(2)")
CGAL_AHR_NAMED_PARAMETER(sizing_field, Is_sizing_field, "a function of a point, a property map from the vertices of the mesh to numbers, or a model of PMPSizingField")
CGAL_AHR_NAMED_PARAMETER(gradation, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(target_edge_length, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(relative_target_edge_length, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(number_of_target_faces, Is_count, "an integer")
CGAL_AHR_NAMED_PARAMETER(approximation_error, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(relative_approximation_error, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(fit_to_surface, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(shape_weight, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(aspect_ratio_bound, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(project_borders, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(number_of_iterations, number_of_iterations_t, Is_count, "an integer")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(number_of_relaxation_steps, number_of_relaxation_steps_t, Is_count, "an integer")
CGAL_AHR_NAMED_PARAMETER(remeshing_scheme, Is_remeshing_scheme, "a Remeshing_scheme, DEFAULT or PAPER")
CGAL_AHR_NAMED_PARAMETER(split_ratio, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(collapse_ratio, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(smoothing_ratio, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(edge_is_constrained_map, edge_is_constrained_t, Is_written_edge_boolean_map, "a readable and writable property map from the edges of the mesh to bool")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(vertex_is_constrained_map, vertex_is_constrained_t, Is_vertex_boolean_map, "a property map from the vertices of the mesh to bool")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(face_patch_map, face_patch_t, Is_written_face_map, "a readable and writable property map from the faces of the mesh")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(protect_constraints, protect_constraints_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(collapse_constraints, collapse_constraints_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(relax_constraints, relax_constraints_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(do_split, do_split_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(do_collapse, do_collapse_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(do_flip, do_flip_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(do_self_intersection_tests, do_self_intersection_tests_t, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(vertex_location_map, Is_location_map, "a writable property map from the vertices of the mesh to Input_location")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(visitor, visitor_t, Is_visitor, "a model of RemeshingVisitor, such as a class derived from Remeshing_visitor")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(vertex_point_map, vertex_point_t, Is_written_vertex_point_map, "a readable and writable property map from the vertices of the mesh to points")
CGAL_AHR_NAMED_PARAMETER(sharp_angle, Is_number, "a number")
// of the implicit function
CGAL_AHR_NAMED_PARAMETER(number_of_patches, Is_count, "an integer")
CGAL_AHR_NAMED_PARAMETER(patch_overlap, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(offset_distance, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(relative_offset_distance, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(two_sided_offsets, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(smoothing, Is_smoothing, "a number or AUTOMATIC_SMOOTHING")
CGAL_AHR_NAMED_PARAMETER(points_on_facets, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(detect_edges, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(detect_outliers, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(close_holes, Is_boolean, "a Boolean")
CGAL_AHR_NAMED_PARAMETER(radial_function, Is_radial_function, "a model of RadialBasisFunction, such as Wendland_C4_rbf()")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(vertex_normal_map, vertex_normal_map_t, Is_vertex_point_map, "a property map from the vertices of the mesh to vectors")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(point_map, point_t, Has_points_of_range, "a property map from the elements of the range to points")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(normal_map, normal_t, Has_points_of_range, "a property map from the elements of the range to vectors")
// of the surface mesher. CGAL has these names since 5.6, and keeps no copy of facet_distance.
CGAL_AHR_NAMED_PARAMETER(facet_angle, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(facet_size, Is_number, "a number")
CGAL_AHR_NAMED_PARAMETER(facet_distance, Is_number, "a number")
// of measures, and of several functions
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(geom_traits, geom_traits_t, Is_kernel, "a kernel")
CGAL_AHR_NAMED_PARAMETER_OF_CGAL(number_of_points_on_faces, number_of_points_on_faces_t, Is_count, "an integer")
// clang-format on

#undef CGAL_AHR_NAMED_PARAMETER
#undef CGAL_AHR_NAMED_PARAMETER_OF_CGAL
