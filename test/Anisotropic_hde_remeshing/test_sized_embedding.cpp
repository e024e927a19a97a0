// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Lengths of edges that are wanted at each place: whether the edges have them.

#include "check.h"
#include "length_checks.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Interpolated_vertex_field.h>
#include <CGAL/Anisotropic_hde_remeshing/Sized_embedding.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

// grows from 0.03 to 0.15 on a sphere of radius 1, gradually
double size_at_height(const Point_3& p) { return 0.09 + 0.06 * p.z(); }

Mesh remeshed_by_size()
{
  Mesh mesh = icosphere(4);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1},
                                       params::embedding(Hde::sized_embedding<Point_3>(size_at_height)).target_edge_length(1));
  return mesh;
}

void test_lengths()
{
  const Mesh mesh = remeshed_by_size();
  remeshing_checks::check_same_topology(icosphere(4), mesh);
  check_lengths(mesh, size_at_height, 1);
}

// a number of faces: the proportions are those of the sizes
void test_number_of_faces()
{
  Mesh mesh = icosphere(4);
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, Sphere_function{1}, params::embedding(Hde::sized_embedding<Point_3>(size_at_height)).number_of_target_faces(4000));
  CHECK(std::abs(double(mesh.number_of_faces()) - 4000) < 80);
  check_lengths(mesh, size_at_height, result.target_edge_length);
}

// the sizes at the vertices of the input, and another unit of length
void test_vertex_property()
{
  Mesh input = icosphere(4);
  for (const auto v : input.vertices())
    input.point(v) = Point_3(1000 * input.point(v).x(), 1000 * input.point(v).y(), 1000 * input.point(v).z());
  auto sizes = input.add_property_map<Mesh::Vertex_index, double>("v:size").first;
  const auto size = [](const Point_3& p) { return 1000 * size_at_height(Point_3(p.x() / 1000, p.y() / 1000, p.z() / 1000)); };
  for (const auto v : input.vertices())
    sizes[v] = size(input.point(v));
  const Hde::Interpolated_vertex_field field(input, sizes);
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{1000},
                                       params::embedding(Hde::sized_embedding<Point_3>(field)).target_edge_length(1));
  check_lengths(mesh, size, 1);
  CHECK(std::abs(double(mesh.number_of_faces()) / double(remeshed_by_size().number_of_faces()) - 1) < 0.02);
}

// One size everywhere is a target edge length, whatever the embedding below.
void test_constant_size()
{
  Ellipsoid_function function;
  for (const double sigma : {0., 0.5})
  {
    Mesh by_length = ellipsoid(4), by_size = by_length;
    const Hde::Normal_embedding below(sigma);
    CGAL::anisotropic_hde_remeshing<Tag>(by_length, function, params::embedding(below).target_edge_length(0.2));
    CGAL::anisotropic_hde_remeshing<Tag>(
        by_size, function,
        params::embedding(Hde::sized_embedding<Point_3>([](const Point_3&) { return 0.2; }, below)).target_edge_length(1));
    CHECK(std::abs(double(by_size.number_of_faces()) / double(by_length.number_of_faces()) - 1) < 0.01);
  }
}

void test_bad_sizes()
{
  for (const double bad : {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Mesh mesh = icosphere(2);
    const Mesh before = mesh;
    const auto size = [=](const Point_3& p) { return p.z() > 0.5 ? bad : 0.3; };
    CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(
                     mesh, Sphere_function{1}, params::embedding(Hde::sized_embedding<Point_3>(size)).target_edge_length(1)),
                 std::invalid_argument);
    CHECK(mesh.number_of_faces() == before.number_of_faces());
  }
}

int main()
{
  test_lengths();
  test_number_of_faces();
  test_vertex_property();
  test_constant_size();
  test_bad_sizes();
  return check_summary();
}
