// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the package promises, on meshes that no surface reconstruction would make: a valid result or a refusal.

// Needles, of which the sides of cylinders are made in files of CAD programs: long triangles across which nothing is needed, that have
// to be split all the same. The number of faces asked for comes, or the result says what keeps the mesh from it.

#include "check.h"
#include "crease_checks.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

bool is_reached(const Mesh& mesh, const std::size_t wanted)
{
  return std::abs(double(mesh.number_of_faces()) - double(wanted)) <= 0.01 * double(wanted);
}

// valid, without a fold, and no needle is left
void check_faces(const std::string& name, const Mesh& before, const Mesh& after, const double largest_ratio)
{
  remeshing_checks::check_same_topology(before, after);
  const Hde::Shape_measures shape = Hde::measure_shape(after);
  CHECK(shape.aspect_ratio_max <= largest_ratio);
  std::cout << name << ": " << after.number_of_faces() << " faces, aspect ratio " << shape.aspect_ratio_mean << ", at most "
            << shape.aspect_ratio_max << std::endl;
}

// one row of them, between two boundaries
void test_open_cylinder(const std::size_t sides, const std::size_t wanted)
{
  const Mesh before = cylinder(sides, 1, 2);
  Mesh mesh = before;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, Cylinder_function(), params::number_of_target_faces(wanted));
  check_faces("open cylinder of " + std::to_string(sides) + " sides, " + std::to_string(wanted) + " asked", before, mesh, 4);
  CHECK(is_reached(mesh, wanted));
  CHECK(result.binding_target == Hde::Target::NUMBER_OF_FACES);
  CHECK(result.number_of_unprojected_vertices == 0);
  // the needles are contracted across, not split to squares first
  CHECK(result.number_of_splits <= 20 * wanted + sides);
}

// a row of them between two fans about the centres of the caps; the regions are those of Can_function
Mesh can_of_needles(const std::size_t sides)
{
  Soup soup;
  for (const double z : {-1., 1.})
    for (std::size_t i = 0; i < sides; ++i)
    {
      const double angle = 2 * std::acos(-1.) * double(i) / double(sides);
      soup.points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  soup.points.emplace_back(0, 0, -1);
  soup.points.emplace_back(0, 0, 1);
  for (std::size_t i = 0; i < sides; ++i)
  {
    const std::size_t j = (i + 1) % sides;
    soup.triangles.push_back({i, j, sides + j});
    soup.triangles.push_back({i, sides + j, sides + i});
    soup.triangles.push_back({j, i, 2 * sides});
    soup.triangles.push_back({sides + i, sides + j, 2 * sides + 1});
  }
  return crease_checks::can(to_mesh(soup));
}

// between two creases
void test_can(const std::size_t sides, const std::size_t wanted)
{
  const Mesh before = can_of_needles(sides);
  Mesh mesh = before;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, crease_checks::Can_function(),
      params::number_of_target_faces(wanted).relative_sigma(0.02).face_patch_map(crease_checks::regions_of(mesh)));
  check_faces("can of " + std::to_string(sides) + " sides, " + std::to_string(wanted) + " asked", before, mesh, 60);
  // Each circle keeps vertices, so that no edge leaves its polyline by more than 5e-5 of the diagonal. With three times the faces
  // that these need there is no excuse.
  const double largest_deviation = 5e-5 * bounding_box_diagonal(before);
  const double least_on_circle = (std::min)(double(sides), std::acos(-1.) / std::acos(1 - largest_deviation));
  CHECK(is_reached(mesh, wanted) || double(wanted) < 3 * 4 * least_on_circle);
  CHECK(result.binding_target == (is_reached(mesh, wanted) ? Hde::Target::NUMBER_OF_FACES : Hde::Target::FEATURE_CURVES));
}

// closed, with its tip at (0, 0, height)
Mesh cone(const std::size_t sides, const double height)
{
  Soup soup;
  soup.points = {Point_3(0, 0, height), Point_3(0, 0, 0)};
  for (std::size_t i = 0; i < sides; ++i)
  {
    const double angle = 2 * std::acos(-1.) * double(i) / double(sides);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    const std::size_t a = 2 + i, b = 2 + (i + 1) % sides;
    soup.triangles.push_back({a, b, 0});
    soup.triangles.push_back({b, a, 1});
  }
  return to_mesh(soup);
}

bool has_vertex(const Mesh& mesh, const Point_3& p, const double largest_distance = 0)
{
  for (const auto v : mesh.vertices())
    if (CGAL::squared_distance(mesh.point(v), p) <= largest_distance * largest_distance)
      return true;
  return false;
}

// The tip stays, with and without creases. With them, and nothing asked of the embedding, the measured error leads, and the tip is a
// vertex like any other, for which there is no better place. Without them the rim is rounded.
void test_cone(const std::size_t sides, const double height, const std::size_t wanted)
{
  const Mesh before = cone(sides, height);
  const double length = std::sqrt(4 / std::sqrt(3.) * CGAL::Polygon_mesh_processing::area(before) / double(wanted));
  Mesh smooth = before, sharp = before;
  CGAL::anisotropic_hde_remeshing<Tag>(smooth, params::number_of_target_faces(wanted).relative_sigma(0.02));
  CGAL::anisotropic_hde_remeshing<Tag>(sharp, params::number_of_target_faces(wanted).sharp_angle(30));
  for (const Mesh* after : {&smooth, &sharp})
  {
    remeshing_checks::check_same_topology(before, *after);
    CHECK(has_vertex(*after, Point_3(0, 0, height), after == &sharp ? 0.01 * length : 0));
    const double distance = Hde::measure_distance<Tag>(*after, before).max();
    std::cout << "cone of height " << height << ", " << wanted << " asked: " << distance / length << " edges off" << std::endl;
    if (after == &sharp)
      CHECK(distance < 0.05 * length);
  }
}

// A tip that is not on the surface of a function goes there.
void test_tip_off_the_surface()
{
  Mesh mesh = cone(48, 2);
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function{3}, params::number_of_target_faces(400));
  CHECK(!has_vertex(mesh, Point_3(0, 0, 2)));
  std::size_t number_off = 0;
  for (const auto v : mesh.vertices())
    number_off += std::abs(std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length()) - 3) > 1e-6 ? 1 : 0;
  CHECK(number_off == result.number_of_unprojected_vertices);
}

// each vertex of an octahedron turns as much as a tip, but none more than its neighbours: it is a coarse sphere
void test_coarse_sphere()
{
  Soup soup;
  soup.points = {Point_3(1, 0, 0), Point_3(-1, 0, 0), Point_3(0, 1, 0), Point_3(0, -1, 0), Point_3(0, 0, 1), Point_3(0, 0, -1)};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  Mesh mesh = to_mesh(soup);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(500).relative_sigma(0.02));
  std::size_t number_kept = 0;
  for (const Point_3& p : soup.points)
    number_kept += has_vertex(mesh, p) ? 1 : 0;
  CHECK(number_kept < 6);
}

int main()
{
  for (const double height : {1.2, 2., 4.})
    for (const std::size_t wanted : {200, 400, 1000})
      test_cone(48, height, wanted);
  test_tip_off_the_surface();
  test_coarse_sphere();
  for (const std::size_t sides : {60, 200, 2000})
    for (const std::size_t wanted : {500, 4000})
    {
      test_open_cylinder(sides, wanted);
      test_can(sides, wanted);
    }
  test_open_cylinder(600, 20000);
  test_can(200, 20000);
  return check_summary();
}
