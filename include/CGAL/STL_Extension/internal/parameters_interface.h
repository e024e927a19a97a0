// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// CGAL/Named_function_parameters.h includes a file of this name three times, each time with another meaning of
// CGAL_add_named_parameter. So there is no include guard here. This file must be found before CGAL's file of the same name. It
// includes that file and adds the names of this package to it.

#if defined(__GNUC__)
#  pragma GCC system_header // -Wpedantic would warn of #include_next, an extension, in every translation unit
#endif

#ifdef CGAL_AHR_INSIDE_PARAMETERS_INTERFACE

// This is a second copy of this package on the include path. The first one has included it and adds the names: pass on.
#  include_next <CGAL/STL_Extension/internal/parameters_interface.h>

#else

#  define CGAL_AHR_INSIDE_PARAMETERS_INTERFACE
// A quoted path, which CMake sets for compilers without #include_next.
#  ifdef CGAL_AHR_ORIGINAL_PARAMETERS_INTERFACE
#    include CGAL_AHR_ORIGINAL_PARAMETERS_INTERFACE
#  else
#    include_next <CGAL/STL_Extension/internal/parameters_interface.h>
#  endif
#  undef CGAL_AHR_INSIDE_PARAMETERS_INTERFACE

// List of named parameters that we use in the package 'Anisotropic_hde_remeshing'
CGAL_add_named_parameter(sigma_t, sigma, sigma)
CGAL_add_named_parameter(embedding_t, embedding, embedding)
CGAL_add_named_parameter(relative_sigma_t, relative_sigma, relative_sigma)
CGAL_add_named_parameter(target_edge_length_t, target_edge_length, target_edge_length)
CGAL_add_named_parameter(relative_target_edge_length_t, relative_target_edge_length, relative_target_edge_length)
CGAL_add_named_parameter(number_of_target_faces_t, number_of_target_faces, number_of_target_faces)
CGAL_add_named_parameter(smoothing_ratio_t, smoothing_ratio, smoothing_ratio)
CGAL_add_named_parameter(collapse_ratio_t, collapse_ratio, collapse_ratio)
CGAL_add_named_parameter(split_ratio_t, split_ratio, split_ratio)
CGAL_add_named_parameter(remeshing_scheme_t, remeshing_scheme, remeshing_scheme)
CGAL_add_named_parameter(fit_to_surface_t, fit_to_surface, fit_to_surface)
CGAL_add_named_parameter(approximation_error_t, approximation_error, approximation_error)
CGAL_add_named_parameter(relative_approximation_error_t, relative_approximation_error, relative_approximation_error)
CGAL_add_named_parameter(vertex_location_map_t, vertex_location_map, vertex_location_map)
CGAL_add_named_parameter(sharp_angle_t, sharp_angle, sharp_angle)

// List of named parameters used by the class 'Rbf_implicit_function'
CGAL_add_named_parameter(radial_function_t, radial_function, radial_function)
CGAL_add_named_parameter(number_of_patches_t, number_of_patches, number_of_patches)
CGAL_add_named_parameter(patch_overlap_t, patch_overlap, patch_overlap)
CGAL_add_named_parameter(offset_distance_t, offset_distance, offset_distance)
CGAL_add_named_parameter(relative_offset_distance_t, relative_offset_distance, relative_offset_distance)
CGAL_add_named_parameter(two_sided_offsets_t, two_sided_offsets, two_sided_offsets)
CGAL_add_named_parameter(smoothing_t, smoothing, smoothing)

// tells the headers of this package that these names exist
#  ifndef CGAL_AHR_NAMED_PARAMETERS_OVERLAY
#    define CGAL_AHR_NAMED_PARAMETERS_OVERLAY 1
#  endif

#endif // CGAL_AHR_INSIDE_PARAMETERS_INTERFACE
