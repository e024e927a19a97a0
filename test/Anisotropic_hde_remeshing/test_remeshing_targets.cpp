// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Targets: numbers of faces and lengths, absolute and relative, in any unit, place and position.

#include "remeshing_checks.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/transform.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Aff_transformation_3<Kernel> Transformation;

Mesh scan(const std::string& name)
{
  Mesh mesh;
  CHECK(PMP::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh));
  return mesh;
}

// to one per cent, from half to four times as many faces
void test_numbers_of_faces(const std::string& name, const Mesh& input, const double relative_sigma)
{
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(input);
  for (const double factor : {0.5, 1., 2., 4.})
  {
    Mesh mesh = input;
    const std::size_t wanted = std::size_t(factor * double(input.number_of_faces()));
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::relative_sigma(relative_sigma).number_of_target_faces(wanted));
    std::cout << name << ": asked " << wanted << ", got " << mesh.number_of_faces() << std::endl;
    CHECK_CLOSE(mesh.number_of_faces(), wanted, 0.01 * double(wanted));
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
  }
}

// the length that a number of faces gives, given as a length, gives the number
void test_lengths()
{
  const Mesh input = ellipsoid(4);
  const double diagonal = bounding_box_diagonal(input);
  for (const std::size_t number_of_faces : {2500, 5120, 12000})
  {
    Mesh mesh = input;
    const Hde::Remeshing_result by_number = CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, Ellipsoid_function(), params::relative_sigma(0.05).number_of_target_faces(number_of_faces));
    CHECK_CLOSE(by_number.sigma, 0.05 * diagonal, 1e-12);
    Mesh absolute = input, relative = input;
    const double length = by_number.target_edge_length;
    CGAL::anisotropic_hde_remeshing<Tag>(absolute, Ellipsoid_function(),
                                         params::sigma(0.05 * diagonal).target_edge_length(length));
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
        relative, Ellipsoid_function(), params::relative_sigma(0.05).relative_target_edge_length(length / diagonal));
    CHECK_CLOSE(absolute.number_of_faces(), number_of_faces, 0.02 * double(number_of_faces));
    CHECK_CLOSE(relative.number_of_faces(), number_of_faces, 0.02 * double(number_of_faces));
    CHECK_CLOSE(result.target_edge_length, length, 1e-12 * length);
  }
}

// Points and faces in the order of the result; equal only if the same was done.
std::vector<std::size_t> connectivity(const Mesh& mesh)
{
  std::vector<std::size_t> result;
  for (const Mesh::Face_index f : mesh.faces())
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.push_back(std::size_t(v));
  return result;
}

struct Figures
{
  std::size_t wanted, number_of_faces;
  Hde::Embedding_measures embedding;
  std::vector<std::size_t> faces;
};

Figures remeshed(Mesh mesh, const Transformation& transformation, const double factor)
{
  PMP::transform(transformation, mesh);
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(mesh);
  const std::size_t wanted = std::size_t(factor * double(num_faces(mesh)));
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::relative_sigma(0.02).number_of_target_faces(wanted));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  return {wanted, mesh.number_of_faces(),
          Hde::measure_embedding(mesh, function, params::sigma(result.sigma).target_edge_length(result.target_edge_length)),
          connectivity(mesh)};
}

// what is promised by itself
void check_quality(const std::string& name, const Figures& figures, const Bounds& bounds)
{
  std::cout << name << ": " << figures.number_of_faces << " faces, lengths " << figures.embedding.share_within_sqrt_2
            << ", angle " << figures.embedding.minimum_angle_mean << std::endl;
  CHECK_CLOSE(figures.number_of_faces, figures.wanted, 0.01 * double(figures.wanted));
  CHECK(figures.embedding.minimum_angle_mean >= bounds.least_mean_angle);
  CHECK(figures.embedding.share_within_sqrt_2 >= bounds.least_share_of_lengths);
  CHECK(figures.embedding.number_of_folded_faces == 0);
}

void check_same_quality(const std::string& name, const Figures& figures, const Figures& expected, const Bounds& bounds)
{
  check_quality(name, figures, bounds);
  CHECK_CLOSE(figures.number_of_faces, expected.number_of_faces, 0.01 * double(expected.number_of_faces));
  CHECK_CLOSE(figures.embedding.minimum_angle_mean, expected.embedding.minimum_angle_mean, 0.6);
  CHECK_CLOSE(figures.embedding.share_within_sqrt_2, expected.embedding.share_within_sqrt_2, 0.005);
}

// Operations come in another order after a rotation, so that the mean angle varies by chance: its standard deviation is .2 degrees
// for these numbers of faces. Several rotations together are held to the input as it is.
void check_rotated(const std::string& name, const Mesh& input, const double factor, const Figures& expected,
                   const Bounds& bounds)
{
  const std::vector<double> angles{0.4, 0.7, 1, 1.3};
  double sum_of_angles = 0, sum_of_shares = 0;
  for (const double angle : angles)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    const Figures figures = remeshed(input, Transformation(c, -s * c, s * s, s, c * c, -c * s, 0, s, c), factor);
    check_quality(name, figures, bounds);
    CHECK_CLOSE(figures.number_of_faces, expected.number_of_faces, 0.01 * double(expected.number_of_faces));
    sum_of_angles += figures.embedding.minimum_angle_mean;
    sum_of_shares += figures.embedding.share_within_sqrt_2;
  }
  CHECK_CLOSE(sum_of_angles / double(angles.size()), expected.embedding.minimum_angle_mean, 0.6);
  CHECK_CLOSE(sum_of_shares / double(angles.size()), expected.embedding.share_within_sqrt_2, 0.005);
}

void test_units(const std::string& name, const Mesh& input, const Bounds& bounds = Bounds())
{
  const double diagonal = bounding_box_diagonal(input);
  for (const double factor : {0.5, 2.})
  {
    const Figures expected = remeshed(input, Transformation(CGAL::SCALING, 1), factor);
    check_quality(name, expected, bounds);
    // a power of two rounds nothing
    for (const double scale : {1. / 1024, std::ldexp(1., 40)})
    {
      const Figures figures = remeshed(input, Transformation(CGAL::SCALING, scale), factor);
      CHECK(figures.faces == expected.faces);
    }
    for (const double scale : {1e-6, 1e6})
      check_same_quality(name + " scaled", remeshed(input, Transformation(CGAL::SCALING, scale), factor), expected, bounds);
    check_same_quality(name + " far away",
                       remeshed(input, Transformation(CGAL::TRANSLATION, Vector_3(600, 600, -600) * diagonal), factor),
                       expected, bounds);
    check_rotated(name + " rotated", input, factor, expected, bounds);
  }
}

int main()
{
  test_numbers_of_faces("ellipsoid", ellipsoid(4), 0.05);
  test_numbers_of_faces("torus", torus(80, 30), 0.02);
  test_numbers_of_faces("elephant", scan("elephant.off"), 0.01);
  test_numbers_of_faces("lion head", scan("lion-head.off"), 0.01);
  test_lengths();
  test_units("ellipsoid", ellipsoid(4));
  Bounds bounds_for_details; // half the faces of the elephant are about as large as these
  bounds_for_details.least_share_of_lengths = 0.98;
  test_units("elephant", scan("elephant.off"), bounds_for_details);
  return check_summary();
}
