// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Sharp edges: creases, corners and flat faces are kept, and what is promised of every mesh holds between them.

#include "crease_checks.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/Euler_operations.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace crease_checks;
using namespace remeshing_checks;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// --- remeshing ---

// stops after some questions; counts them in all of its copies
struct Limited_visitor : Hde::Remeshing_visitor
{
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  std::shared_ptr<std::size_t> questions = std::make_shared<std::size_t>(0);

  bool go_further() { return (*questions)++ < limit; }
};

// on the function of the regions of the mesh
template <typename AnyFunction>
Remeshing<AnyFunction> remesh_on(const AnyFunction& function, const Mesh& mesh, const std::size_t faces, const double sigma)
{
  Remeshing<AnyFunction> r{mesh, mesh, function, {}};
  r.result = CGAL::anisotropic_hde_remeshing<Tag>(r.after, function,
                                                  params::number_of_target_faces(faces)
                                                      .relative_sigma(sigma)
                                                      .face_patch_map(regions_of(r.after))
                                                      .edge_is_constrained_map(creases_of(r.after))
                                                      .vertex_is_constrained_map(fixed_of(r.after))
                                                      .visitor(Limited_visitor()));
  return r;
}

Remeshing<Function> remesh(Mesh mesh, const double angle, const std::size_t faces, const double sigma = 0.1)
{
  const Function function = detect(mesh, angle);
  return remesh_on(function, mesh, faces, sigma);
}

// the same in one call; of all faces if none are given
Hde::Remeshing_result remesh_at_once(Mesh& mesh, const double angle, const std::size_t faces, const double sigma = 0.1,
                                     const Limited_visitor& visitor = Limited_visitor(),
                                     const std::vector<Mesh::Face_index>& range = {})
{
  const auto np = params::sharp_angle(angle)
                      .number_of_target_faces(faces)
                      .relative_sigma(sigma)
                      .edge_is_constrained_map(creases_of(mesh))
                      .vertex_is_constrained_map(fixed_of(mesh))
                      .visitor(visitor);
  return range.empty() ? CGAL::anisotropic_hde_remeshing<Tag>(mesh, np) : CGAL::anisotropic_hde_remeshing<Tag>(range, mesh, np);
}

// --- cylinders ---

// vertices on the circles, the caps and the side, which may be that far away; the numbers of the pieces are those of can()
void check_can(Mesh& mesh, const double circle, const double cap, const double side)
{
  const auto regions = vertices_of_regions(mesh);
  if (!CHECK(regions.size() == 3))
    return;
  std::map<Mesh::Vertex_index, double> off_circle;
  double off_cap = 0, off_side = 0;
  for (const auto& region : regions)
    for (const Mesh::Vertex_index v : region.second)
    {
      const double radius = std::hypot(mesh.point(v).x(), mesh.point(v).y());
      if (region.first > 0)
      {
        off_cap = (std::max)(off_cap, std::abs(mesh.point(v).z() - (region.first == 1 ? -1 : 1)));
        if (regions.at(0).count(v) == 1)
          off_circle[v] = std::abs(radius - 1);
      }
      else if (std::abs(mesh.point(v).z()) < 1 - 1e-6)
        off_side = (std::max)(off_side, std::abs(radius - 1));
    }
  double largest = 0;
  for (const auto& v : off_circle)
    largest = (std::max)(largest, v.second);
  CHECK(off_circle.size() >= 6);
  CHECK_CLOSE(largest, 0, circle);
  CHECK_CLOSE(off_cap, 0, cap);
  CHECK_CLOSE(off_side, 0, side);
}

// how far a polygon in the unit circle is off it, which vertices of its creases are put on: over the diagonal
double sagitta(const int sides, const Mesh& mesh) { return (1 - std::cos(pi / sides)) / bounding_box_diagonal(mesh); }

// of functions from the vertices of cylinders and cones of 64 sides from the exact ones, as test_piecewise_function measures it
constexpr double accuracy = 1e-4;

void test_own_pieces()
{
  const Mesh mesh = can(64, 100);
  for (const std::size_t faces : {2000, 20000})
  {
    Remeshing<Can_function> r = remesh_on(Can_function(), mesh, faces, 0.1);
    check("own pieces", r, largest_deviation + sagitta(64, mesh));
    check_creases_on_surface(r);
    check_can(r.after, 1e-9, 1e-12, 1e-9);
    check_number_of_faces(r.after, faces);
    CHECK(r.result.curves_after.number_of_curves == 2 && r.result.curves_after.number_of_corners == 0);
  }
}

void test_cylinder()
{
  // with the numbers of the regions as in can()
  Mesh mesh = can(64, 100);
  const Function function(mesh, regions_of(mesh));
  {
    Mesh detected = capped_cylinder(64, 100);
    detect(detected, 40);
    bool is_same = true;
    for (const Mesh::Edge_index e : mesh.edges())
      is_same = is_same && creases_of(mesh)[e] == creases_of(detected)[e];
    CHECK(is_same);
  }
  for (const std::size_t faces : {2000, 8000, 30000})
  {
    Remeshing<Function> r = remesh_on(function, mesh, faces, 0.1);
    check("cylinder", r, largest_deviation + sagitta(64, mesh) + accuracy / bounding_box_diagonal(mesh));
    check_creases_on_surface(r);
    check_can(r.after, accuracy, 1e-12, accuracy);
    check_number_of_faces(r.after, faces);
    CHECK(!PMP::does_self_intersect<Tag>(r.after));
    CHECK(r.result.number_of_regions == 3);
    CHECK(r.result.curves_before.number_of_curves == 2 && r.result.curves_before.number_of_corners == 0);
  }
}

// --- flat faces ---

double area(const std::size_t region, Mesh& mesh)
{
  double sum = 0;
  for (const Mesh::Face_index f : mesh.faces())
    sum += regions_of(mesh)[f] == region ? CGAL::to_double(PMP::face_area(f, mesh)) : 0;
  return sum;
}

// every region lies in the plane of one coordinate, exactly, as before, and covers as much of it
void check_flat(Remeshing<Function>& r)
{
  const auto before = vertices_of_regions(r.before), after = vertices_of_regions(r.after);
  for (const auto& region : before)
  {
    CHECK_CLOSE(area(region.first, r.after), area(region.first, r.before), 1e-12);
    const Point_3 p = r.before.point(*region.second.begin());
    const auto distance = [&](const Mesh& mesh, const std::set<Mesh::Vertex_index>& vertices, const int axis)
    {
      double largest = 0;
      for (const Mesh::Vertex_index v : vertices)
        largest = (std::max)(largest, std::abs(mesh.point(v)[axis] - p[axis]));
      return largest;
    };
    int axis = 0;
    while (axis < 2 && distance(r.before, region.second, axis) > 0)
      ++axis;
    CHECK_CLOSE(distance(r.before, region.second, axis), 0, 0);
    CHECK_CLOSE(distance(r.after, after.at(region.first), axis), 0, 1e-14);
  }
}

// the areas of the sides in ascending order, how many edges and corners
void test_block(const std::string& name, const Mesh& mesh, const std::size_t coarse, const std::vector<double>& areas,
                const std::size_t number_of_edges, const std::size_t number_of_corners)
{
  for (const std::size_t faces : {coarse, number_of_faces_of(mesh), 4 * number_of_faces_of(mesh)})
  {
    Remeshing<Function> r = remesh(mesh, 40, faces);
    check(name, r, 1e-14);
    check_flat(r);
    CHECK(r.result.curves_after.number_of_curves == number_of_edges);
    CHECK(r.result.curves_after.number_of_corners == number_of_corners);
    std::vector<double> found;
    for (std::size_t i = 0; i < r.result.number_of_regions; ++i)
      found.push_back(area(i, r.after));
    std::sort(found.begin(), found.end());
    if (CHECK(found.size() == areas.size()))
      for (std::size_t i = 0; i < areas.size(); ++i)
        CHECK_CLOSE(found[i], areas[i], 1e-12);
    if (faces == coarse)
      CHECK(number_of_faces_of(r.after) < mesh.number_of_faces() / 4);
    else
      check_number_of_faces(r.after, faces);
  }
}

void test_blocks()
{
  test_block("cube", cube(8), 48, {1, 1, 1, 1, 1, 1}, 12, 8);
  test_block("L", l_block(6), 112, {1, 1, 1, 1, 2, 2, 3, 3}, 18, 12);
}

// --- other shapes ---

// the axis of z, apex at z = 1, the base in z = 0; squares up the side and on the base
Mesh cone(const std::size_t segments, const std::size_t rings)
{
  Soup soup;
  soup.points = {Point_3(0, 0, 1), Point_3(0, 0, 0)};
  const auto add_circle = [&](const double radius, const double z)
  {
    for (std::size_t i = 0; i < segments; ++i)
    {
      const double u = 2 * pi * double(i) / double(segments);
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), z);
    }
  };
  for (std::size_t k = 1; k <= rings; ++k)
    add_circle(double(k) / double(rings), 1 - double(k) / double(rings));
  for (std::size_t k = rings - 1; k > 0; --k)
    add_circle(double(k) / double(rings), 0);
  const std::size_t last = soup.points.size() - segments;
  for (std::size_t i = 0; i < segments; ++i)
  {
    const std::size_t next = (i + 1) % segments;
    soup.triangles.push_back({0, 2 + i, 2 + next});
    for (std::size_t a = 2; a < last; a += segments)
    {
      soup.triangles.push_back({a + i, a + segments + i, a + segments + next});
      soup.triangles.push_back({a + i, a + segments + next, a + next});
    }
    soup.triangles.push_back({last + i, 1, last + next});
  }
  return to_mesh(soup);
}

void test_cone()
{
  for (const std::size_t faces : {600, 6000})
  {
    Remeshing<Function> r = remesh(cone(64, 12), 40, faces);
    check("cone", r, largest_deviation + sagitta(64, r.before) + accuracy / bounding_box_diagonal(r.before));
    check_creases_on_surface(r);
    CHECK(r.result.number_of_regions == 2);
    CHECK(r.result.curves_after.number_of_curves == 1 && r.result.curves_after.number_of_corners == 0);
    double largest = 0;
    for (const Mesh::Edge_index e : r.after.edges())
      if (creases_of(r.after)[e])
        largest = (std::max)(largest, std::abs(r.after.point(r.after.vertex(e, 0)).z()));
    CHECK_CLOSE(largest, 0, 1e-9);
  }
}

// A polygon as good as the circle: edges are joined, but only as long as it stays so. Vertices are within twice the height of the
// arcs over its sides. Where the needles of the side meet in the tip, the function leads nowhere.
void test_fine_crease()
{
  for (const std::size_t faces : {800, 5000})
  {
    Remeshing<Function> r = remesh(cone(400, 4), 40, faces);
    check("fine crease", r, largest_deviation + 2 * sagitta(400, r.before), false);
    check_creases_on_surface(r);
    const std::size_t number = creases::segments(r.after, creases_of(r.after)).size();
    CHECK(number < 300);
    CHECK(number > 100);
  }
}

// a curve of the user's, over which the surface is smooth
void test_marked_curve()
{
  Mesh mesh = icosphere(4);
  const auto is_above = [&](const Mesh::Halfedge_index h)
  {
    double z = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(h))
      z += mesh.point(v).z();
    return z > 1e-9;
  };
  for (const Mesh::Edge_index e : mesh.edges())
    creases_of(mesh)[e] = is_above(mesh.halfedge(e)) != is_above(mesh.opposite(mesh.halfedge(e)));
  for (const std::size_t faces : {2000, 9000})
  {
    Remeshing<Function> r = remesh(mesh, 90, faces);
    check("sphere with a curve", r);
    CHECK(r.result.number_of_regions == 2);
  }
}

// A plate of two patches, with n squares along the border between them, which winds and trembles.
Mesh plate_with_winding_curve(const std::size_t n, const double waves, const double tremor)
{
  const std::size_t m = n / 4;
  Soup soup;
  for (std::size_t j = 0; j <= 2 * m; ++j)
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double x = 2 * double(i) / double(n), t = double(j) / double(m) - 1;
      const double bend = 0.01 * std::sin(waves * pi * x) * (1 + 0.5 * std::sin(17 * x)) + tremor * std::sin(double(i * i));
      soup.points.emplace_back(x, t / 2 + (1 - std::abs(t)) * bend, 0);
    }
  for (std::size_t j = 0; j < 2 * m; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  Mesh mesh = to_mesh(soup);
  const Regions regions = regions_of(mesh);
  for (const Mesh::Face_index f : mesh.faces())
    regions[f] = std::size_t(f) < 2 * m * n ? 0 : 1;
  const Creases creases = creases_of(mesh);
  for (const Mesh::Edge_index e : mesh.edges())
    creases[e] =
        !mesh.is_border(e) && regions[mesh.face(mesh.halfedge(e))] != regions[mesh.face(mesh.opposite(mesh.halfedge(e)))];
  return mesh;
}

// Where edges are as long as the bound lets them be, vertices that slide at once must keep it, too, and parts of an edge along which
// the curve trembles by nearly as much.
void test_bound_of_deviation()
{
  for (const auto& [waves, tremor] : {std::make_pair(4., 0.), std::make_pair(4., 8e-5), std::make_pair(0., 1.1e-4)})
    for (const std::size_t faces : {200, 1000})
    {
      Remeshing<Function> r = remesh(plate_with_winding_curve(100, waves, tremor), 40, faces);
      check("winding curve", r);
      // there is no more to keep than the bound: edges were joined
      CHECK(creases::segments(r.after, creases_of(r.after)).size() < 300);
      CHECK(r.result.number_of_regions == 2);
    }
}

// the lower half of the cube: creases that end at the boundary
void test_open_box()
{
  Mesh mesh = cube(8);
  for (const Mesh::Face_index f : cube(8).faces())
  {
    double z = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      z += mesh.point(v).z();
    if (z > 1.5)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  for (const std::size_t faces : {60, 3000})
  {
    Remeshing<Function> r = remesh(mesh, 40, faces);
    check("open box", r, 1e-14);
    check_flat(r);
    CHECK(r.result.number_of_regions == 5);
    CHECK(r.result.curves_after.number_of_curves == 12 && r.result.curves_after.number_of_corners == 8);
  }
}

// a plate with a bend on x = 0 which fades out inside
void test_dart()
{
  static constexpr std::size_t n = 32;
  Soup soup;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double x = 2 * double(i) / double(n) - 1, y = 2 * double(j) / double(n);
      const double slope = 1.2 * std::pow((std::max)(0., 1 - y / 1.5), 2);
      soup.points.emplace_back(x, y, (std::max)(0., x) * slope);
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  for (const std::size_t faces : {800, 6000})
  {
    Remeshing<Function> r = remesh(to_mesh(soup), 20, faces);
    check("dart", r);
    // there is a curve inside besides the boundary, on the bend
    CHECK(r.result.curves_after.length > 8.5);
    double largest = 0;
    for (const Mesh::Edge_index e : r.after.edges())
      if (creases_of(r.after)[e] && !r.after.is_border(e))
        largest = (std::max)(largest, std::abs(r.after.point(r.after.vertex(e, 0)).x()));
    CHECK_CLOSE(largest, 0, 0.1);
  }
}

// --- the one call ---

// of a result whose regions have numbers of their own, on the function of the input
void check_promises(const Mesh& before, Mesh& mesh, const Function& function, const Hde::Remeshing_result& result)
{
  const Regions regions = regions_of(mesh);
  std::map<std::size_t, std::size_t> pieces; // to which each region is nearest
  for (const auto& region : vertices_of_regions(mesh))
  {
    std::map<double, std::size_t> piece_at_distance;
    for (std::size_t i = 0; i < function.number_of_pieces(); ++i)
    {
      double sum = 0;
      for (const Mesh::Vertex_index v : region.second)
        sum += std::abs(Piece<Function>(function, i)(mesh.point(v)));
      piece_at_distance.emplace(sum, i);
    }
    pieces[region.first] = piece_at_distance.begin()->second;
  }
  for (const Mesh::Face_index f : mesh.faces())
    regions[f] = pieces.at(regions[f]);
  const promises::Number_off_surface off_surface = number_off_surface(mesh, function, bounding_box_diagonal(before));
  const std::string broken = promises::broken(before, mesh, off_surface, result, true);
  if (!CHECK(broken.empty()))
    std::cerr << "  " << broken << std::endl;
}

void test_face_range()
{
  const Mesh input = capped_cylinder(32, 16);
  Mesh mesh = input;
  std::vector<Mesh::Face_index> range;
  for (const Mesh::Face_index f : mesh.faces())
    if (mesh.point(mesh.target(mesh.halfedge(f))).x() > 0.1)
      range.push_back(f);
  const std::set<Mesh::Face_index> selected(range.begin(), range.end());
  const Hde::Remeshing_result result = remesh_at_once(mesh, 40, 3 * range.size(), 0.1, Limited_visitor(), range);
  bool is_same = true;
  for (const Mesh::Face_index f : input.faces())
    if (selected.count(f) == 0)
    {
      is_same = is_same && !mesh.is_removed(f);
      Mesh::Halfedge_index h = mesh.halfedge(f), g = input.halfedge(f);
      for (int k = 0; is_same && k < 3; ++k, h = mesh.next(h), g = input.next(g))
        is_same = h == g && mesh.point(mesh.target(h)) == input.point(input.target(g));
    }
  CHECK(is_same);
  CHECK(mesh.number_of_faces() > input.number_of_faces() + range.size());
  CHECK(result.number_of_regions == 3);
  CHECK(promises::number_of_self_intersections(mesh) == 0);
  CHECK(Hde::measure_shape(mesh).number_of_folded_edges == 0);
  // the creases of the other faces are there, too
  Mesh before = input;
  const Function function = detect(before, 40);
  CHECK(detect(mesh, 40).number_of_pieces() == 3);
  check_promises(before, mesh, function, result);
  // they stay on the polygon, as it turns by 11 degrees
  const creases::Segments old_creases = creases::segments(before, creases_of(before)),
                          new_creases = creases::segments(mesh, creases_of(mesh));
  const double deviation = (largest_deviation + 1e-12) * bounding_box_diagonal(input);
  CHECK(creases::largest_distance(new_creases, old_creases) <= deviation);
  CHECK(creases::largest_distance(old_creases, new_creases) <= deviation);
  CHECK(topology_of_regions(mesh).size() == 3);
}

// protected creases stay edge for edge, and the map tells them as it tells those that do not
void test_protected_creases()
{
  const Mesh input = cube(6);
  Mesh mesh = input, marked = input;
  detect(marked, 30);
  const auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease", false).first;
  CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, params::sharp_angle(30).number_of_target_faces(1500).edge_is_constrained_map(is_crease).protect_constraints(true));
  std::size_t number = 0;
  for (const Mesh::Edge_index e : input.edges())
    if (creases_of(marked)[e])
    {
      ++number;
      CHECK(!mesh.is_removed(e) && is_crease[e]);
    }
  CHECK(number == 12 * 6);
  for (const Mesh::Edge_index e : mesh.edges())
    number -= is_crease[e] ? 1 : 0;
  CHECK(number == 0);
  CHECK(mesh.number_of_faces() > 1400);
}

void test_fixed_vertices()
{
  const Mesh input = capped_cylinder(32, 16);
  Mesh mesh = input;
  for (const Mesh::Vertex_index v : mesh.vertices())
    fixed_of(mesh)[v] = int(v) % 17 == 0; // also on the circles
  remesh_at_once(mesh, 40, 800);
  CHECK(CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_closed(mesh));
  std::size_t number = 0, number_of_kept = 0;
  for (const Mesh::Vertex_index v : input.vertices())
    if (int(v) % 17 == 0)
    {
      ++number;
      number_of_kept += !mesh.is_removed(v) && mesh.point(v) == input.point(v) ? 1 : 0;
    }
  CHECK(number_of_kept == number);
}

void test_stopping()
{
  const Mesh input = l_block(8);
  Mesh mesh = input;
  const Function function = detect(mesh, 40); // of the input: one of the result is on its vertices anyway
  Limited_visitor patient;
  mesh = input;
  CHECK(!remesh_at_once(mesh, 40, 8000, 0.1, patient).was_stopped);
  const std::size_t all = *patient.questions;
  CHECK(all > 10);
  for (const std::size_t limit : {std::size_t(0), std::size_t(1), std::size_t(4), all / 8, all / 4, all / 2, 3 * all / 4})
  {
    Limited_visitor visitor;
    visitor.limit = limit;
    mesh = input;
    const Hde::Remeshing_result result = remesh_at_once(mesh, 40, 8000, 0.1, visitor);
    CHECK(result.was_stopped == (*visitor.questions > limit));
    CHECK(detect(mesh, 40).number_of_pieces() == 8);
    check_promises(input, mesh, function, result);
  }
}

// the two steps give what the one call gives, for any number of threads
void test_threads()
{
  for (const Mesh& input : {capped_cylinder(32, 16), l_block(4)})
  {
    const Remeshing<Function> r = remesh(input, 40, 3000);
    const std::uint64_t expected = digest(r.after);
    const auto digest_of_call = [&](const std::size_t faces)
    {
      Mesh mesh = input;
      remesh_at_once(mesh, 40, faces);
      return digest(mesh);
    };
    CHECK(digest_of_call(3000) == expected);
    CHECK(digest_of_call(3100) != expected);
#ifdef CGAL_LINKED_WITH_TBB
    for (const std::size_t number_of_threads : {1, 2})
    {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
      CHECK(digest_of_call(3000) == expected);
    }
#endif
  }
}

// --- awkward input ---

void test_bad_input()
{
  const Mesh input = cube(2);
  for (const double angle : {0., 180., -10., std::numeric_limits<double>::quiet_NaN()})
  {
    Mesh mesh = input;
    CHECK(contains(invalid_argument_message([&] { remesh_at_once(mesh, angle, 100); }), "sharp_angle"));
    CHECK(digest(mesh) == digest(input));
  }
  Mesh mesh = can(16, 4);
  regions_of(mesh)[Mesh::Face_index(5)] = 3;
  const std::uint64_t before = digest(mesh);
  const auto call = [&]
  {
    CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, Can_function(),
        params::number_of_target_faces(100).relative_sigma(0.1).face_patch_map(regions_of(mesh)).visitor(Limited_visitor()));
  };
  CHECK(contains(invalid_argument_message(call), "face_patch_map"));
  CHECK(digest(mesh) == before);
}

// every face is a region
void test_all_edges()
{
  for (Mesh mesh : {cube(4), icosphere(2)})
  {
    for (const Mesh::Edge_index e : mesh.edges())
      creases_of(mesh)[e] = true;
    for (const std::size_t faces : {mesh.number_of_faces() / 2, 5 * mesh.number_of_faces()})
    {
      Remeshing<Function> r = remesh(mesh, 40, faces);
      check("all edges", r, 1e-12);
      CHECK(r.result.number_of_regions == mesh.number_of_faces());
    }
  }
}

int main()
{
  test_own_pieces();
  test_cylinder();
  test_blocks();
  test_cone();
  test_fine_crease();
  test_marked_curve();
  test_bound_of_deviation();
  test_open_box();
  test_dart();
  test_face_range();
  test_protected_creases();
  test_fixed_vertices();
  test_stopping();
  test_threads();
  test_bad_input();
  test_all_edges();
  return check_summary();
}
