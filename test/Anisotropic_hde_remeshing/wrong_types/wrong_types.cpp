// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Calls with arguments of wrong types, which must not compile: test_wrong_types.sh wants one error for each of the lines that end
// with a message, with this message, and none besides.

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Interpolated_vertex_field.h>
#include <CGAL/Anisotropic_hde_remeshing/Scalar_field_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/alignment_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/approximation_bounds.h>
#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/make_implicit_function.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/transfer_edge_property.h>
#include <CGAL/Anisotropic_hde_remeshing/transfer_face_property.h>
#include <CGAL/Anisotropic_hde_remeshing/transfer_vertex_property.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/anisotropic_hde_remeshing.h>
#include <CGAL/rbf_surface_reconstruction.h>

#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Rbf_implicit_function<Kernel> Function;
typedef CGAL::Piecewise_rbf_implicit_function<Kernel> Piecewise_function;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
using namespace CGAL::Anisotropic_hde_remeshing::parameters;

struct Sphere_function
{
  typedef Kernel::Point_3 Point_3;
  double operator()(const Point_3& p) const { return p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - 1; }
  Kernel::Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
};

double value_of_sphere(const Point_3& p) { return Sphere_function()(p); }

struct Without_gradient
{
  typedef Kernel::Point_3 Point_3;
  double operator()(const Point_3&) const { return 0; }
};

struct Without_second_derivative
{
  static constexpr unsigned int order = 1;
  static constexpr double sign = -1;
  static const char* name() { return "r^2"; }
  template <typename T>
  CGAL::Rbf_jet<T, 1> operator()(const T& squared_radius) const
  {
    return {squared_radius, T(2. + 0. * squared_radius)};
  }
};

Mesh mesh;
const Mesh const_mesh;
const Sphere_function sphere;
const std::vector<Mesh::Face_index> some_faces;
Mesh::Property_map<Mesh::Vertex_index, double> of_vertices;
Mesh::Property_map<Mesh::Edge_index, bool> of_edges;
Mesh::Property_map<Mesh::Face_index, std::size_t> of_faces;

template <typename Parameters>
void remesh(const Parameters& parameters)
{
  CGAL::anisotropic_hde_remeshing(mesh, sphere, parameters);
}

// clang-format off
void remeshing()
{
  remesh(sigma("0.02")); // the named parameter sigma takes a number
  remesh(relative_sigma(std::string())); // the named parameter relative_sigma takes a number
  remesh(embedding(2.0)); // the named parameter embedding takes a model of RemeshingEmbedding
  remesh(sizing_field("fine")); // the named parameter sizing_field takes a function of a point, a property map from the vertices of the mesh to numbers, or a model of PMPSizingField
  remesh(sizing_field([](const Mesh&) { return 1.; })); // the named parameter sizing_field takes a function of a point, a property map from the vertices of the mesh to numbers, or a model of PMPSizingField
  remesh(sizing_field(of_edges)); // the named parameter sizing_field takes a function of a point, a property map from the vertices of the mesh to numbers, or a model of PMPSizingField
  remesh(sizing_field(of_vertices).gradation("slow")); // the named parameter gradation takes a number
  remesh(target_edge_length(true)); // the named parameter target_edge_length takes a number
  remesh(relative_target_edge_length(&mesh)); // the named parameter relative_target_edge_length takes a number
  remesh(number_of_target_faces("many")); // the named parameter number_of_target_faces takes an integer
  remesh(approximation_error("1e-3")); // the named parameter approximation_error takes a number
  remesh(relative_approximation_error(mesh)); // the named parameter relative_approximation_error takes a number
  remesh(fit_to_surface("yes")); // the named parameter fit_to_surface takes a Boolean
  remesh(shape_weight("2")); // the named parameter shape_weight takes a number
  remesh(aspect_ratio_bound("2")); // the named parameter aspect_ratio_bound takes a number
  remesh(project_borders("yes")); // the named parameter project_borders takes a Boolean
  remesh(number_of_iterations(mesh)); // the named parameter number_of_iterations takes an integer
  remesh(number_of_relaxation_steps("3")); // the named parameter number_of_relaxation_steps takes an integer
  remesh(remeshing_scheme("paper")); // the named parameter remeshing_scheme takes a Remeshing_scheme, DEFAULT or PAPER
  remesh(split_ratio("4/3")); // the named parameter split_ratio takes a number
  remesh(collapse_ratio("4/5")); // the named parameter collapse_ratio takes a number
  remesh(smoothing_ratio("1")); // the named parameter smoothing_ratio takes a number
  remesh(edge_is_constrained_map(true)); // the named parameter edge_is_constrained_map takes a readable and writable property map from the edges of the mesh to bool
  remesh(vertex_is_constrained_map(of_edges)); // the named parameter vertex_is_constrained_map takes a property map from the vertices of the mesh to bool
  remesh(face_patch_map(3)); // the named parameter face_patch_map takes a readable and writable property map from the faces of the mesh
  remesh(protect_constraints(0.5)); // the named parameter protect_constraints takes a Boolean
  remesh(collapse_constraints(0.5)); // the named parameter collapse_constraints takes a Boolean
  remesh(relax_constraints("yes")); // the named parameter relax_constraints takes a Boolean
  remesh(do_split(2.5)); // the named parameter do_split takes a Boolean
  remesh(do_collapse(2.5)); // the named parameter do_collapse takes a Boolean
  remesh(do_flip(2.5)); // the named parameter do_flip takes a Boolean
  remesh(CGAL::parameters::do_project(false)); // the named parameter do_project is not for this function
  remesh(CGAL::parameters::projection_functor(sphere)); // the named parameter projection_functor is not for this function
  remesh(do_self_intersection_tests("no")); // the named parameter do_self_intersection_tests takes a Boolean
  remesh(vertex_location_map(of_vertices)); // the named parameter vertex_location_map takes a writable property map from the vertices of the mesh to Input_location
  remesh(visitor(1.5)); // the named parameter visitor takes a model of RemeshingVisitor
  remesh(vertex_point_map(of_vertices)); // the named parameter vertex_point_map takes a readable and writable property map from the vertices of the mesh to points
  remesh(number_of_iterations(3).sigma("0.2").fit_to_surface(true)); // the named parameter sigma takes a number
  CGAL::anisotropic_hde_remeshing(mesh, sphere, 3); // the last argument must be named parameters
  CGAL::anisotropic_hde_remeshing(mesh, 3); // the function must be a model of ImplicitFunctionWithGradient
  CGAL::anisotropic_hde_remeshing(mesh, Without_gradient()); // the function must be a model of ImplicitFunctionWithGradient
  CGAL::anisotropic_hde_remeshing(const_mesh, sphere); // the mesh is remeshed in place: it must not be const
  Without_gradient no_mesh;
  CGAL::anisotropic_hde_remeshing(no_mesh, sphere); // the mesh must be a model of FaceListGraph
  CGAL::anisotropic_hde_remeshing(std::vector<double>(), mesh, sphere); // the range must be one of faces of the mesh
  CGAL::anisotropic_hde_remeshing(some_faces, mesh, 3.5f); // the function must be a model of ImplicitFunctionWithGradient
  CGAL::anisotropic_hde_remeshing(some_faces, mesh, sphere, sigma("0.2")); // the named parameter sigma takes a number
  CGAL::anisotropic_hde_remeshing(mesh, sharp_angle("forty")); // the named parameter sharp_angle takes a number
  CGAL::anisotropic_hde_remeshing(mesh, embedding(3)); // the named parameter embedding takes a model of RemeshingEmbedding
  CGAL::anisotropic_hde_remeshing(some_faces, mesh, number_of_patches("99")); // the named parameter number_of_patches takes an integer
}

void functions()
{
  Function a(mesh, number_of_patches("9")); // the named parameter number_of_patches takes an integer
  Function b(mesh, patch_overlap("2")); // the named parameter patch_overlap takes a number
  Function c(mesh, offset_distance("2")); // the named parameter offset_distance takes a number
  Function d(mesh, relative_offset_distance("2")); // the named parameter relative_offset_distance takes a number
  Function e(mesh, two_sided_offsets("yes")); // the named parameter two_sided_offsets takes a Boolean
  Function q(mesh, points_on_facets("yes")); // the named parameter points_on_facets takes a Boolean
  Function r(mesh, detect_edges("yes")); // the named parameter detect_edges takes a Boolean
  Function f(mesh, smoothing("no")); // the named parameter smoothing takes a number or AUTOMATIC_SMOOTHING
  Function g(mesh, radial_function(CGAL::Gaussian_rbf())); // the named parameter radial_function takes an object of the second template argument
  Function h(mesh, visitor(2)); // the named parameter visitor takes a model of RemeshingVisitor
  Function i(mesh, vertex_point_map(of_edges)); // the named parameter vertex_point_map takes a property map from the vertices of the mesh to points
  Function j(mesh, vertex_normal_map(of_vertices)); // the named parameter vertex_normal_map takes a property map from the vertices of the mesh to vectors
  Function k(std::vector<Point_3>(), point_map(1)); // the named parameter point_map takes a property map from the elements of the range to points
  Function l(std::vector<Point_3>(), point_map(CGAL::Identity_property_map<Point_3>()).normal_map(1)); // the named parameter normal_map takes a property map from the elements of the range to vectors
  Function s(std::vector<std::pair<Point_3, Kernel::Vector_3>>(), detect_outliers("yes")); // the named parameter detect_outliers takes a Boolean
  Function t(mesh, close_holes("yes")); // the named parameter close_holes takes a Boolean
  Function m(std::vector<Point_3>{}); // a range of points needs point_map and normal_map, unless its elements are pairs
  Function n(3); // the implicit function is built from a model of FaceListGraph or from a range of points with normals
  CGAL::Rbf_implicit_function<Kernel, Without_second_derivative>(mesh).hessian(CGAL::ORIGIN); // second derivatives of the function need a radial function that returns them
  Piecewise_function o(mesh, 3); // face_region must be a property map from the faces of the mesh to std::size_t
  Piecewise_function p(mesh, of_faces, smoothing("yes")); // the named parameter smoothing takes a number or AUTOMATIC_SMOOTHING
  CGAL::anisotropic_hde_remeshing(mesh, radial_function(3)); // the named parameter radial_function takes a model of RadialBasisFunction
  Hde::detect_surface_regions(mesh, of_edges, of_faces, sharp_angle("40")); // the named parameter sharp_angle takes a number
  Hde::detect_surface_regions(mesh, of_edges, of_faces, edge_is_constrained_map(2)); // the named parameter edge_is_constrained_map takes a property map from the edges of the mesh to bool
  Hde::detect_surface_regions(mesh, of_edges, of_faces, face_patch_map(2)); // the named parameter face_patch_map takes a property map from the faces of the mesh
  Hde::detect_surface_regions(mesh, of_edges, of_faces, geom_traits(2)); // the named parameter geom_traits takes a kernel
  Hde::detect_surface_regions(mesh, of_faces, of_faces); // edge_is_crease must be a writable property map from the edges of the mesh to bool
  Hde::detect_surface_regions(mesh, of_edges, of_vertices); // face_region must be a writable property map from the faces of the mesh to std::size_t
  Hde::make_implicit_function([](const auto& p) { return p.x(); }); // the function must take one point of a kernel by a call operator that is const and no template
  Hde::make_implicit_function([n = 0](const Point_3& p) mutable { return p.x() + ++n; }); // the function must take one point of a kernel by a call operator that is const and no template
  Hde::make_implicit_function<Kernel>([](const std::string&) { return 1.; }); // the function must take a point of the kernel and be callable when const
  Hde::make_implicit_function([](const Point_3& p) { return p; }); // the function must return a number
  Hde::make_implicit_function(&value_of_sphere, [](const Point_3& p) { return p.x(); }); // the gradient must take a point of the kernel and return a vector of it
  Hde::scalar_field_embedding<Point_3>(1, 1, 3); // the field must be a function object that takes a point
}

void reconstructions()
{
  const std::vector<std::pair<Point_3, Kernel::Vector_3>> points;
  CGAL::rbf_surface_reconstruction(points, mesh, facet_angle("25")); // the named parameter facet_angle takes a number
  CGAL::rbf_surface_reconstruction(points, mesh, facet_size(mesh)); // the named parameter facet_size takes a number
  CGAL::rbf_surface_reconstruction(points, mesh, facet_distance("1")); // the named parameter facet_distance takes a number
  CGAL::rbf_surface_reconstruction(points, mesh, number_of_target_faces("9")); // the named parameter number_of_target_faces takes an integer
  CGAL::rbf_surface_reconstruction(points, mesh, detect_outliers(2.5)); // the named parameter detect_outliers takes a Boolean
  CGAL::rbf_surface_reconstruction(points, mesh, 3); // the last argument must be named parameters
  CGAL::rbf_surface_reconstruction(mesh, mesh); // the surface is made of a range of points with normals
  CGAL::rbf_surface_reconstruction(std::vector<Kernel::Vector_3>(), mesh); // a range of points needs point_map and normal_map, unless its elements are pairs
}

void measures()
{
  Hde::measure_topology(3); // the mesh must be a model of FaceListGraph
  Hde::measure_shape(mesh, vertex_point_map(3)); // the named parameter vertex_point_map takes a property map from the vertices of the mesh to points
  Hde::measure_embedding(mesh, sphere, sigma("3")); // the named parameter sigma takes a number
  Hde::measure_embedding(mesh, sphere, target_edge_length("3")); // the named parameter target_edge_length takes a number
  Hde::measure_alignment(mesh, 3L); // the function must be a model of ImplicitFunctionWithGradient
  Hde::approximation_bounds(mesh, sphere, geom_traits("epick")); // the named parameter geom_traits takes a kernel
  Hde::measure_distance(mesh, mesh, number_of_points_on_faces("all")); // the named parameter number_of_points_on_faces takes an integer
  Hde::measure_distance_to_zero_set(mesh, sphere, number_of_points_on_faces(mesh)); // the named parameter number_of_points_on_faces takes an integer
  Hde::Interpolated_vertex_field field(mesh, of_edges); // values must be a property map from the vertices of the mesh to numbers
  Hde::transfer_vertex_property(mesh, of_vertices, mesh, of_vertices, of_vertices); // vertex_location must be a property map from the vertices of the output to Input_location
  Hde::transfer_face_property(mesh, of_vertices, mesh, of_faces); // input_property must be a property map with the faces of the input as keys
  Hde::transfer_edge_property(mesh, of_edges, of_edges, mesh, of_faces, of_edges); // input_is_marked and output_is_marked must be property maps from the edges of the meshes to bool
}
// clang-format on
