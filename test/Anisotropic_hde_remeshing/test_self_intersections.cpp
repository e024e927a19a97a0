// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Whether triangles intersect, against CGAL; that no operation lets faces intersect where that is asked for, nor folds an edge.

#include "awkward_shapes.h"
#include "check.h"
#include "promises.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Intersection_guard.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Mesh_intersections.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Triangle_groups.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
using Hde::internal::Indexed_triangle;
using Hde::internal::Vector;
using shapes::Mesh;
using shapes::Point_3;
using shapes::Vector_3;
typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

Indexed_triangle triangle(const std::vector<Point_3>& points, const std::array<std::size_t, 3>& vertices)
{
  Indexed_triangle result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point_3& p = points[vertices[k]];
    result.vertices[k] = vertices[k];
    result.points[k] = Vector(p.x(), p.y(), p.z());
  }
  return result;
}

// Two triangles with so many vertices in common, of points with few different coordinates: many lie in a plane or on a line. If
// they share an edge, they are oriented alike.
void test_pairs(const std::size_t number_of_shared, const int number_of_coordinates, const double unit)
{
  std::mt19937 random(1);
  const auto coordinate = [&] { return unit * (double(random() % unsigned(number_of_coordinates)) + 0.1); };
  int number_of_intersecting = 0, number_of_pairs = 0;
  while (number_of_pairs < 20000)
  {
    std::vector<Point_3> points;
    for (std::size_t i = 0; i < 6 - number_of_shared; ++i)
    {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      points.emplace_back(x, y, z);
    }
    const std::array<std::size_t, 3> s = {0, 1, 2};
    const std::array<std::size_t, 3> t = number_of_shared == 0   ? std::array<std::size_t, 3>{3, 4, 5}
                                         : number_of_shared == 1 ? std::array<std::size_t, 3>{3, 1, 4}
                                                                 : std::array<std::size_t, 3>{3, 1, 0};
    if (CGAL::collinear(points[s[0]], points[s[1]], points[s[2]]) || CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]))
      continue;
    Mesh mesh;
    for (const Point_3& p : points)
      mesh.add_vertex(p);
    for (const auto& f : {s, t})
      mesh.add_face(Mesh::Vertex_index(unsigned(f[0])), Mesh::Vertex_index(unsigned(f[1])), Mesh::Vertex_index(unsigned(f[2])));
    const bool expected = CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
    CHECK(do_triangles_intersect(triangle(points, s), triangle(points, t)) == expected);
    CHECK(do_triangles_intersect(triangle(points, t), triangle(points, s)) == expected);
    number_of_intersecting += expected ? 1 : 0;
    ++number_of_pairs;
  }
  std::cout << number_of_shared << " shared vertices: " << number_of_intersecting << " of " << number_of_pairs
            << " pairs intersect" << std::endl;
  if (number_of_coordinates < 10)
    CHECK(number_of_intersecting > 100 && number_of_intersecting < number_of_pairs - 100);
}

void test_guard()
{
  // a floor and a tent over it
  const std::vector<Point_3> points = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0},  {-1, 0, 1},
                                       {1, 0, 1},   {0, 1, 2},  {0, 0, -1}, {0, -1, 1}};
  const Indexed_triangle floor = triangle(points, {0, 1, 2}), above = triangle(points, {3, 4, 5}),
                         through = triangle(points, {3, 4, 6}), through_too = triangle(points, {4, 5, 6}),
                         beside = triangle(points, {3, 7, 4});
  Hde::internal::Intersection_guard guard;
  guard.assign({{0, floor}, {1, above}});
  const std::vector<std::size_t> only_above = {1};
  CHECK(guard.accepts(only_above, std::vector<Indexed_triangle>{beside}));
  CHECK(!guard.accepts(only_above, std::vector<Indexed_triangle>{beside, through}));
  guard.replace(1, through);
  CHECK(guard.accepts(only_above, std::vector<Indexed_triangle>{beside, through}));       // it has intersected the floor before
  CHECK(!guard.accepts(only_above, std::vector<Indexed_triangle>{through, through_too})); // but not twice
  CHECK(guard.intersecting(1, [](std::size_t) { return true; }) == std::vector<std::size_t>{0});
  guard.replace(5, above);
  CHECK(guard.intersecting(5, [](std::size_t) { return true; }).empty());
  guard.remove(0);
  CHECK(guard.intersecting(1, [](std::size_t) { return true; }).empty());
  CHECK(guard.accepts(std::vector<std::size_t>{5}, std::vector<Indexed_triangle>{floor}) == false);
  CHECK(guard.accepts(only_above, std::vector<Indexed_triangle>{floor}));
}

// A small triangle far above a floor. Work that lets it dip through the floor is taken back and done again until it does not, or the
// attempts are at an end; then it is worth to begin again, twice. If it is interrupted, the second attempt is the last one.
void test_attempts(const int first_good_attempt, const bool is_interrupted)
{
  struct Nothing
  {
  };
  typedef Hde::internal::Working_mesh<Nothing> Working_mesh;
  Working_mesh mesh;
  std::vector<Hde::internal::Vertex_index> vertices;
  for (const Vector& p :
       {Vector(-9, -9, 0), Vector(9, -9, 0), Vector(0, 9, 0), Vector(-1, 0, 5), Vector(1, 0, 5), Vector(0, 1, 5)})
  {
    Working_mesh::Vertex vertex;
    vertex.point = p;
    vertices.push_back(mesh.add_vertex(vertex));
  }
  mesh.add_face(vertices[0], vertices[1], vertices[2]);
  const auto above = mesh.add_face(vertices[3], vertices[4], vertices[5]);
  const Hde::internal::Edge_index edge = mesh.edge(mesh.halfedge(above));

  Hde::internal::Interruption interruption([is_interrupted] { return !is_interrupted; });
  Hde::internal::Mesh_intersections<Working_mesh> intersections(mesh, Hde::internal::Obstacles(), true);
  intersections.find_near_sheets<CGAL::Sequential_tag>(1, 0, interruption);
  CHECK(!intersections.has_near_sheets());
  interruption.ask();
  std::vector<bool> is_near;
  const auto dip = [&]
  {
    is_near.push_back(intersections.is_near_sheet(edge));
    mesh.point(vertices[5]).point[2] = int(is_near.size()) < first_good_attempt ? -1 : 4;
  };
  const auto take_back = [&] { mesh.point(vertices[5]).point[2] = 5; };
  intersections.keep_pairs<CGAL::Sequential_tag>(dip, take_back, interruption);
  const std::size_t expected = is_interrupted ? 2 : std::size_t((std::min)(first_good_attempt, 3));
  CHECK(is_near.size() == expected);
  CHECK(!is_near[0] && (is_near.size() < 2 || is_near[1]));
  CHECK(intersections.number_of_pairs_before() == 0);
  const bool has_failed = int(expected) < first_good_attempt;
  CHECK(intersections.number_of_pairs() == (has_failed ? 1 : 0));
  for (const bool is_to_restart : {true, true, false})
  {
    if (!has_failed)
      break;
    CHECK(intersections.has_more_pairs() && intersections.is_to_restart() == is_to_restart);
    if (!is_to_restart)
      break;
    intersections.restart();
    CHECK(!intersections.has_more_pairs());
    take_back();
    intersections.keep_pairs<CGAL::Sequential_tag>([&] { mesh.point(vertices[5]).point[2] = -1; }, take_back, interruption);
  }
}

// sheets that are closer than the faces are long: faces intersect if that is not tested, and fold if that were not refused
void test_sheets()
{
  std::size_t number_without_tests = 0;
  for (const shapes::Soup& soup : {awkward_shapes::shell(1e-2), awkward_shapes::plate(12, 1e-3), awkward_shapes::spheres(1e-7)})
  {
    const Mesh input = shapes::to_mesh<Mesh>(soup);
    CHECK(promises::number_of_self_intersections(input) == 0);
    const Function function(input);
    for (const double factor : {0.3, 1., 3.})
    {
      const auto np =
          params::relative_sigma(0.02).number_of_target_faces(std::size_t(factor * double(input.number_of_faces())));
      Mesh mesh = input, tested = input, again = input;
      CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, function, np.do_self_intersection_tests(false));
      CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(tested, function, np.do_self_intersection_tests(true));
      CGAL::anisotropic_hde_remeshing<CGAL::Sequential_tag>(again, function, np.do_self_intersection_tests(true));
      const std::size_t number = promises::number_of_self_intersections(mesh);
      number_without_tests += number;
      std::cout << input.number_of_faces() << " to " << mesh.number_of_faces() << " faces: " << number
                << " pairs intersect, with tests " << promises::number_of_self_intersections(tested) << std::endl;
      CHECK(promises::number_of_self_intersections(tested) == 0);
      CHECK(Hde::measure_shape(mesh).number_of_folded_edges == 0);
      CHECK(Hde::measure_shape(tested).number_of_folded_edges == 0);
      CHECK(tested.number_of_faces() > input.number_of_faces() / 5);
      CHECK(remeshing_checks::digest(tested) == remeshing_checks::digest(again));
    }
  }
  CHECK(number_without_tests > 0); // or the tests have shown nothing
}

// Tests are the default. Where no sheets are near, they change nothing.
void test_default()
{
  const Mesh input = shapes::ellipsoid(3);
  Mesh mesh = input, off = input, on = input;
  CGAL::anisotropic_hde_remeshing(mesh, shapes::Ellipsoid_function());
  CGAL::anisotropic_hde_remeshing(off, shapes::Ellipsoid_function(), params::do_self_intersection_tests(false));
  CHECK(remeshing_checks::digest(mesh) == remeshing_checks::digest(off));
  Mesh sheets = shapes::to_mesh<Mesh>(awkward_shapes::plate(12, 1e-3));
  const Function function(sheets);
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing(sheets, function, params::relative_sigma(0.02));
  CHECK(result.number_of_self_intersections_before == 0 && result.number_of_self_intersections == 0);
  CHECK(promises::number_of_self_intersections(sheets) == 0);
}

// two spheres that go through each other: as many pairs are told as there are, and no more come
void test_intersecting_input()
{
  const Mesh input = shapes::to_mesh<Mesh>(awkward_shapes::spheres(-0.3));
  const std::size_t before = promises::number_of_self_intersections(input);
  CHECK(before > 0);
  for (const double factor : {0.3, 1., 3.})
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing(
        mesh, params::number_of_target_faces(std::size_t(factor * double(input.number_of_faces()))));
    const std::size_t after = promises::number_of_self_intersections(mesh);
    std::cout << "spheres that cross, " << mesh.number_of_faces() << " faces: " << before << " pairs before, " << after
              << " after" << std::endl;
    CHECK(result.number_of_self_intersections_before == before);
    CHECK(result.number_of_self_intersections == after);
    CHECK(after <= before);
  }
}

// all pairs of triangles of many sizes, by groups and one by one; triangles near to a place
void test_groups()
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&]
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return Vector(x, y, z);
  };
  std::vector<Indexed_triangle> triangles(600);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const double size = std::pow(10., -double(i % 4));
    const Vector middle = point();
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangles[i].vertices[k] = 3 * i + k;
      triangles[i].points[k] = middle + size * point();
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> expected;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = i + 1; k < triangles.size(); ++k)
      if (do_triangles_intersect(triangles[i], triangles[k]))
        expected.emplace_back(i, k);
  Hde::internal::Interruption never;
  const Hde::internal::Triangle_groups<CGAL::Parallel_if_available_tag> groups(triangles);
  CHECK(expected.size() > 100);
  CHECK(groups.intersecting_pairs(never) == expected);

  Hde::internal::Triangle_grids grids;
  grids.clear(0.05);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    grids.insert(i, triangles[i]);
  for (std::size_t i = 0; i < triangles.size(); i += 3)
    grids.remove(i);
  for (int query = 0; query < 200; ++query)
  {
    const Vector p = point();
    const double distance = std::pow(10., -double(query % 4));
    const Hde::internal::Triangle_grids::Box box(p - Vector::Constant(distance), p + Vector::Constant(distance));
    std::vector<std::size_t> near, near_by_groups, expected_near;
    groups.for_each_near(p, distance, [&](const std::size_t i) { near_by_groups.push_back(i); });
    std::sort(near_by_groups.begin(), near_by_groups.end());
    grids.for_each_near(box, [&](const std::size_t i, const Indexed_triangle&, const auto&) { near.push_back(i); });
    std::sort(near.begin(), near.end());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (Hde::internal::Triangle_grids::box_of(triangles[i]).intersects(box))
      {
        CHECK(std::binary_search(near_by_groups.begin(), near_by_groups.end(), i));
        if (i % 3 != 0)
          expected_near.push_back(i);
      }
    CHECK(near == expected_near);
  }
}

// faces that are not remeshed are in the way: those of another sphere, which the surface, a larger sphere, crosses
void test_obstacles()
{
  const Mesh input = shapes::to_mesh<Mesh>(awkward_shapes::spheres(0.03));
  shapes::Sphere_function larger_sphere;
  larger_sphere.radius = 1.06;
  std::vector<Mesh::Face_index> first, second;
  for (const Mesh::Face_index f : input.faces())
    (input.point(input.target(input.halfedge(f))).x() < 1.02 ? first : second).push_back(f);
  for (const bool has_tests : {false, true})
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
        first, mesh, larger_sphere, params::do_self_intersection_tests(has_tests));
    const std::size_t number = promises::number_of_self_intersections(mesh);
    std::cout << "spheres that would cross, " << (has_tests ? "tested: " : "") << number << " pairs intersect, "
              << result.number_of_unprojected_vertices << " vertices stay off the surface" << std::endl;
    CHECK((number == 0) == has_tests);
    CHECK((result.number_of_unprojected_vertices > 0) == has_tests);
    for (const Mesh::Face_index f : second)
      CHECK(!mesh.is_removed(f));
  }
}

// Of a shell thinner than its edges each vertex stays on its own side, by an embedding, too.
void test_thin_shell()
{
  Mesh mesh = shapes::to_mesh(awkward_shapes::turned_shell(4, 0.004));
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
      mesh, params::number_of_target_faces(4000).relative_sigma(0.02));
  static constexpr double height = 0.0015; // of the sphere over its facets at most; half of the shell has 0.002
  std::size_t between = 0;
  for (const auto v : mesh.vertices())
  {
    const double radius = std::sqrt(CGAL::squared_distance(mesh.point(v), Point_3(0, 0, 0)));
    between += std::abs(radius - 1) < height || std::abs(radius - 0.996) < height ? 0 : 1;
  }
  std::cout << "a thin shell: " << result.number_of_unprojected_vertices << " vertices unprojected, " << between
            << " on neither side" << std::endl;
  CHECK(CGAL::Polygon_mesh_processing::does_self_intersect(mesh) == false);
  CHECK(between == 0);
  CHECK(100 * result.number_of_unprojected_vertices <= mesh.number_of_vertices());
}

int main()
{
  for (const std::size_t number_of_shared : {0, 1, 2})
  {
    test_pairs(number_of_shared, 4, 1);
    test_pairs(number_of_shared, 1000, 0.37);
  }
  test_guard();
  for (const int first_good_attempt : {1, 2, 3, 9})
    test_attempts(first_good_attempt, false);
  test_attempts(2, true);
  test_sheets();
  test_default();
  test_intersecting_input();
  test_groups();
  test_obstacles();
  test_thin_shell();
  return check_summary();
}
