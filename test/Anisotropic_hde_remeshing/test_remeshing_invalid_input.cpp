// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What anisotropic_hde_remeshing() refuses, and what it leaves behind when it is stopped or its function fails: the mesh as
// it was, or a valid one.

#include "remeshing_checks.h"

#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

// the message of the refusal; the mesh must be as it was
template <typename NamedParameters>
std::string message_of(const Mesh& input, const NamedParameters& np)
{
  Mesh mesh = input;
  const std::string message =
      invalid_argument_message([&] { CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function(), np); });
  CHECK(digest(mesh) == digest(input));
  return message;
}

// the same of the call that builds the function itself
template <typename NamedParameters>
std::string message_of_one_call(const Mesh& input, const NamedParameters& np)
{
  Mesh mesh = input;
  const std::string message = invalid_argument_message([&] { CGAL::anisotropic_hde_remeshing<Tag>(mesh, np); });
  CHECK(digest(mesh) == digest(input));
  return message;
}

void test_invalid_meshes()
{
  const auto none = CGAL::parameters::default_values();
  CHECK(!message_of(Mesh(), none).empty());
  CHECK(!message_of_one_call(Mesh(), none).empty());
  Mesh only_isolated;
  only_isolated.add_vertex(Point_3(0, 0, 0));
  CHECK(!message_of(only_isolated, none).empty());

  Mesh cube;
  CGAL::make_hexahedron(Point_3(-1, -1, -1), Point_3(1, -1, -1), Point_3(1, 1, -1), Point_3(-1, 1, -1), Point_3(-1, 1, 1),
                        Point_3(-1, -1, 1), Point_3(1, -1, 1), Point_3(1, 1, 1), cube);
  CHECK(contains(message_of(cube, none), "not a triangle"));
  CHECK(contains(message_of_one_call(cube, none), "not a triangle"));

  for (const double bad : {nan_value, infinity, -infinity})
    for (int coordinate = 0; coordinate < 3; ++coordinate)
    {
      Mesh mesh = icosphere(1);
      double p[3] = {0, 0, 0};
      p[coordinate] = bad;
      mesh.point(Mesh::Vertex_index(17)) = Point_3(p[0], p[1], p[2]);
      CHECK(contains(message_of(mesh, none), "vertex 17"));
      CHECK(contains(message_of_one_call(mesh, none), "vertex 17"));
    }

  // two faces that share nothing but a vertex
  Mesh cones;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(-1, 0, 0), Point_3(0, -1, 0)})
    cones.add_vertex(p);
  for (const Mesh::size_type i : {1, 3})
    CHECK(cones.add_face(Mesh::Vertex_index(0), Mesh::Vertex_index(i), Mesh::Vertex_index(i + 1)) != Mesh::null_face());
  CHECK(contains(message_of(cones, none), "vertex 0 is not manifold"));

  Mesh in_one_point;
  CGAL::make_triangle(Point_3(1, 0, 0), Point_3(1, 0, 0), Point_3(1, 0, 0), in_one_point);
  CHECK(!message_of(in_one_point, none).empty());
  CHECK(!message_of_one_call(in_one_point, none).empty());
}

// Valid meshes of bad geometry: the result has the topology of the input, finite points and faces that are not worse.
void test_bad_geometry()
{
  const auto check = [](const std::string& name, const Mesh& input)
  {
    for (const double factor : {0.5, 2.})
    {
      Mesh mesh = input;
      CGAL::anisotropic_hde_remeshing<Tag>(
          mesh, params::number_of_target_faces(std::size_t(factor * double(input.number_of_faces()))));
      CHECK(CGAL::is_valid_polygon_mesh(mesh));
      CHECK(CGAL::is_triangle_mesh(mesh));
      const Hde::Topology_measures before = Hde::measure_topology(input), after = Hde::measure_topology(mesh);
      CHECK(after.number_of_components == before.number_of_components);
      CHECK(after.number_of_boundary_loops == before.number_of_boundary_loops);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(Hde::measure_shape(mesh).number_of_degenerate_faces <= Hde::measure_shape(input).number_of_degenerate_faces);
      bool is_finite = true;
      for (const Mesh::Vertex_index v : mesh.vertices())
        for (int i = 0; i < 3; ++i)
          is_finite = is_finite && std::isfinite(mesh.point(v)[i]);
      CHECK(is_finite);
      std::cout << name << ": " << input.number_of_faces() << " -> " << mesh.number_of_faces() << std::endl;
    }
  };

  // collapsed faces, and hence equal points
  Mesh degenerate = ellipsoid(3);
  for (int i = 0; i < 40; ++i)
  {
    const Mesh::Halfedge_index h(static_cast<Mesh::size_type>(37 * i));
    degenerate.point(degenerate.source(h)) = degenerate.point(degenerate.target(h));
  }
  CHECK(Hde::measure_shape(degenerate).number_of_degenerate_faces >= 40);
  check("degenerate faces", degenerate);

  // the same sphere twice: equal points and faces; the function sees both
  Soup twice = icosphere_soup(3);
  const std::size_t n = twice.points.size(), number_of_triangles = twice.triangles.size();
  twice.points.insert(twice.points.end(), twice.points.begin(), twice.points.begin() + std::ptrdiff_t(n));
  for (std::size_t i = 0; i < number_of_triangles; ++i)
    twice.triangles.push_back({n + twice.triangles[i][0], n + twice.triangles[i][1], n + twice.triangles[i][2]});
  check("duplicate faces", to_mesh(twice));

  // spheres that intersect each other
  Soup crossing = icosphere_soup(3);
  for (std::size_t i = 0; i < n; ++i)
    crossing.points.push_back(crossing.points[i] + Vector_3(0.9, 0, 0));
  for (std::size_t i = 0; i < number_of_triangles; ++i)
    crossing.triangles.push_back({n + crossing.triangles[i][0], n + crossing.triangles[i][1], n + crossing.triangles[i][2]});
  check("self-intersections", to_mesh(crossing));
}

void test_invalid_parameters()
{
  using namespace CGAL::Anisotropic_hde_remeshing::parameters;
  const Mesh mesh = icosphere(1);
  for (const double bad : {-1., nan_value, infinity})
  {
    CHECK(contains(message_of(mesh, sigma(bad)), "sigma is"));
    CHECK(contains(message_of_one_call(mesh, sigma(bad)), "sigma is"));
    CHECK(contains(message_of(mesh, target_edge_length(bad)), "target_edge_length is"));
    CHECK(contains(message_of(mesh, smoothing_ratio(bad)), "smoothing_ratio is"));
    CHECK(contains(message_of(mesh, shape_weight(bad)), "shape_weight is"));
    CHECK(contains(message_of(mesh, collapse_ratio(bad)), "collapse_ratio is"));
    CHECK(contains(message_of(mesh, split_ratio(bad)), "split_ratio is"));
  }
  CHECK(contains(message_of(mesh, target_edge_length(0)), "target_edge_length is 0"));
  CHECK(contains(message_of(mesh, number_of_target_faces(0)), "number_of_target_faces is 0"));
  CHECK(contains(message_of(mesh, number_of_target_faces(-5)), "number_of_target_faces is -5"));
  CHECK(contains(message_of(mesh, number_of_target_faces(1000000000)), "number_of_target_faces is 1000000000"));
  CHECK(contains(message_of(mesh, target_edge_length(1e-9)),
                 "target edge length is 1e-9: it must be so large that the mesh has at most 5e8 faces, not about "));
  // as people write numbers, and never as the bound that they miss
  const std::string too_many = message_of(mesh, target_edge_length(1e-9));
  CHECK(too_many.size() < 140 && too_many.find("e19") == too_many.size() - 3);
  CHECK(contains(message_of(mesh, split_ratio(100.0000001)), "split_ratio is 100.0000001: it must be from 1 to 100"));
  CHECK(contains(message_of(mesh, sigma(-1e-7)), "sigma is -1e-7:"));
  CHECK(contains(message_of(mesh, sigma(-0.1)), "sigma is -0.1:"));
  CHECK(contains(message_of(mesh, sigma(-0.1f)), "sigma is -0.1"));
  CHECK(contains(message_of(mesh, number_of_iterations(2000000)), "number_of_iterations is 2000000:"));
  CHECK(contains(message_of(mesh, relative_target_edge_length(-1)), "relative_target_edge_length is -1"));
  CHECK(contains(message_of(mesh, relative_sigma(-1)), "relative_sigma is -1"));
  CHECK(contains(message_of(mesh, number_of_target_faces(std::size_t(-1))), "(-1 as an unsigned number)"));
  CHECK(contains(message_of(mesh, number_of_target_faces(nan_value)), "number_of_target_faces is nan"));
  for (const double bad : {-1., 0.5, 1e6 + 1, 1e300, nan_value, infinity, -infinity})
  {
    CHECK(contains(message_of(mesh, number_of_iterations(bad)), "number_of_iterations is "));
    CHECK(contains(message_of(mesh, number_of_relaxation_steps(bad)), "number_of_relaxation_steps is "));
  }
  CHECK(contains(message_of(mesh, number_of_iterations(-1)), "number_of_iterations is -1"));
  CHECK(contains(message_of(mesh, number_of_relaxation_steps(-1)), "number_of_relaxation_steps is -1"));
  CHECK(contains(message_of(mesh, number_of_iterations(-1u)), "(-1 as an unsigned number)"));
  CHECK(contains(message_of(mesh, smoothing_ratio(1.01)), "smoothing_ratio is 1.01"));
  CHECK(contains(message_of(mesh, aspect_ratio_bound(1.1)), "aspect_ratio_bound is 1.1: it must be at least 1.2"));
  CHECK(contains(message_of(mesh, aspect_ratio_bound(nan_value)), "aspect_ratio_bound is nan"));
  CHECK(contains(message_of(mesh, shape_weight(-1)), "shape_weight is -1"));
  CHECK(contains(message_of(mesh, collapse_ratio(1.5)), "collapse_ratio is 1.5"));
  CHECK(contains(message_of(mesh, split_ratio(0.9)), "split_ratio is 0.9"));
  CHECK(contains(message_of_one_call(mesh, number_of_patches(0)), "number_of_patches is 0"));
  CHECK(contains(message_of_one_call(mesh, patch_overlap(-1)), "patch_overlap is -1"));
  CHECK(contains(message_of_one_call(mesh, offset_distance(0)), "offset_distance is 0"));
}

// parameters at the edge of sense are no errors, and what comes out is valid
void test_extreme_parameters()
{
  using namespace CGAL::Anisotropic_hde_remeshing::parameters;
  const Mesh input = ellipsoid(2);
  const auto remesh = [&](const std::string& name, const auto& np)
  {
    Mesh mesh = input;
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), np);
    check_validity(name, input, mesh, Ellipsoid_function());
  };
  remesh("one face", number_of_target_faces(1));
  remesh("no smoothing", smoothing_ratio(0).number_of_target_faces(1000));
  remesh("no contraction", collapse_ratio(0));
  remesh("no relaxation", number_of_relaxation_steps(0));
  remesh("split at once", split_ratio(1).number_of_target_faces(1000));
  remesh("contract all that is shorter", collapse_ratio(1).split_ratio(1));
  remesh("huge length", target_edge_length(1e10));
  remesh("sigma tiny", sigma(1e-300));
}

// without an iteration the vertices are projected, whatever error is asked for
void test_no_iterations()
{
  using namespace CGAL::Anisotropic_hde_remeshing::parameters;
  const Mesh input = ellipsoid(2);
  const double D = bounding_box_diagonal(input);
  const auto remesh = [&](const double relative_error)
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, Ellipsoid_function(), number_of_iterations(0).relative_approximation_error(relative_error));
    CHECK(mesh.number_of_faces() == input.number_of_faces());
    CHECK(result.number_of_splits == 0 && result.number_of_collapses == 0 && result.number_of_flips == 0);
    CHECK(result.number_of_faces == input.number_of_faces());
    return result;
  };
  const Hde::Remeshing_result strict = remesh(1e-5), mild = remesh(0.5);
  CHECK(strict.approximation_error > 1e-5 * D);
  CHECK(strict.binding_target != Hde::Target::APPROXIMATION_ERROR);
  CHECK(mild.approximation_error <= 0.5 * D);
  CHECK(mild.binding_target == Hde::Target::APPROXIMATION_ERROR);
}

// more than the indices have room for: the numbers only, as no one has the memory
void test_size_limits()
{
  namespace internal = Hde::internal;
  CHECK_NO_THROW(internal::check_number_of_halfedges(3 * std::size_t(1400000000)));
  CHECK_THROWS(internal::check_number_of_halfedges(std::size_t(1) << 32), std::length_error);
  CHECK_THROWS(internal::check_number_of_halfedges(6 * std::size_t(1000000000)), std::length_error);
  CHECK_NO_THROW(internal::check_number_of_fitted_faces(238e6));
  CHECK_THROWS(internal::check_number_of_fitted_faces(239e6), std::length_error);
  CHECK(internal::text_of_number(1.5e-300) == "1.5e-300" && internal::text_of_number(-3e10) == "-3e10");
  CHECK(internal::text_of_number(1. / 3) == "0.33333333333333331" && internal::text_of_number(0) == "0");
  CHECK(internal::text_of_estimate(3124514100297397248.) == "3.1e18" && internal::text_of_estimate(523456.7) == "523457");
  // growing by the factor 4 from 5e8 faces ends before the indices do, and never below zero
  const double room = internal::room_for_splits(3 * std::size_t(500000000));
  CHECK(room > 4e8 && 3 * 5e8 + 6 * room <= double(internal::largest_number_of_halfedges));
  CHECK(internal::room_for_splits(internal::largest_number_of_halfedges) == 0);
  CHECK(internal::room_for_splits(internal::largest_number_of_halfedges + 100) == 0);
  // before anything is computed
  Mesh mesh = icosphere(1);
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function(),
                                                    params::number_of_target_faces(300000000).fit_to_surface(true)),
               std::length_error);
  CHECK(digest(mesh) == digest(icosphere(1)));
}

// what the result says of itself
void test_warnings()
{
  Hde::Remeshing_result result;
  CHECK(result.warnings().empty());
  const auto misses = [&](const std::size_t asked, const std::size_t got)
  {
    result.number_of_target_faces = asked;
    result.number_of_faces = got;
    CHECK(result.misses_number_of_faces() == !result.warnings().empty());
    return result.misses_number_of_faces();
  };
  CHECK(!misses(1000, 1000) && !misses(1000, 990) && !misses(1000, 1010) && !misses(10, 12) && !misses(0, 12));
  CHECK(misses(1000, 988) && misses(1000, 1012) && misses(10, 13));
  result.approximation_error = 1e-3; // as few faces as keep it
  CHECK(!misses(1000, 500) && misses(1000, 1012));

  // what the constraints keep is more than is asked for
  Mesh mesh = ellipsoid(2);
  const std::size_t n = mesh.number_of_faces();
  auto is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_constrained", true).first;
  result = CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, Ellipsoid_function(), params::number_of_target_faces(n / 2).vertex_is_constrained_map(is_constrained));
  CHECK(result.number_of_target_faces == n / 2);
  CHECK(result.number_of_faces == number_of_faces_of(mesh));
  CHECK(result.misses_number_of_faces());
  CHECK(result.number_of_needles == 0);

  // a needle that cannot go: two of its vertices are constrained
  Mesh needle;
  CGAL::make_triangle(Point_3(1, 0, 0), Point_3(1, 1e-5, 0), Point_3(0, 0, 1), needle);
  result = CGAL::anisotropic_hde_remeshing<Tag>(
      needle, Sphere_function(),
      params::number_of_iterations(0).vertex_is_constrained_map(CGAL::Static_boolean_property_map<Mesh::Vertex_index, true>()));
  CHECK(result.number_of_faces == 1 && result.number_of_needles == 1);
  CHECK(result.warnings().size() == 1 && contains(result.warnings().front(), "1 of 1 faces are needles"));
}

struct Stop : std::runtime_error
{
  Stop() : std::runtime_error("stop") {}
};

struct Throwing_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const
  {
    if (p.x() > 0.99)
      throw Stop();
    return Ellipsoid_function::operator()(p);
  }
};

// values and gradients of no use on a part of the surface: not a number, or zero
struct Nan_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return p.z() > 3 ? nan_value : Ellipsoid_function::operator()(p); }
  Vector_3 gradient(const Point_3& p) const { return p.z() > 3 ? Vector_3(nan_value, 0, 0) : Ellipsoid_function::gradient(p); }
};

struct Zero_function : Ellipsoid_function
{
  FT operator()(const Point_3&) const { return 0; }
  Vector_3 gradient(const Point_3&) const { return Vector_3(0, 0, 0); }
};

// a surface that is nowhere near
struct Far_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return Ellipsoid_function::operator()(p + Vector_3(1000, 0, 0)); }
  Vector_3 gradient(const Point_3& p) const { return Ellipsoid_function::gradient(p + Vector_3(1000, 0, 0)); }
};

template <typename Function>
void check_survival(const char* name, const Function& function)
{
  const Mesh input = ellipsoid(3);
  Mesh mesh = input;
  Hde::Remeshing_result result;
  try
  {
    result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::number_of_target_faces(2000));
  }
  catch (const std::exception& error)
  {
    std::cout << name << ": " << error.what() << std::endl;
    CHECK(digest(mesh) == digest(input));
    return;
  }
  std::cout << name << ": " << num_faces(mesh) << " faces, closest points " << result.projections.closest_point << std::endl;
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_closed(mesh));
  CHECK(Hde::measure_topology(mesh).euler_characteristic == 2);
  CHECK(result.projections.closest_point > 0);
  bool is_finite = true, is_near = true;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Point_3& p = mesh.point(v);
    is_finite = is_finite && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    is_near = is_near && std::abs(Ellipsoid_function()(p)) < 0.2;
  }
  CHECK(is_finite);
  CHECK(is_near);
}

void test_failing_functions()
{
  Mesh mesh = ellipsoid(3);
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Throwing_function()), Stop);
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<CGAL::Sequential_tag>(mesh, Throwing_function()), Stop);
  CHECK(digest(mesh) == digest(ellipsoid(3)));
  check_survival("NaN", Nan_function());
  check_survival("zero", Zero_function());
  check_survival("far", Far_function());
}

int main()
{
  test_invalid_meshes();
  test_bad_geometry();
  test_invalid_parameters();
  test_extreme_parameters();
  test_no_iterations();
  test_size_limits();
  test_warnings();
  test_failing_functions();
  return check_summary();
}
