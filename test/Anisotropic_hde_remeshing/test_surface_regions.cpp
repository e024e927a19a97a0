// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Creases and regions: of shapes whose sharp edges are known, of the caller, and none of noise.

#include "check.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace shapes;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
using CGAL::Anisotropic_hde_remeshing::detect_surface_regions;
using CGAL::Anisotropic_hde_remeshing::Surface_regions;
using params::sharp_angle;

struct Found
{
  Surface_regions counts;
  std::vector<bool> is_crease;      // by edge
  std::vector<std::size_t> regions; // by face
  double length = 0;                // of the creases
};

// what is promised of every result
template <typename TriangleMesh>
void check_result(const TriangleMesh& mesh, const Found& found)
{
  std::size_t creases = 0, next_region = 0, i = 0;
  for (const bool is_crease : found.is_crease)
    creases += is_crease ? 1 : 0;
  CHECK(creases == found.counts.number_of_crease_edges);
  for (const std::size_t region : found.regions) // in the order of their first faces
    if (CHECK(region <= next_region) && region == next_region)
      ++next_region;
  CHECK(next_region == found.counts.number_of_regions);
  const auto number = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  for (const auto f : faces(mesh))
    put(number, f, i++);
  i = 0;
  for (const auto e : edges(mesh))
  {
    const bool is_crease = found.is_crease[i++];
    if (is_border(e, mesh))
      CHECK(!is_crease);
    else
      CHECK(is_crease || found.regions[get(number, face(halfedge(e, mesh), mesh))] ==
                             found.regions[get(number, face(opposite(halfedge(e, mesh), mesh), mesh))]);
  }
}

template <typename TriangleMesh, typename NamedParameters>
Found detect(const TriangleMesh& mesh, const NamedParameters& np)
{
  const auto is_crease = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  const auto region = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto vpm = get(CGAL::vertex_point, mesh);
  Found found;
  found.counts = detect_surface_regions(mesh, is_crease, region, np);
  for (const auto e : edges(mesh))
  {
    found.is_crease.push_back(get(is_crease, e));
    if (get(is_crease, e))
      found.length += std::sqrt(CGAL::to_double(CGAL::squared_distance(get(vpm, source(e, mesh)), get(vpm, target(e, mesh)))));
  }
  for (const auto f : faces(mesh))
    found.regions.push_back(get(region, f));
  check_result(mesh, found);
  return found;
}

void check_found(const Mesh& mesh, const double angle, const std::size_t regions, const std::size_t edges, const double length)
{
  const Found found = detect(mesh, sharp_angle(angle));
  CHECK(found.counts.number_of_regions == regions);
  CHECK(found.counts.number_of_crease_edges == edges);
  CHECK(found.counts.number_of_dropped_edges == 0);
  CHECK(found.counts.number_of_joined_specks == 0);
  CHECK_CLOSE(found.length, length, 1e-9);
}

void test_shapes()
{
  for (const double angle : {1., 20., 60., 89.9, 90.})
  {
    check_found(cube(1), angle, 6, 12, 12);
    check_found(cube(7), angle, 6, 84, 12);
    check_found(l_block(1), angle, 8, 22, 22);
    check_found(l_block(4), angle, 8, 88, 22);
  }
  check_found(cube(3), 90.1, 1, 0, 0);
  const double circle = 128 * std::sin(pi / 64);
  for (const unsigned int rows : {1, 20})
    check_found(capped_cylinder(64, rows), 30, 3, 128, 2 * circle);
  check_found(capped_cylinder(64, 20), 5, 66, 128 + 64 * 20, 2 * circle + 128); // its sides turn by 5.6 degrees
  check_found(icosphere(3), 20, 1, 0, 0);
  check_found(half_sphere(12), 30, 1, 0, 0); // the boundary is no crease
  check_found(hills(12), 60, 1, 0, 0);
}

// a tip is no crease, but the rim is
void test_cone()
{
  Mesh mesh;
  CGAL::make_pyramid(48, mesh, Point_3(0, 0, 0), 1.5, 1.);
  const Found found = detect(mesh, sharp_angle(40));
  CHECK(found.counts.number_of_regions == 2);
  CHECK(found.counts.number_of_crease_edges == 48);
}

// what is small is measured by its own component
void test_small_details()
{
  Mesh mesh = cube(40), small = capped_cylinder(12, 1);
  for (const Mesh::Vertex_index v : small.vertices())
    small.point(v) = Point_3(0.5, 0.5, 2) + 0.002 * (small.point(v) - CGAL::ORIGIN);
  CGAL::copy_face_graph(small, mesh);
  CHECK(detect(mesh, sharp_angle(40)).counts.number_of_regions == 9);
}

// no angle: the creases of the caller alone, whatever is sharp
void test_creases_of_caller()
{
  Mesh sphere = icosphere(3);
  auto is_constrained = sphere.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  for (const Mesh::Edge_index e : sphere.edges())
    is_constrained[e] = (sphere.point(sphere.vertex(e, 0)).z() > 0.3) != (sphere.point(sphere.vertex(e, 1)).z() > 0.3);
  // the edges across a strip are an open network of darts and triangles
  Found found = detect(sphere, params::edge_is_constrained_map(is_constrained));
  CHECK(found.counts.number_of_dropped_edges == 0);
  for (const Mesh::Edge_index e : sphere.edges())
    CHECK(found.is_crease[e] == is_constrained[e]);

  // a closed curve, by patches and by edges, which a short dart is added to
  auto patch = sphere.add_property_map<Mesh::Face_index, int>("f:patch", 7).first;
  for (const Mesh::Face_index f : sphere.faces())
    patch[f] = sphere.point(sphere.target(sphere.halfedge(f))).z() > 0.5 ? 7 : -7;
  found = detect(sphere, params::face_patch_map(patch).sharp_angle(60));
  CHECK(found.counts.number_of_regions == 2);
  for (const Mesh::Edge_index e : sphere.edges())
    is_constrained[e] = found.is_crease[e];
  std::size_t i = 0;
  while (is_constrained[Mesh::Edge_index(Mesh::size_type(i))])
    ++i;
  is_constrained[Mesh::Edge_index(Mesh::size_type(i))] = true;
  const Found by_edges = detect(sphere, params::edge_is_constrained_map(is_constrained).sharp_angle(60));
  CHECK(by_edges.counts.number_of_regions == 2);
  CHECK(by_edges.counts.number_of_crease_edges == found.counts.number_of_crease_edges + 1);

  // the maps may be those of the result
  detect_surface_regions(sphere, is_constrained, patch, params::edge_is_constrained_map(is_constrained).face_patch_map(patch));
  for (const Mesh::Face_index f : sphere.faces())
    CHECK(std::size_t(patch[f]) == by_edges.regions[f]);

  for (const Mesh::Edge_index e : sphere.edges())
    is_constrained[e] = true;
  CHECK(detect(sphere, params::edge_is_constrained_map(is_constrained).sharp_angle(10)).counts.number_of_regions ==
        sphere.number_of_faces());
  CHECK(detect(sphere, CGAL::parameters::default_values()).counts.number_of_regions == 1);
  CHECK(detect(cube(2), CGAL::parameters::default_values()).counts.number_of_regions == 1);
}

// single vertices raised to spikes, as scans have them, and the same on a cube: the cube keeps its edges
void test_noise()
{
  Mesh sphere = icosphere(6);
  for (Mesh::size_type i = 0; i < sphere.number_of_vertices(); i += 701)
  {
    Point_3& p = sphere.point(Mesh::Vertex_index(i));
    p = CGAL::ORIGIN + 1.02 * (p - CGAL::ORIGIN);
  }
  const Found found = detect(sphere, sharp_angle(40));
  CHECK(found.counts.number_of_dropped_edges > 200);
  CHECK(found.counts.number_of_crease_edges == 0);
  CHECK(found.counts.number_of_regions == 1);

  Mesh block = cube(80);
  for (const Mesh::Vertex_index v : block.vertices())
  {
    Point_3& p = block.point(v);
    const bool is_inside = p.x() > 0.1 && p.x() < 0.9 && p.y() > 0.1 && p.y() < 0.9;
    if (is_inside && std::lround(80 * p.x()) % 7 == 0 && std::lround(80 * p.y()) % 5 == 0)
      p = p + Vector_3(0, 0, 0.01);
  }
  const Found on_block = detect(block, sharp_angle(30));
  CHECK(on_block.counts.number_of_regions == 6);
  CHECK(on_block.counts.number_of_crease_edges == 960);
  CHECK(on_block.counts.number_of_dropped_edges > 100);
}

// the result is that of the shape in another unit and place
void test_scale()
{
  const Found expected = detect(l_block(3), sharp_angle(45));
  CHECK(expected.counts.number_of_regions == 8);
  for (const double scale : {1e-30, 1e-9, 1e9, 1e30})
    for (const double shift : {0., 7.}) // over the unit
    {
      Mesh mesh = l_block(3);
      for (const Mesh::Vertex_index v : mesh.vertices())
        mesh.point(v) = CGAL::ORIGIN + scale * (Vector_3(1, -2, 3) * shift + (mesh.point(v) - CGAL::ORIGIN));
      const Found found = detect(mesh, sharp_angle(45));
      CHECK(found.is_crease == expected.is_crease);
      CHECK(found.regions == expected.regions);
    }
}

// faces without an area are parts of their neighbours: on a plane, and along a sharp edge
void test_degenerate_faces()
{
  for (const double height : {0., 1e-9})
    for (const bool is_on_edge : {false, true})
    {
      Mesh mesh = cube(2);
      // splits an edge; the vertex in its middle moves along the other edge of one of its two faces
      for (const Mesh::Edge_index e : mesh.edges())
      {
        const Point_3 p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1)), middle = CGAL::midpoint(p, q);
        const bool is_sharp = middle.x() == 0 && middle.y() == 0;
        const bool is_flat = middle.x() == 0.5 && middle.y() == 0.25 && middle.z() == 0;
        if (is_on_edge ? !is_sharp : !is_flat)
          continue;
        const auto h = mesh.halfedge(e);
        const auto v = mesh.target(CGAL::Euler::split_edge(h, mesh));
        // only on one side is the vertex joined to the opposite one: on the other it has a face of its own, on the line p, q
        const auto into = mesh.prev(h);
        CGAL::Euler::split_face(into, mesh.next(mesh.next(into)), mesh);
        const auto o = mesh.opposite(into);
        CGAL::Euler::split_face(o, mesh.next(mesh.next(o)), mesh);
        mesh.point(v) = middle + Vector_3(0, 0, height);
        break;
      }
      CHECK(detect(mesh, sharp_angle(30)).counts.number_of_regions == 6);
    }
  Mesh flat;
  const auto a = flat.add_vertex(Point_3(0, 0, 0)), b = flat.add_vertex(Point_3(1, 0, 0)),
             c = flat.add_vertex(Point_3(2, 0, 0));
  flat.add_face(a, b, c);
  CHECK(detect(flat, sharp_angle(30)).counts.number_of_regions == 1);
  CHECK(detect(Mesh(), sharp_angle(30)).counts.number_of_regions == 0);
}

void test_other_meshes()
{
  Mesh mesh = capped_cylinder(24, 3);
  mesh.add_vertex(Point_3(100, 0, 0)); // isolated
  const Found expected = detect(mesh, sharp_angle(30));
  CHECK(expected.counts.number_of_regions == 3);
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  CHECK(detect(polyhedron, sharp_angle(30)).counts.number_of_crease_edges == 48);
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
  CGAL::Polyhedron_3<Exact_kernel, CGAL::Polyhedron_items_with_id_3> exact;
  CGAL::copy_face_graph(mesh, exact);
  CHECK(detect(exact, sharp_angle(30)).counts.number_of_crease_edges == 48);

  Mesh quads;
  CGAL::make_hexahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0), Point_3(0, 1, 1),
                        Point_3(0, 0, 1), Point_3(1, 0, 1), Point_3(1, 1, 1), quads);
  CHECK(detect(quads, sharp_angle(30)).counts.number_of_regions == 6);
}

void test_machine_parts()
{
  struct Expected
  {
    const char* name;
    double angle;
    std::size_t least_regions, most_regions;
  };
  for (const Expected& expected :
       {Expected{"fandisk", 40, 14, 14}, Expected{"anchor", 30, 17, 17}, Expected{"joint", 60, 10, 10},
        Expected{"part", 40, 5, 5}, Expected{"cheese", 40, 260, 290}, Expected{"elephant", 60, 1, 1}})
  {
    Mesh mesh;
    const std::string file = CGAL::data_file_path(std::string("meshes/") + expected.name + ".off");
    if (!CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh)))
      continue;
    const Surface_regions counts = detect(mesh, sharp_angle(expected.angle)).counts;
    std::cout << expected.name << ": " << counts.number_of_regions << " regions, " << counts.number_of_crease_edges
              << " edges, dropped " << counts.number_of_dropped_edges << std::endl;
    CHECK(counts.number_of_regions >= expected.least_regions && counts.number_of_regions <= expected.most_regions);
  }
}

void test_invalid_input()
{
  const Mesh mesh = cube(1);
  const auto message = [&](const double angle) { return invalid_argument_message([&] { detect(mesh, sharp_angle(angle)); }); };
  CHECK(contains(message(0), "sharp_angle is 0"));
  CHECK(contains(message(180), "sharp_angle is 180"));
  CHECK(contains(message(-1), "sharp_angle is -1"));
  CHECK(contains(message(std::numeric_limits<double>::quiet_NaN()), "sharp_angle is"));
  CHECK(message(1e-3).empty() && message(179.9).empty());
  Mesh broken = mesh;
  broken.point(Mesh::Vertex_index(3)) = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  CHECK(contains(invalid_argument_message([&] { detect(broken, sharp_angle(30)); }), "point of vertex 3"));
}

int main()
{
  test_shapes();
  test_cone();
  test_small_details();
  test_creases_of_caller();
  test_noise();
  test_scale();
  test_degenerate_faces();
  test_other_meshes();
  test_machine_parts();
  test_invalid_input();
  return check_summary();
}
