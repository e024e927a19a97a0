// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The public headers of CGAL's packages Polygon_mesh_processing, BGL, Surface_mesh_simplification and Mesh_3, of any version from 5.5 to
// 6.2, as far as they exist. Left out are those that need libraries the tests do not have, and those that do not compile alone.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_HEADERS_OF_CGAL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_HEADERS_OF_CGAL_H

#define CGAL_NO_DEPRECATION_WARNINGS // some are old

// clang-format off
#if __has_include(<CGAL/Mesh_cell_base_3.h>)
#  include <CGAL/Mesh_cell_base_3.h>
#endif
#if __has_include(<CGAL/Mesh_cell_criteria_3.h>)
#  include <CGAL/Mesh_cell_criteria_3.h>
#endif
#if __has_include(<CGAL/Mesh_complex_3_in_triangulation_3.h>)
#  include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#endif
#if __has_include(<CGAL/Mesh_constant_domain_field_3.h>)
#  include <CGAL/Mesh_constant_domain_field_3.h>
#endif
#if __has_include(<CGAL/Mesh_criteria_3.h>)
#  include <CGAL/Mesh_criteria_3.h>
#endif
#if __has_include(<CGAL/Mesh_domain_with_polyline_features_3.h>)
#  include <CGAL/Mesh_domain_with_polyline_features_3.h>
#endif
#if __has_include(<CGAL/Mesh_edge_criteria_3.h>)
#  include <CGAL/Mesh_edge_criteria_3.h>
#endif
#if __has_include(<CGAL/Mesh_error_code.h>)
#  include <CGAL/Mesh_error_code.h>
#endif
#if __has_include(<CGAL/Mesh_facet_criteria_3.h>)
#  include <CGAL/Mesh_facet_criteria_3.h>
#endif
#if __has_include(<CGAL/Mesh_facet_topology.h>)
#  include <CGAL/Mesh_facet_topology.h>
#endif
#if __has_include(<CGAL/Mesh_optimization_return_code.h>)
#  include <CGAL/Mesh_optimization_return_code.h>
#endif
#if __has_include(<CGAL/Mesh_polyhedron_3.h>)
#  include <CGAL/Mesh_polyhedron_3.h>
#endif
#if __has_include(<CGAL/Mesh_triangulation_3.h>)
#  include <CGAL/Mesh_triangulation_3.h>
#endif
#if __has_include(<CGAL/Mesh_vertex_base_3.h>)
#  include <CGAL/Mesh_vertex_base_3.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>)
#  include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/Non_manifold_feature_map.h>)
#  include <CGAL/Polygon_mesh_processing/Non_manifold_feature_map.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/Uniform_sizing_field.h>)
#  include <CGAL/Polygon_mesh_processing/Uniform_sizing_field.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/angle_and_area_smoothing.h>)
#  include <CGAL/Polygon_mesh_processing/angle_and_area_smoothing.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>)
#  include <CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/autorefinement.h>)
#  include <CGAL/Polygon_mesh_processing/autorefinement.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/bbox.h>)
#  include <CGAL/Polygon_mesh_processing/bbox.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/border.h>)
#  include <CGAL/Polygon_mesh_processing/border.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/clip.h>)
#  include <CGAL/Polygon_mesh_processing/clip.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/compute_normal.h>)
#  include <CGAL/Polygon_mesh_processing/compute_normal.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/connected_components.h>)
#  include <CGAL/Polygon_mesh_processing/connected_components.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/corefinement.h>)
#  include <CGAL/Polygon_mesh_processing/corefinement.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/curvature.h>)
#  include <CGAL/Polygon_mesh_processing/curvature.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/detect_features.h>)
#  include <CGAL/Polygon_mesh_processing/detect_features.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/distance.h>)
#  include <CGAL/Polygon_mesh_processing/distance.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/extrude.h>)
#  include <CGAL/Polygon_mesh_processing/extrude.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/fair.h>)
#  include <CGAL/Polygon_mesh_processing/fair.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
#  include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/intersection.h>)
#  include <CGAL/Polygon_mesh_processing/intersection.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/intersection_polylines.h>)
#  include <CGAL/Polygon_mesh_processing/intersection_polylines.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/kernel.h>)
#  include <CGAL/Polygon_mesh_processing/kernel.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/locate.h>)
#  include <CGAL/Polygon_mesh_processing/locate.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/manifoldness.h>)
#  include <CGAL/Polygon_mesh_processing/manifoldness.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/measure.h>)
#  include <CGAL/Polygon_mesh_processing/measure.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/merge_border_vertices.h>)
#  include <CGAL/Polygon_mesh_processing/merge_border_vertices.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/orient_polygon_soup.h>)
#  include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/orient_polygon_soup_extension.h>)
#  include <CGAL/Polygon_mesh_processing/orient_polygon_soup_extension.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/orientation.h>)
#  include <CGAL/Polygon_mesh_processing/orientation.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>)
#  include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/polygon_soup_self_intersections.h>)
#  include <CGAL/Polygon_mesh_processing/polygon_soup_self_intersections.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>)
#  include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/random_perturbation.h>)
#  include <CGAL/Polygon_mesh_processing/random_perturbation.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/refine.h>)
#  include <CGAL/Polygon_mesh_processing/refine.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/refine_mesh_at_isolevel.h>)
#  include <CGAL/Polygon_mesh_processing/refine_mesh_at_isolevel.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/refine_with_plane.h>)
#  include <CGAL/Polygon_mesh_processing/refine_with_plane.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/region_growing.h>)
#  include <CGAL/Polygon_mesh_processing/region_growing.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/remesh.h>)
#  include <CGAL/Polygon_mesh_processing/remesh.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/remesh_planar_patches.h>)
#  include <CGAL/Polygon_mesh_processing/remesh_planar_patches.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/repair.h>)
#  include <CGAL/Polygon_mesh_processing/repair.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/repair_degeneracies.h>)
#  include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/repair_polygon_soup.h>)
#  include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/repair_self_intersections.h>)
#  include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/self_intersection_polylines.h>)
#  include <CGAL/Polygon_mesh_processing/self_intersection_polylines.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/self_intersections.h>)
#  include <CGAL/Polygon_mesh_processing/self_intersections.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/shape_predicates.h>)
#  include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/smooth_mesh.h>)
#  include <CGAL/Polygon_mesh_processing/smooth_mesh.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/smooth_shape.h>)
#  include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/stitch_borders.h>)
#  include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>)
#  include <CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/tangential_relaxation.h>)
#  include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/transform.h>)
#  include <CGAL/Polygon_mesh_processing/transform.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/triangle.h>)
#  include <CGAL/Polygon_mesh_processing/triangle.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/triangulate_faces.h>)
#  include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#endif
#if __has_include(<CGAL/Polygon_mesh_processing/triangulate_hole.h>)
#  include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>)
#  include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_distance_placement.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_distance_placement.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_ratio_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_ratio_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_profile.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_profile.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Face_count_ratio_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Face_count_ratio_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Face_count_stop_predicate.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Face_count_stop_predicate.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_and_line_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_and_line_policies.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_plane_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_plane_policies.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_triangle_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_triangle_policies.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_triangle_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_triangle_policies.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Polyhedral_envelope_filter.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Polyhedral_envelope_filter.h>
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/edge_collapse.h>)
#  include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#endif
#if __has_include(<CGAL/boost/graph/Alpha_expansion_MaxFlow_tag.h>)
#  include <CGAL/boost/graph/Alpha_expansion_MaxFlow_tag.h>
#endif
#if __has_include(<CGAL/boost/graph/Dual.h>)
#  include <CGAL/boost/graph/Dual.h>
#endif
#if __has_include(<CGAL/boost/graph/Euler_operations.h>)
#  include <CGAL/boost/graph/Euler_operations.h>
#endif
#if __has_include(<CGAL/boost/graph/Face_filtered_graph.h>)
#  include <CGAL/boost/graph/Face_filtered_graph.h>
#endif
#if __has_include(<CGAL/boost/graph/Graph_with_descriptor_with_graph.h>)
#  include <CGAL/boost/graph/Graph_with_descriptor_with_graph.h>
#endif
#if __has_include(<CGAL/boost/graph/Graph_with_descriptor_with_graph_fwd.h>)
#  include <CGAL/boost/graph/Graph_with_descriptor_with_graph_fwd.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/3MF.h>)
#  include <CGAL/boost/graph/IO/3MF.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/GOCAD.h>)
#  include <CGAL/boost/graph/IO/GOCAD.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/Generic_facegraph_builder.h>)
#  include <CGAL/boost/graph/IO/Generic_facegraph_builder.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/Generic_facegraph_printer.h>)
#  include <CGAL/boost/graph/IO/Generic_facegraph_printer.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/INP.h>)
#  include <CGAL/boost/graph/IO/INP.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/OBJ.h>)
#  include <CGAL/boost/graph/IO/OBJ.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/OFF.h>)
#  include <CGAL/boost/graph/IO/OFF.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/OM.h>)
#  include <CGAL/boost/graph/IO/OM.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/PLY.h>)
#  include <CGAL/boost/graph/IO/PLY.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/STL.h>)
#  include <CGAL/boost/graph/IO/STL.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/Tds_2_off.h>)
#  include <CGAL/boost/graph/IO/Tds_2_off.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/VTK.h>)
#  include <CGAL/boost/graph/IO/VTK.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/WRL.h>)
#  include <CGAL/boost/graph/IO/WRL.h>
#endif
#if __has_include(<CGAL/boost/graph/IO/polygon_mesh_io.h>)
#  include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#endif
#if __has_include(<CGAL/boost/graph/Seam_mesh.h>)
#  include <CGAL/boost/graph/Seam_mesh.h>
#endif
#if __has_include(<CGAL/boost/graph/alpha_expansion_graphcut.h>)
#  include <CGAL/boost/graph/alpha_expansion_graphcut.h>
#endif
#if __has_include(<CGAL/boost/graph/backward_compatibility_functions.h>)
#  include <CGAL/boost/graph/backward_compatibility_functions.h>
#endif
#if __has_include(<CGAL/boost/graph/border.h>)
#  include <CGAL/boost/graph/border.h>
#endif
#if __has_include(<CGAL/boost/graph/breadth_first_search.h>)
#  include <CGAL/boost/graph/breadth_first_search.h>
#endif
#if __has_include(<CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>)
#  include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#endif
#if __has_include(<CGAL/boost/graph/copy_face_graph.h>)
#  include <CGAL/boost/graph/copy_face_graph.h>
#endif
#if __has_include(<CGAL/boost/graph/dijkstra_shortest_path.h>)
#  include <CGAL/boost/graph/dijkstra_shortest_path.h>
#endif
#if __has_include(<CGAL/boost/graph/dijkstra_shortest_paths.h>)
#  include <CGAL/boost/graph/dijkstra_shortest_paths.h>
#endif
#if __has_include(<CGAL/boost/graph/generators.h>)
#  include <CGAL/boost/graph/generators.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Arrangement_2.h>)
#  include <CGAL/boost/graph/graph_traits_Arrangement_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Constrained_Delaunay_triangulation_2.h>)
#  include <CGAL/boost/graph/graph_traits_Constrained_Delaunay_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Constrained_triangulation_2.h>)
#  include <CGAL/boost/graph/graph_traits_Constrained_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Constrained_triangulation_plus_2.h>)
#  include <CGAL/boost/graph/graph_traits_Constrained_triangulation_plus_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Delaunay_triangulation_2.h>)
#  include <CGAL/boost/graph/graph_traits_Delaunay_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Dual_Arrangement_2.h>)
#  include <CGAL/boost/graph/graph_traits_Dual_Arrangement_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_HalfedgeDS.h>)
#  include <CGAL/boost/graph/graph_traits_HalfedgeDS.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_HalfedgeDS_default.h>)
#  include <CGAL/boost/graph/graph_traits_HalfedgeDS_default.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>)
#  include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Polyhedron_3.h>)
#  include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Regular_triangulation_2.h>)
#  include <CGAL/boost/graph/graph_traits_Regular_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Seam_mesh.h>)
#  include <CGAL/boost/graph/graph_traits_Seam_mesh.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Surface_mesh.h>)
#  include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Triangulation_2.h>)
#  include <CGAL/boost/graph/graph_traits_Triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Triangulation_data_structure_2.h>)
#  include <CGAL/boost/graph/graph_traits_Triangulation_data_structure_2.h>
#endif
#if __has_include(<CGAL/boost/graph/graph_traits_Triangulation_hierarchy_2.h>)
#  include <CGAL/boost/graph/graph_traits_Triangulation_hierarchy_2.h>
#endif
#if __has_include(<CGAL/boost/graph/helpers.h>)
#  include <CGAL/boost/graph/helpers.h>
#endif
#if __has_include(<CGAL/boost/graph/io.h>)
#  include <CGAL/boost/graph/io.h>
#endif
#if __has_include(<CGAL/boost/graph/iterator.h>)
#  include <CGAL/boost/graph/iterator.h>
#endif
#if __has_include(<CGAL/boost/graph/kruskal_min_spanning_tree.h>)
#  include <CGAL/boost/graph/kruskal_min_spanning_tree.h>
#endif
#if __has_include(<CGAL/boost/graph/named_params_helper.h>)
#  include <CGAL/boost/graph/named_params_helper.h>
#endif
#if __has_include(<CGAL/boost/graph/prim_minimum_spanning_tree.h>)
#  include <CGAL/boost/graph/prim_minimum_spanning_tree.h>
#endif
#if __has_include(<CGAL/boost/graph/properties.h>)
#  include <CGAL/boost/graph/properties.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Constrained_Delaunay_triangulation_2.h>)
#  include <CGAL/boost/graph/properties_Constrained_Delaunay_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Constrained_triangulation_2.h>)
#  include <CGAL/boost/graph/properties_Constrained_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Constrained_triangulation_plus_2.h>)
#  include <CGAL/boost/graph/properties_Constrained_triangulation_plus_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Delaunay_triangulation_2.h>)
#  include <CGAL/boost/graph/properties_Delaunay_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_HalfedgeDS_default.h>)
#  include <CGAL/boost/graph/properties_HalfedgeDS_default.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Linear_cell_complex_for_combinatorial_map.h>)
#  include <CGAL/boost/graph/properties_Linear_cell_complex_for_combinatorial_map.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Polyhedron_3.h>)
#  include <CGAL/boost/graph/properties_Polyhedron_3.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Polyhedron_3_features.h>)
#  include <CGAL/boost/graph/properties_Polyhedron_3_features.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Polyhedron_3_time_stamp.h>)
#  include <CGAL/boost/graph/properties_Polyhedron_3_time_stamp.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Regular_triangulation_2.h>)
#  include <CGAL/boost/graph/properties_Regular_triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Seam_mesh.h>)
#  include <CGAL/boost/graph/properties_Seam_mesh.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Surface_mesh.h>)
#  include <CGAL/boost/graph/properties_Surface_mesh.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Surface_mesh_features.h>)
#  include <CGAL/boost/graph/properties_Surface_mesh_features.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Surface_mesh_time_stamp.h>)
#  include <CGAL/boost/graph/properties_Surface_mesh_time_stamp.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Triangulation_2.h>)
#  include <CGAL/boost/graph/properties_Triangulation_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Triangulation_data_structure_2.h>)
#  include <CGAL/boost/graph/properties_Triangulation_data_structure_2.h>
#endif
#if __has_include(<CGAL/boost/graph/properties_Triangulation_hierarchy_2.h>)
#  include <CGAL/boost/graph/properties_Triangulation_hierarchy_2.h>
#endif
#if __has_include(<CGAL/boost/graph/property_maps.h>)
#  include <CGAL/boost/graph/property_maps.h>
#endif
#if __has_include(<CGAL/boost/graph/selection.h>)
#  include <CGAL/boost/graph/selection.h>
#endif
#if __has_include(<CGAL/boost/graph/split_graph_into_polylines.h>)
#  include <CGAL/boost/graph/split_graph_into_polylines.h>
#endif
#if __has_include(<CGAL/lloyd_optimize_mesh_3.h>)
#  include <CGAL/lloyd_optimize_mesh_3.h>
#endif
#if __has_include(<CGAL/make_mesh_3.h>)
#  include <CGAL/make_mesh_3.h>
#endif
#if __has_include(<CGAL/odt_optimize_mesh_3.h>)
#  include <CGAL/odt_optimize_mesh_3.h>
#endif
#if __has_include(<CGAL/optimize_mesh_3.h>)
#  include <CGAL/optimize_mesh_3.h>
#endif
#if __has_include(<CGAL/perturb_mesh_3.h>)
#  include <CGAL/perturb_mesh_3.h>
#endif
#if __has_include(<CGAL/refine_mesh_3.h>)
#  include <CGAL/refine_mesh_3.h>
#endif
#if __has_include(<CGAL/remove_far_points_in_mesh_3.h>)
#  include <CGAL/remove_far_points_in_mesh_3.h>
#endif
// clang-format on

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_HEADERS_OF_CGAL_H
