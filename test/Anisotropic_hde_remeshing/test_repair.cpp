// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What hde_remesh mends: cracks, walls, polygons. What was closed but for cracks is closed after it, what is open stays so, and no
// edge gets more than two faces.

#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/Failure.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/Mesh.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/cracks.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/flat_faces.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/intersecting_faces.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/repair.h"
#include "../../examples/Anisotropic_hde_remeshing/hde_remesh/sides.h"

#include "check.h"
#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Random.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <vector>

using hde_remesh::Mesh;
using hde_remesh::Orientation;
using hde_remesh::Point_3;
using hde_remesh::Repair;
using hde_remesh::Soup;
using hde_remesh::Vector_3;

namespace {

typedef std::vector<std::size_t> Face;

std::size_t number_of_edges_with(const Soup& soup, const std::size_t least, const std::size_t most)
{
  std::size_t number = 0;
  hde_remesh::for_each_edge(hde_remesh::sides_of(soup), [&](const std::vector<std::size_t>& sides)
                            { number += sides.size() >= least && sides.size() <= most ? 1 : 0; });
  return number;
}

std::size_t number_of_boundary_edges(const Soup& soup) { return number_of_edges_with(soup, 1, 1); }
std::size_t number_of_edges_of_many(const Soup& soup) { return number_of_edges_with(soup, 3, 1000); }

Soup sphere(const unsigned int level)
{
  const shapes::Soup soup = shapes::icosphere_soup(level);
  Soup result;
  result.points = soup.points;
  for (const auto& face : soup.triangles)
    result.faces.emplace_back(face.begin(), face.end());
  return result;
}

// each face has points of its own, up to `distance` from where they were
Soup torn(const Soup& soup, const double distance, CGAL::Random& random)
{
  Soup result;
  for (const Face& face : soup.faces)
  {
    result.faces.emplace_back();
    for (const std::size_t v : face)
    {
      Vector_3 d(random.uniform_real(-1., 1.), random.uniform_real(-1., 1.), random.uniform_real(-1., 1.));
      d = d / (std::max)(1., std::sqrt(d.squared_length()));
      result.faces.back().push_back(result.points.size());
      result.points.push_back(soup.points[v] + distance * d);
    }
  }
  return result;
}

Soup moved(Soup soup, const Vector_3& by)
{
  for (Point_3& p : soup.points)
    p = p + by;
  return soup;
}

Soup sum_of(const Soup& a, const Soup& b)
{
  Soup result = a;
  result.points.insert(result.points.end(), b.points.begin(), b.points.end());
  for (Face face : b.faces)
  {
    for (std::size_t& v : face)
      v += a.points.size();
    result.faces.push_back(face);
  }
  return result;
}

void test_cracks()
{
  CGAL::Random random(1);
  const Soup whole = sphere(2);
  for (const double size : {1e-7, 1e-4, 1e-2})
  {
    Soup soup = torn(whole, size, random);
    const std::size_t number = hde_remesh::close_cracks(soup, 2 * size, Orientation::OPPOSITE);
    CHECK(number == 3 * whole.faces.size() - whole.points.size());
    CHECK(soup.points.size() == whole.points.size());
    CHECK(soup.faces.size() == whole.faces.size());
    CHECK(number_of_boundary_edges(soup) == 0 && number_of_edges_of_many(soup) == 0);
    for (std::size_t f = 0; f < soup.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(std::sqrt(CGAL::squared_distance(soup.points[soup.faces[f][k]], whole.points[whole.faces[f][k]])) <=
              1.001 * size);
    CHECK(hde_remesh::close_cracks(soup, 2 * size, Orientation::OPPOSITE) == 0);
  }
  // half of the cracks are wider than the tolerance
  Soup soup = torn(whole, 1e-3, random);
  hde_remesh::close_cracks(soup, 1e-3, Orientation::OPPOSITE);
  CHECK(number_of_boundary_edges(soup) > 0 && number_of_boundary_edges(soup) < 3 * whole.faces.size());
  CHECK(number_of_edges_of_many(soup) == 0);
}

// a longer length than that of the edges
void test_too_long_a_length()
{
  CGAL::Random random(2);
  Soup soup = torn(sphere(1), 1e-6, random);
  const Soup before = soup;
  CHECK(hde_remesh::close_cracks(soup, 10, Orientation::OPPOSITE) == 0);
  CHECK(soup.points == before.points && soup.faces == before.faces);
}

// faces that are turned fit each other only where they are oriented later
void test_orientation()
{
  CGAL::Random random(3);
  const Soup whole = sphere(1);
  Soup soup = torn(whole, 1e-6, random);
  for (std::size_t f = 0; f < soup.faces.size(); f += 3)
    std::swap(soup.faces[f][1], soup.faces[f][2]);
  Soup same = soup;
  hde_remesh::close_cracks(same, 1e-5, Orientation::OPPOSITE);
  CHECK(number_of_boundary_edges(same) > 0);
  hde_remesh::close_cracks(soup, 1e-5, Orientation::ANY);
  CHECK(number_of_boundary_edges(soup) == 0 && soup.points.size() == whole.points.size());
}

// Nothing becomes worse: where three sheets meet, two are joined, and where solids come near to each other, none.
void test_nothing_worse()
{
  Soup book;
  for (const double angle : {0., 2., 4.})
  {
    const std::size_t first = book.points.size();
    for (const Point_3& p : {Point_3(0, 0, 0), Point_3(0, 0, 1), Point_3(std::cos(angle), std::sin(angle), 0)})
      book.points.push_back(p + 1e-7 * Vector_3(angle, angle, angle));
    book.faces.push_back(angle == 2. ? Face{first + 1, first, first + 2} : Face{first, first + 1, first + 2});
  }
  CHECK(hde_remesh::close_cracks(book, 1e-5, Orientation::OPPOSITE) == 2);
  CHECK(number_of_edges_of_many(book) == 0 && number_of_boundary_edges(book) == 7);

  const Soup whole = sphere(1);
  Soup two = sum_of(whole, moved(whole, Vector_3(1e-7, 0, 0)));
  CHECK(hde_remesh::close_cracks(two, 1e-5, Orientation::ANY) == 0);
}

// What may not be joined: two corners of a face, an edge with four faces, sheets that meet in points and are joined in part.
void test_guards()
{
  Soup hole = sphere(1);
  const Face lost = hole.faces.back();
  hole.faces.pop_back();
  hole.points[lost[1]] = hole.points[lost[0]] + Vector_3(1e-7, 0, 0); // it is an edge of a face beside the hole
  CHECK(hde_remesh::close_cracks(hole, 1e-5, Orientation::OPPOSITE) == 0);

  Soup square;
  square.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)};
  square.faces = {{0, 1, 2}, {0, 2, 3}};
  Soup back = moved(square, Vector_3(0, 0, 1e-7));
  back.faces = {{2, 1, 0}, {3, 2, 0}};
  Soup both = sum_of(square, back);
  CHECK(hde_remesh::close_cracks(both, 1e-5, Orientation::OPPOSITE) == 0);

  Soup tie; // two sheets in a point, of which one fits one of two others in a point near to it
  tie.points = {Point_3(0, 0, 0),    Point_3(1, 0, 0),    Point_3(0, 1, 0), Point_3(-1, 0, 0), Point_3(0, -1, 0),
                Point_3(0, 0, 1e-7), Point_3(1, 0, 1e-7), Point_3(1, 0, 1), Point_3(-1, 0, 1), Point_3(-1, 1, 1)};
  tie.faces = {{0, 1, 2}, {0, 3, 4}, {6, 5, 7}, {5, 8, 9}};
  CHECK(hde_remesh::close_cracks(tie, 1e-5, Orientation::OPPOSITE) == 0);
}

void test_width()
{
  CGAL::Random random(4);
  const Soup whole = sphere(1);
  Soup soup = torn(whole, 1e-6, random);
  const auto width = hde_remesh::width_of_cracks(soup, 1e-5);
  CHECK(width && *width > 5e-7 && *width <= 2e-6);
  Soup closed = soup;
  hde_remesh::close_cracks(closed, width.value_or(0), Orientation::OPPOSITE);
  CHECK(number_of_boundary_edges(closed) == 0);
  CHECK(!hde_remesh::width_of_cracks(soup, 1e-7));
  soup.faces.pop_back(); // a hole
  CHECK(!hde_remesh::width_of_cracks(soup, 1e-5));
  CHECK(!hde_remesh::width_of_cracks(whole, 1e-5));
}

// the unit cube from (x, y, z) on; without the side at x, if it is not wanted
void add_cube(Soup& soup, const std::size_t x, const std::size_t y, const std::size_t z, const bool has_first_side)
{
  const auto at = [](const std::size_t i, const std::size_t k, const std::size_t l) { return 9 * i + 3 * k + l; };
  const std::size_t X = x + 1, Y = y + 1, Z = z + 1;
  std::vector<std::array<std::size_t, 4>> quads = {{at(X, y, z), at(X, Y, z), at(X, Y, Z), at(X, y, Z)},
                                                   {at(x, y, z), at(X, y, z), at(X, y, Z), at(x, y, Z)},
                                                   {at(x, Y, z), at(x, Y, Z), at(X, Y, Z), at(X, Y, z)},
                                                   {at(x, y, z), at(x, Y, z), at(X, Y, z), at(X, y, z)},
                                                   {at(x, y, Z), at(X, y, Z), at(X, Y, Z), at(x, Y, Z)}};
  if (has_first_side)
    quads.push_back({at(x, y, z), at(x, y, Z), at(x, Y, Z), at(x, Y, z)});
  for (const auto& q : quads)
  {
    soup.faces.push_back({q[0], q[1], q[2]});
    soup.faces.push_back({q[0], q[2], q[3]});
  }
}

Soup grid()
{
  Soup soup;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        soup.points.emplace_back(x, y, z);
  return soup;
}

Mesh mesh_of(const Soup& soup, Repair& repair)
{
  return hde_remesh::mesh_of_soup(hde_remesh::repaired(soup, 0, repair), "soup").mesh;
}

std::size_t number_of_components(const Mesh& mesh)
{
  Mesh copy = mesh;
  auto map = copy.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  return CGAL::Polygon_mesh_processing::connected_components(copy, map);
}

void check_solids(const Soup& soup, const std::size_t number, const double volume, const std::size_t wall_faces)
{
  Repair repair;
  const Mesh mesh = mesh_of(soup, repair);
  CHECK(CGAL::is_closed(mesh));
  CHECK(number_of_components(mesh) == number);
  CHECK(std::abs(CGAL::Polygon_mesh_processing::volume(mesh) - volume) < 1e-12);
  CHECK(repair.wall_faces == wall_faces);
  std::cout << repair.text() << std::endl;
}

void test_walls()
{
  Soup twice = grid(), once = grid(), four = grid(), edge = grid();
  add_cube(twice, 0, 0, 0, true);
  add_cube(twice, 1, 0, 0, true);
  check_solids(twice, 1, 2, 4);
  add_cube(once, 0, 0, 0, true);
  add_cube(once, 1, 0, 0, false);
  check_solids(once, 1, 2, 2);
  for (const std::size_t x : {0, 1})
    for (const std::size_t y : {0, 1})
      add_cube(four, x, y, 0, true);
  check_solids(four, 1, 4, 16);
  // the wall is there twice, with different diagonals; and the second cube looks inward
  Soup crossed = twice, inward = twice;
  Face &a = crossed.faces[crossed.faces.size() - 2], &b = crossed.faces.back();
  const Face quad = {a[0], a[1], a[2], b[2]};
  a = {quad[0], quad[1], quad[3]};
  b = {quad[1], quad[2], quad[3]};
  check_solids(crossed, 2, 2, 0);
  for (std::size_t f = inward.faces.size() / 2; f < inward.faces.size(); ++f)
    std::swap(inward.faces[f][0], inward.faces[f][1]);
  check_solids(inward, 1, 2, 2);
  // the cubes touch in an edge: they are two, without a wall; the edge is in two parts, as those of two cubes each
  add_cube(edge, 0, 0, 0, true);
  add_cube(edge, 1, 1, 0, true);
  check_solids(edge, 2, 2, 0);
  add_cube(edge, 0, 0, 1, true);
  add_cube(edge, 1, 1, 1, true);
  check_solids(edge, 2, 4, 8);
}

// Cubes of a grid at random: they touch each other in faces, edges and points. Only the outer faces are there, two triangles each.
Soup surface_of_cubes(const std::set<std::array<int, 3>>& cubes, const int n)
{
  typedef std::array<int, 3> Place;
  Soup soup;
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= n; ++y)
      for (int z = 0; z <= n; ++z)
        soup.points.emplace_back(x, y, z);
  const auto number = [n](const Place& p) { return std::size_t((p[0] * (n + 1) + p[1]) * (n + 1) + p[2]); };
  for (const Place& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1})
      {
        Place neighbor = cube, a = cube;
        neighbor[axis] += side == 1 ? 1 : -1;
        if (cubes.count(neighbor) > 0)
          continue;
        a[axis] += side;
        Place b = a, c = a, d = a;
        ++b[(axis + 1) % 3];
        ++c[(axis + 1) % 3];
        ++c[(axis + 2) % 3];
        ++d[(axis + 2) % 3];
        if (side == 0)
          std::swap(b, d);
        soup.faces.push_back({number(a), number(b), number(c)});
        soup.faces.push_back({number(a), number(c), number(d)});
      }
  return soup;
}

void test_touching_cubes()
{
  std::mt19937 random(1); // the same everywhere
  for (int trial = 0; trial < 200; ++trial)
  {
    std::set<std::array<int, 3>> cubes;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z)
          if (random() % 3 == 0)
            cubes.insert({x, y, z});
    Repair repair;
    const Mesh mesh = mesh_of(surface_of_cubes(cubes, 4), repair);
    CHECK(CGAL::is_closed(mesh));
    CHECK(CGAL::is_closed(mesh) && std::abs(CGAL::Polygon_mesh_processing::volume(mesh) - double(cubes.size())) < 1e-9);
    CHECK(repair.wall_faces == 0 && repair.turned_faces == 0);
  }
}

// no solids: a square with two sides, and three sheets that meet in an edge
void test_no_walls()
{
  Soup square;
  square.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)};
  square.faces = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  Repair repair;
  CHECK(mesh_of(square, repair).number_of_faces() == 2);
  CHECK(repair.wall_faces == 0 && repair.removed_faces == 2);

  Soup book;
  book.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, -1, 0), Point_3(0, 0, 1)};
  book.faces = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  Repair of_book;
  CHECK(mesh_of(book, of_book).number_of_faces() == 3);
  CHECK(of_book.wall_faces == 0);
}

// Polygons whose diagonals are edges of other faces: the other diagonal, or, where that lies outside, a point on the first.
void test_diagonals()
{
  for (const double corner : {1., .25})
  {
    Soup soup;
    soup.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(corner, corner, 0), Point_3(0, 1, 0), Point_3(.4, .4, -1)};
    // above a quad; below a tent over the diagonal that divides it best, from which a fifth point hangs
    soup.faces = {{0, 1, 2, 3}, {0, 2, 1}, {2, 0, 3}};
    Repair repair;
    Soup repaired = hde_remesh::repaired(soup, 0, repair);
    CHECK(repair.divided_faces == 1);
    CHECK(number_of_boundary_edges(repaired) == 0 && number_of_edges_of_many(repaired) == 0);
    CHECK(repair.added_points == (corner < .5 ? 1 : 0));
    CHECK(hde_remesh::mesh_of_soup(repaired, "quad").mesh.number_of_faces() == (corner < .5 ? 6u : 4u));
  }
}

// Faces without area go, the surface stays: those between an edge and its parts, and those at an edge of no length.
void test_flat_faces()
{
  Soup soup = sphere(2);
  for (std::size_t f = 0; f < 10; ++f)
  {
    const Face face = soup.faces[7 * f];
    const std::size_t middle = soup.points.size();
    const Point_3 &a = soup.points[face[0]], &b = soup.points[face[1]];
    soup.points.push_back(f % 2 == 0 ? a + Vector_3(1e-13, 0, 0) : CGAL::midpoint(a, b));
    soup.faces[7 * f] = {face[0], middle, face[2]};
    soup.faces.push_back({middle, face[1], face[2]});
    soup.faces.push_back({face[0], face[1], middle});
  }
  Mesh mesh = hde_remesh::mesh_of_soup(soup, "sphere").mesh;
  const double volume = CGAL::Polygon_mesh_processing::volume(mesh);
  const hde_remesh::Flat_faces flat = hde_remesh::remove_flat_faces(mesh, 1e-12);
  CHECK(flat.number == 15 && flat.number_left == 0); // two at each edge of no length, and those under the middles
  CHECK(CGAL::is_closed(mesh) && number_of_components(mesh) == 1);
  CHECK(std::abs(CGAL::Polygon_mesh_processing::volume(mesh) - volume) < 1e-11);
  const hde_remesh::Flat_faces again = hde_remesh::remove_flat_faces(mesh, 1e-12);
  CHECK(again.number == 0);

  Soup flat_only; // nothing would be left of it
  flat_only.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(2, 0, 0)};
  flat_only.faces = {{0, 1, 2}};
  Mesh line = hde_remesh::mesh_of_soup(flat_only, "line").mesh;
  const hde_remesh::Flat_faces of_line = hde_remesh::remove_flat_faces(line, 0);
  CHECK(of_line.number == 1 && of_line.number_left == 1 && line.number_of_faces() == 1);
}

// A vertex drawn through the other side of a sphere comes back, and all else stays. Spheres that cross stay as they are: nothing but
// another topology would part them.
void test_intersecting_faces()
{
  Soup soup = sphere(3);
  soup.points[0] = CGAL::ORIGIN - 1.5 * (soup.points[0] - CGAL::ORIGIN);
  Mesh mesh = hde_remesh::mesh_of_soup(soup, "pierced sphere").mesh;
  const std::size_t number_of_points = mesh.number_of_vertices();
  const hde_remesh::Intersecting_faces pairs = hde_remesh::untangle(mesh);
  std::cout << "a pierced sphere: " << pairs.number << " pairs, " << pairs.number_left << " left, "
            << pairs.number_of_new_points << " points moved" << std::endl;
  CHECK(pairs.number > 0 && pairs.number_left == 0);
  CHECK(!CGAL::Polygon_mesh_processing::does_self_intersect(mesh));
  CHECK(CGAL::is_closed(mesh) && number_of_components(mesh) == 1);
  CHECK(pairs.number_of_new_points < number_of_points / 4);
  const hde_remesh::Intersecting_faces again = hde_remesh::untangle(mesh);
  CHECK(again.number == 0 && again.number_of_new_points == 0);

  Soup two = sphere(2);
  const std::size_t n = two.points.size(), m = two.faces.size();
  for (std::size_t i = 0; i < n; ++i)
    two.points.push_back(two.points[i] + Vector_3(1, 0.1, 0.2));
  for (std::size_t f = 0; f < m; ++f)
    two.faces.push_back({two.faces[f][0] + n, two.faces[f][1] + n, two.faces[f][2] + n});
  Mesh spheres = hde_remesh::mesh_of_soup(two, "spheres that cross").mesh;
  const hde_remesh::Intersecting_faces crossing = hde_remesh::untangle(spheres);
  CHECK(crossing.number > 0 && crossing.number_left <= crossing.number);
  CHECK(CGAL::is_closed(spheres) && number_of_components(spheres) == 2);
}

} // namespace

int main()
{
  test_cracks();
  test_too_long_a_length();
  test_orientation();
  test_nothing_worse();
  test_guards();
  test_width();
  test_walls();
  test_touching_cubes();
  test_no_walls();
  test_diagonals();
  test_flat_faces();
  test_intersecting_faces();
  return check_summary();
}
