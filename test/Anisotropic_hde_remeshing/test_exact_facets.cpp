// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Shapes as CAD programs write them, few triangles and long ones, that are to have more of them: the facets themselves are the
// surface, and the mesh stays on them. With fewer, what loses nothing goes first.

#include "cad_shapes.h"
#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/has_long_facets.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/transfer_vertex_property.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <set>
#include <string>
#include <vector>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

bool is_reached(const Hde::Remeshing_result& result, const std::size_t wanted)
{
  return std::abs(double(result.number_of_faces) - double(wanted)) <= 0.01 * double(wanted);
}

// More faces leave the surface by less than the file itself does, which is by the height of an arc over a side.
template <typename NamedParameters>
void check_more_faces(const std::string& name, const Mesh& input, const std::size_t wanted, const double height,
                      const NamedParameters& np)
{
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.number_of_target_faces(wanted));
  const Hde::Distance_measures distance = Hde::measure_distance<Tag>(mesh, input);
  std::cout << name << ": " << result.number_of_faces << " faces of " << wanted << ", " << result.number_of_needles
            << " needles, largest distance " << distance.max() / height << " heights" << std::endl;
  CHECK(is_reached(result, wanted));
  CHECK(result.sigma == 0); // no embedding, and so no function
  CHECK(distance.max() <= height);
  CHECK(distance.rms() <= height / 4);
  remeshing_checks::check_same_topology(input, mesh);
  // at most what a chain of needles has that is not done
  CHECK(10 * result.number_of_needles <= result.number_of_faces);
}

void check_shape(const std::string& name, const Mesh& input, const std::size_t wanted, const double height)
{
  check_more_faces(name, input, wanted, height, params::do_split(true));
  check_more_faces(name + ", sharp", input, wanted, height, params::sharp_angle(40));
}

void test_shapes()
{
  const std::size_t sides = 64, wanted = 1000;
  const double height = cad_shapes::chord_height(sides); // the radius is 1
  check_shape("open cylinder", cad_shapes::cylinder(sides, 1, false), wanted, height);
  check_shape("cylinder", cad_shapes::cylinder(sides, 2, true), wanted, height);
  check_shape("tube", cad_shapes::tube(sides, 1), wanted, height);
  check_shape("cone", cad_shapes::cone_with_tip(sides, 1), wanted, height);
  check_shape("elbow", cad_shapes::elbow(24, 1, true), wanted, cad_shapes::chord_height(24));
  check_shape("plate", cad_shapes::plate(sides / 4, 2), wanted, height);
  check_shape("fillets", cad_shapes::bar_with_fillets(8, 1), wanted, cad_shapes::chord_height(32) / 2);
}

// If it is asked for, the measured error leads for any number of faces: what is split stays where it is.
void test_any_number()
{
  const Mesh input = icosphere(2);
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, params::number_of_target_faces(1000).remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR));
  CHECK(is_reached(result, 1000));
  CHECK(result.sigma == 0);
  CHECK(Hde::measure_distance<Tag>(mesh, input).max() < 0.1 * cad_shapes::chord_height(20));
}

// The locations are those on the caller's faces, not on those that these were split to.
void test_locations()
{
  const Mesh input = cad_shapes::cylinder(48, 1, true);
  Mesh mesh = input;
  const auto location = mesh.add_property_map<Mesh::Vertex_index, Hde::Input_location>("v:location").first;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(800).vertex_location_map(location));
  Mesh copy = input;
  const auto place = copy.add_property_map<Mesh::Vertex_index, double>("v:place").first;
  const auto place_of = [](const Point_3& p) { return p.x() + 2 * p.y() + 3 * p.z(); };
  for (const auto v : copy.vertices())
    place[v] = place_of(copy.point(v));
  const auto transferred = mesh.add_property_map<Mesh::Vertex_index, double>("v:transferred").first;
  Hde::transfer_vertex_property(copy, place, mesh, location, transferred);
  for (const auto v : mesh.vertices())
    CHECK_CLOSE(transferred[v], place_of(mesh.point(v)), 10 * cad_shapes::chord_height(48));
}

// A part of a mesh: the rest stays, nothing intersects it, and the edges between them stay, too.
void test_part()
{
  const Mesh input = cad_shapes::tube(48, 1);
  Mesh mesh = input;
  std::vector<Mesh::Face_index> part;
  for (const auto f : mesh.faces())
    if (PMP::compute_face_normal(f, mesh).z() < 0.5 && PMP::face_area(f, mesh) > 0.2)
      part.push_back(f);
  const std::size_t rest = mesh.number_of_faces() - part.size();
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      part, mesh, params::number_of_target_faces(3 * part.size()).do_self_intersection_tests(true));
  CHECK(rest > 0 && result.number_of_faces + rest == mesh.number_of_faces());
  CHECK(is_reached(result, 3 * part.size()));
  CHECK(CGAL::is_closed(mesh) && CGAL::is_valid_polygon_mesh(mesh));
  CHECK(!PMP::does_self_intersect(mesh));
  CHECK(Hde::measure_distance<Tag>(mesh, input).max() <= 2 * cad_shapes::chord_height(48));
}

// Edges that have to stay are not split.
void test_protected()
{
  const Mesh input = cad_shapes::cylinder(48, 1, false);
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(500).protect_constraints(true));
  CHECK(is_reached(result, 500));
  std::set<Point_3> before, after;
  const auto points_of_boundary = [](const Mesh& m, std::set<Point_3>& points)
  {
    for (const auto v : m.vertices())
      if (m.is_border(v))
        points.insert(m.point(v));
  };
  points_of_boundary(input, before);
  points_of_boundary(mesh, after);
  CHECK(before == after);
}

// Where the rings between the ends are enough to contract, nothing is lost.
void test_fewer_faces()
{
  const std::size_t sides = 64, wanted = 700;
  const Mesh input = cad_shapes::tube(sides, 3);
  const auto check = [&](const auto& np)
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.number_of_target_faces(wanted));
    const double distance = Hde::measure_distance<Tag>(mesh, input).max();
    std::cout << "fewer: " << result.number_of_faces << " faces of " << wanted << ", largest distance " << distance
              << std::endl;
    CHECK(is_reached(result, wanted));
    CHECK(result.has_long_facets);
    CHECK(result.number_of_lone_faces == 0);
    CHECK(distance <= 1e-9);
    remeshing_checks::check_same_topology(input, mesh);
  };
  check(params::do_split(true));
  check(params::sharp_angle(40));
}

// The iterations go by samples, which tell little of exact facets: they do not take the mesh further away. `input` is remeshed to half
// of its faces.
void test_iterations(const std::string& name, Mesh input)
{
  for (const auto v : input.vertices()) // as in binary STL
  {
    const Point_3& p = input.point(v);
    input.point(v) = Point_3(float(p.x()), float(p.y()), float(p.z()));
  }
  const auto distance = [&](const auto& np)
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result =
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.number_of_target_faces(input.number_of_faces() / 2));
    CHECK(is_reached(result, input.number_of_faces() / 2));
    return Hde::measure_distance<Tag>(mesh, input);
  };
  const Hde::Distance_measures before = distance(params::number_of_iterations(0)), after = distance(params::do_split(true));
  std::cout << name << ", iterations: " << before.rms() << " " << before.max() << " before, " << after.rms() << " "
            << after.max() << " after" << std::endl;
  CHECK(after.rms() * after.max() <= 1.1 * before.rms() * before.max());
}

bool is_of_long_facets(const Mesh& mesh) { return Hde::internal::has_long_facets(mesh.faces(), mesh, mesh.points()); }

Mesh voxel_ball(const int radius)
{
  std::vector<std::array<int, 3>> cubes;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      for (int z = -radius; z <= radius; ++z)
        if (x * x + y * y + z * z <= radius * (radius + 1))
          cubes.push_back({{x, y, z}});
  return union_of_cubes(cubes, 1);
}

// Facets of few sides are facets, however they are cut. Where a surface may be meant to be smooth, they are not.
void test_what_is_exact()
{
  for (const std::size_t bands : {1, 3, 5})
    for (const bool is_closed : {true, false})
      CHECK(is_of_long_facets(cad_shapes::cylinder(12, bands, is_closed)));
  for (const std::size_t bands : {1, 3, 5})
    for (const std::size_t sides : {8, 12, 24, 32, 90})
    {
      CHECK(is_of_long_facets(cad_shapes::tube(sides, bands)));
      CHECK(is_of_long_facets(cad_shapes::elbow(sides, bands, true)));
      CHECK(is_of_long_facets(cad_shapes::bar_with_fillets(sides / 4, bands)));
      CHECK(is_of_long_facets(cad_shapes::plate(sides / 4, bands)));
    }
  for (const Mesh& block : {cube(1), cube(6), l_block(1), l_block(2)})
    CHECK(is_of_long_facets(block));
  for (const Mesh& smooth : {icosphere(0), icosphere(1), icosphere(3), torus(12, 8), torus(64, 24), ellipsoid(3),
                             capped_cylinder(32, 16), bumpy_sphere(2), voxel_ball(4)})
    CHECK(!is_of_long_facets(smooth));
}

// By an embedding, the largest distance to the input is at most this one. Returns the result.
template <typename NamedParameters>
Hde::Remeshing_result check_embedding(const std::string& name, const Mesh& input, const std::size_t wanted,
                                      const double largest, const NamedParameters& np)
{
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.number_of_target_faces(wanted));
  const double distance = Hde::measure_distance<Tag>(mesh, input).max();
  std::cout << name << " by an embedding: " << result.number_of_faces << " faces of " << wanted << ", "
            << result.number_of_regions << " regions, sigma " << result.sigma << ", largest distance " << distance << " of "
            << largest << std::endl;
  CHECK(distance <= largest);
  remeshing_checks::check_same_topology(input, mesh);
  return result;
}

// Embeddings keep to the facets, with a sharp angle and without: nothing is lost where the number of faces allows it. With facets
// that are too many or too narrow for that number, it is as by the number alone, without an embedding.
void test_embedding(const std::string& name, const Mesh& input, const bool has_room)
{
  static constexpr double rounding = 1e-9;
  const auto check = [&](const auto& np)
  {
    const Hde::Remeshing_result result = check_embedding(name, input, 1000, rounding, np);
    CHECK(is_reached(result, 1000));
    CHECK(result.has_long_facets == !has_room); // by measured error
    CHECK(result.number_of_needles <= result.number_of_faces / 10);
  };
  check(params::sharp_angle(40).embedding(Hde::Curvature_metric(2)));
  check(params::sharp_angle(40).relative_sigma(0.02));
  check(params::embedding(Hde::Curvature_metric(2)));
  check(params::relative_sigma(0.02));
  check(params::sigma(0.05));
}

// Fewer faces than the facets take: the embedding is no further off than without it.
void test_embedding_with_few_faces()
{
  const Mesh input = cad_shapes::cylinder(360, 1, true);
  Mesh by_number = input;
  const Hde::Remeshing_result of_number = CGAL::anisotropic_hde_remeshing<Tag>(by_number, params::number_of_target_faces(900));
  const double distance = Hde::measure_distance<Tag>(by_number, input).max();
  CHECK(is_reached(of_number, 900));
  CHECK(distance > 0 && distance < 10 * cad_shapes::chord_height(360));
  CHECK(is_reached(check_embedding("360 sides", input, 900, distance, params::relative_sigma(0.02)), 900));
  check_embedding("as many as there are,", input, input.number_of_faces(), 1e-9, params::embedding(Hde::Curvature_metric(2)));
  // the input is not returned where no number is asked for
  Mesh mesh = cad_shapes::cylinder(90, 1, true);
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::sharp_angle(40));
  CHECK(!result.has_long_facets && result.number_of_splits > 0);
}

// What is uniform in the embedding is asked for by its scheme: it cuts across narrow sides, and keeps facets that have room.
void test_embedding_in_any_case()
{
  const Mesh input = cad_shapes::cylinder(90, 1, true);
  const double length = 4. / 3 * std::sqrt(4 / std::sqrt(3.) * PMP::area(input) / 1000); // longer ones are split
  const Hde::Remeshing_result result =
      check_embedding("90 sides", input, 1000, cad_shapes::chord_height(90) + length * length / 8,
                      params::sharp_angle(40).relative_sigma(0.02).remeshing_scheme(Hde::Remeshing_scheme::EMBEDDING));
  CHECK(result.number_of_regions == 3 && !result.has_long_facets);
  CHECK(result.sigma > 0);
  const Hde::Remeshing_result of_block = check_embedding(
      "block", l_block(1), 1000, 1e-9, params::relative_sigma(0.02).remeshing_scheme(Hde::Remeshing_scheme::EMBEDDING));
  CHECK(of_block.number_of_regions == 8 && is_reached(of_block, 1000));
}

// By a length, too, and on some of the faces.
void test_embedding_by_length()
{
  const Mesh input = cad_shapes::cylinder(12, 3, true);
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::target_edge_length(0.25));
  CHECK(result.number_of_regions == 14 && result.number_of_faces > 800);
  CHECK(Hde::measure_distance<Tag>(mesh, input).max() <= 1e-9);
  remeshing_checks::check_same_topology(input, mesh);
  Mesh other = input;
  std::vector<Mesh::Face_index> part;
  for (const auto f : other.faces())
    if (std::abs(PMP::compute_face_normal(f, other).z()) < 0.5)
      part.push_back(f);
  CGAL::anisotropic_hde_remeshing<Tag>(part, other, params::number_of_target_faces(600).relative_sigma(0.02));
  CHECK(Hde::measure_distance<Tag>(other, input).max() <= 1e-9);
  CHECK(CGAL::is_closed(other));
}

// The function is not of facets if anything is asked of it, or the paper's scheme: it rounds a cube, inside of a face, too.
void test_function_asked_for()
{
  const auto distance_of_vertices = [](const auto& np)
  {
    Mesh mesh = cube(6);
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.number_of_target_faces(1000).relative_sigma(0.02));
    double largest = 0;
    for (const auto v : mesh.vertices())
    {
      const Point_3& p = mesh.point(v);
      double inside = 1;
      for (int i = 0; i < 3; ++i)
        inside = (std::min)({inside, std::abs(p[i]), std::abs(1 - p[i])});
      largest = (std::max)(largest, inside);
    }
    std::cout << "cube: vertices up to " << largest << " off its faces" << std::endl;
    return largest;
  };
  CHECK(distance_of_vertices(params::do_split(true)) < 1e-6);
  CHECK(distance_of_vertices(params::detect_edges(false)) > 1e-3);
  CHECK(distance_of_vertices(params::remeshing_scheme(Hde::Remeshing_scheme::PAPER)) > 1e-4);
}

// A triangle without neighbours is counted.
void test_lone_faces()
{
  Mesh mesh = icosphere(2);
  mesh.add_face(mesh.add_vertex(Point_3(3, 0, 0)), mesh.add_vertex(Point_3(4, 0, 0)), mesh.add_vertex(Point_3(3, 1, 0)));
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::number_of_target_faces(100));
  CHECK(result.number_of_lone_faces == 1);
  CHECK(!result.has_long_facets);
}

int main()
{
  test_shapes();
  test_fewer_faces();
  test_iterations("cone", cad_shapes::cone_with_tip(90, 5));
  test_iterations("plate", cad_shapes::plate(22, 5));
  test_iterations("elbow", cad_shapes::elbow(32, 2, true));
  test_what_is_exact();
  for (const bool has_room : {true, false})
  {
    const std::size_t sides = has_room ? 12 : 88;
    test_embedding("cylinder", cad_shapes::cylinder(sides, 3, true), has_room);
    test_embedding("fillets", cad_shapes::bar_with_fillets(sides / 4, has_room ? 1 : 3), has_room);
    test_embedding("plate", cad_shapes::plate(sides / 4, 1), has_room);
  }
  test_embedding("elbow", cad_shapes::elbow(12, 1, true), true);
  test_embedding("cube", cube(6), true);
  test_embedding_with_few_faces();
  test_embedding_in_any_case();
  test_embedding_by_length();
  test_function_asked_for();
  test_lone_faces();
  test_any_number();
  test_locations();
  test_part();
  test_protected();
  return check_summary();
}
