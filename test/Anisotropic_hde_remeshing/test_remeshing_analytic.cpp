// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshing of closed surfaces that are known exactly: topology, guards, quality in the embedding, number of faces,
// parameters.

#include "remeshing_checks.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <sstream>
#include <string>

using namespace shapes;
using namespace remeshing_checks;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

// `sigmas` are fractions of the diagonal
template <typename Function>
void test_surface(const char* name, const Mesh& input, const Function& function, const std::initializer_list<double> sigmas,
                  const std::initializer_list<std::size_t> numbers_of_faces, const Bounds& bounds = Bounds())
{
  for (const double sigma : sigmas)
    for (const std::size_t number_of_faces : numbers_of_faces)
    {
      Mesh mesh = input;
      const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
          mesh, function, params::sigma(sigma * bounding_box_diagonal(input)).number_of_target_faces(number_of_faces));
      std::ostringstream text;
      text << name << ", sigma " << sigma << " D, " << number_of_faces << " faces";
      check_validity(text.str(), input, mesh, function);
      CHECK(CGAL::is_closed(mesh));
      CHECK(PMP::is_outward_oriented(mesh));
      check_number_of_faces(mesh, number_of_faces);
      check_quality(mesh, function, result, bounds);
      CHECK(result.sigma == sigma * bounding_box_diagonal(input));
      CHECK(!result.was_stopped);
    }
}

// more anisotropy, longer triangles; without, none
void test_sigma()
{
  const Mesh input = ellipsoid(4);
  const double diagonal = bounding_box_diagonal(input);
  double last = 0;
  for (const double sigma : {0., 0.05, 0.15, 0.4})
  {
    Mesh mesh = input;
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::sigma(sigma * diagonal));
    const double aspect_ratio = Hde::measure_shape(mesh).aspect_ratio_mean;
    std::cout << "aspect ratio with sigma " << sigma << " D: " << aspect_ratio << std::endl;
    CHECK(aspect_ratio > 1.02 * last);
    if (sigma == 0)
      CHECK(aspect_ratio < 1.05);
    last = aspect_ratio;
  }
}

void test_large_sigma()
{
  for (const std::size_t number_of_faces : {4000, 40000})
    for (const double sigma : {0., 0.02, 0.1, 0.5, 1.})
    {
      if (number_of_faces == 40000 && sigma < 0.5)
        continue;
      const auto test = [&](const std::string& name, const Mesh& input, const auto& function)
      {
        Mesh mesh = input;
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, function,
                                             params::relative_sigma(sigma).number_of_target_faces(number_of_faces));
        check_validity(name + ", sigma " + std::to_string(sigma) + " D", input, mesh, function);
        check_number_of_faces(mesh, number_of_faces);
      };
      test("ellipsoid", ellipsoid(5), Ellipsoid_function());
      test("torus", torus(256, 64), Torus_function());
    }
}

// scans, for as large a sigma as makes sense
void test_scans()
{
  for (const char* name : {"elephant.off", "bunny00.off"})
  {
    Mesh input;
    if (!CHECK(PMP::IO::read_polygon_mesh(CGAL::data_file_path(std::string("meshes/") + name), input)))
      continue;
    const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(input);
    for (const double sigma : {0.005, 0.05})
    {
      Mesh mesh = input;
      const Hde::Remeshing_result result =
          CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::relative_sigma(sigma).number_of_target_faces(20000));
      // A vertex whose last way to the zero set would fold a face stays at its rough projection. It is told, and there are hardly any.
      CHECK(result.number_of_unprojected_vertices <= 1);
      check_validity(std::string(name) + ", sigma " + std::to_string(sigma) + " D", input, mesh, function,
                     result.number_of_unprojected_vertices == 0 ? 1e-9 : 1e-6);
      check_number_of_faces(mesh, 20000);
    }
  }
}

// from a coarse mesh to a fine one on the smooth surface through its vertices
void test_filling_in()
{
  const Mesh input = ellipsoid(4); // 2,562 vertices
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::relative_sigma(0.15).number_of_target_faces(39996));
  check_number_of_faces(mesh, 39996);
  // to first order, from the faces
  const double rms = Hde::measure_distance_to_zero_set<Tag>(mesh, Ellipsoid_function()).face_rms / bounding_box_diagonal(input);
  std::cout << "filled in: " << rms << " D" << std::endl;
  CHECK(rms <= 2.0e-5);
}

void test_default_parameters()
{
  const Mesh input = icosphere(4, 3);
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{3});
  check_validity("sphere, defaults", input, mesh, Sphere_function{3});
  check_number_of_faces(mesh, input.number_of_faces());
  check_quality(mesh, Sphere_function{3}, result);
  CHECK_CLOSE(result.sigma, 0.01 * bounding_box_diagonal(input), 1e-12);
  CHECK(result.number_of_iterations == 10);
}

void test_target_edge_length()
{
  const Mesh input = ellipsoid(4);
  const double sigma = 0.1 * bounding_box_diagonal(input);
  std::size_t last = 0;
  for (const double length : {0.9, 0.45, 0.25})
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result =
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::target_edge_length(length).sigma(sigma));
    CHECK(result.target_edge_length == length);
    check_validity("ellipsoid, length " + std::to_string(length), input, mesh, Ellipsoid_function());
    check_quality(mesh, Ellipsoid_function(), result);
    // the area in the embedding is the same for all three
    if (last > 0)
      CHECK(mesh.number_of_faces() > 2 * last);
    last = mesh.number_of_faces();
  }
}

// Algorithm 2 of the paper promises less: edges between half and one and a half of the length, smoothing of a share
void test_scheme_of_the_paper()
{
  const Mesh input = ellipsoid(4);
  for (const std::size_t number_of_faces : {2000, 8000})
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result =
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                             params::remeshing_scheme(Hde::Remeshing_scheme::PAPER)
                                                 .sigma(0.05 * bounding_box_diagonal(input))
                                                 .number_of_target_faces(number_of_faces));
    check_validity("scheme of the paper", input, mesh, Ellipsoid_function());
    CHECK(result.number_of_iterations == 10);
    const Hde::Embedding_measures measures = Hde::measure_embedding(
        mesh, Ellipsoid_function(), params::sigma(result.sigma).target_edge_length(result.target_edge_length));
    std::cout << "  within [.5, 1.5]: " << measures.share_within_half << ", angle " << measures.minimum_angle_mean << std::endl;
    CHECK(measures.share_within_half >= 0.99);
  }
}

// no iteration: the vertices move to the zero set, the faces stay
void test_projection_only()
{
  Mesh input = icosphere(3);
  for (const Mesh::Vertex_index v : input.vertices())
  {
    const Point_3 p = input.point(v);
    input.point(v) = CGAL::ORIGIN + (1 + 0.02 * std::sin(20 * p.x())) * (p - CGAL::ORIGIN);
  }
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function(), params::number_of_iterations(0).number_of_target_faces(50));
  CHECK(result.number_of_iterations == 0);
  CHECK(result.number_of_splits + result.number_of_collapses + result.number_of_flips == 0);
  CHECK(mesh.number_of_faces() == input.number_of_faces());
  check_validity("projection only", input, mesh, Sphere_function());
  for (const Mesh::Vertex_index v : mesh.vertices())
    CHECK(CGAL::squared_distance(mesh.point(v), input.point(v)) < 0.021 * 0.021);
}

// the caller's orientation is kept, whichever way the gradient points
void test_orientation()
{
  Mesh mesh = ellipsoid(3);
  PMP::reverse_face_orientations(mesh);
  const Mesh input = mesh;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::sigma(0.5).number_of_target_faces(2000));
  CHECK(!PMP::is_outward_oriented(mesh));
  PMP::reverse_face_orientations(mesh);
  check_validity("reversed", input, mesh, Ellipsoid_function());
}

// two components, of which only one would be left if they were taken for one
void test_two_components()
{
  struct Two_spheres : Sphere_function
  {
    static Vector_3 centre(const Point_3& p) { return Vector_3(p.x() > 0 ? 1.5 : -1.5, 0, 0); }
    FT operator()(const Point_3& p) const { return Sphere_function::operator()(p - centre(p)); }
    Vector_3 gradient(const Point_3& p) const { return Sphere_function::gradient(p - centre(p)); }
  };
  Soup soup;
  for (const double x : {-1.5, 1.5})
  {
    const Soup sphere = icosphere_soup(3);
    const std::size_t first = soup.points.size();
    for (const Point_3& p : sphere.points)
      soup.points.push_back(p + Vector_3(x, 0, 0));
    for (const auto& t : sphere.triangles)
      soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const Mesh input = to_mesh(soup);
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Two_spheres(), params::number_of_target_faces(1000));
  check_validity("two spheres", input, mesh, Two_spheres());
  check_number_of_faces(mesh, 1000);
}

int main()
{
  // 5120 faces; coarser, as many, finer
  test_surface("sphere", icosphere(4), Sphere_function(), {0., 0.01, 0.3}, {1500, 5120, 12000});
  test_surface("ellipsoid", ellipsoid(4), Ellipsoid_function(), {0., 0.05, 0.15}, {2000, 5120, 10000});
  test_surface("torus", torus(80, 30), Torus_function(), {0.01, 0.05, 0.2}, {2000, 8000}, bounds_for_grids());
  test_large_sigma();
  test_scans();
  test_filling_in();
  test_default_parameters();
  test_sigma();
  test_target_edge_length();
  test_scheme_of_the_paper();
  test_projection_only();
  test_orientation();
  test_two_components();
  return check_summary();
}
