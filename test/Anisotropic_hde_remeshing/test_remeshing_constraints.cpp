// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Constraints: face ranges, edges, vertices, patches, and their protection.

#include "polylines.h"
#include "remeshing_checks.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;

template <typename TriangleMesh>
Point_3 centroid(const typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& mesh)
{
  const auto vpm = get(CGAL::vertex_point, mesh);
  const auto h = halfedge(f, mesh);
  return CGAL::centroid(get(vpm, source(h, mesh)), get(vpm, target(h, mesh)), get(vpm, target(next(h, mesh), mesh)));
}

template <typename TriangleMesh>
Kernel::Segment_3 segment(const typename boost::graph_traits<TriangleMesh>::edge_descriptor e, const TriangleMesh& mesh)
{
  const auto vpm = get(CGAL::vertex_point, mesh);
  return Kernel::Segment_3(get(vpm, source(e, mesh)), get(vpm, target(e, mesh)));
}

// --- face ranges ---

// what must not change
template <typename TriangleMesh>
struct Rest
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  std::map<typename Graph_traits::face_descriptor, std::array<typename Graph_traits::vertex_descriptor, 3>> faces;
  std::map<typename Graph_traits::vertex_descriptor, Point_3> points;
  std::set<typename Graph_traits::edge_descriptor> edges;

  Rest(const TriangleMesh& mesh, const std::set<typename Graph_traits::face_descriptor>& range)
  {
    for (const auto f : CGAL::faces(mesh))
      if (range.count(f) == 0)
      {
        const auto h = halfedge(f, mesh);
        faces[f] = {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
        for (const auto v : faces[f])
          points.emplace(v, get(CGAL::vertex_point, mesh, v));
        for (const auto g : halfedges_around_face(h, mesh))
          edges.insert(edge(g, mesh));
      }
  }

  void check(const TriangleMesh& mesh) const
  {
    const auto all_faces = CGAL::faces(mesh);
    const auto all_edges = CGAL::edges(mesh);
    const std::set<typename Graph_traits::face_descriptor> present(all_faces.begin(), all_faces.end());
    const std::set<typename Graph_traits::edge_descriptor> present_edges(all_edges.begin(), all_edges.end());
    bool is_same = true;
    for (const auto& face : faces)
    {
      if (!CHECK(present.count(face.first) == 1))
        return;
      const auto h = halfedge(face.first, mesh);
      is_same = is_same && face.second[0] == source(h, mesh) && face.second[1] == target(h, mesh) &&
                face.second[2] == target(next(h, mesh), mesh);
    }
    for (const auto& point : points)
      is_same = is_same && get(CGAL::vertex_point, mesh, point.first) == point.second;
    for (const auto e : edges)
      is_same = is_same && present_edges.count(e) == 1;
    CHECK(is_same);
  }
};

template <typename TriangleMesh, typename Function, typename IsSelected>
void test_face_range(const std::string& name, const TriangleMesh& input, const Function& function,
                     const IsSelected& is_selected)
{
  for (const double factor : {0.3, 1., 3.})
  {
    TriangleMesh mesh = input;
    std::set<typename boost::graph_traits<TriangleMesh>::face_descriptor> range;
    for (const auto f : faces(mesh))
      if (is_selected(centroid(f, mesh)))
        range.insert(f);
    const Rest<TriangleMesh> rest(mesh, range);
    const std::size_t wanted = std::size_t(factor * double(range.size()));
    CGAL::anisotropic_hde_remeshing<Tag>(range, mesh, function, params::relative_sigma(0.03).number_of_target_faces(wanted));
    rest.check(mesh);
    check_validity(name + ", " + std::to_string(wanted) + " of " + std::to_string(num_faces(input)), input, mesh, function);
    const double count = double(number_of_faces_of(mesh)) - double(rest.faces.size());
    std::cout << "  faces in the range: " << count << std::endl;
    // the border of the range keeps its edges
    CHECK(std::abs(count - double(wanted)) < 0.1 * double(wanted) + 50);
  }
}

void test_face_ranges()
{
  const auto upper = [](const Point_3& p) { return p.z() + 0.3 * p.x() > 0.1; };
  test_face_range("upper part", ellipsoid(3), Ellipsoid_function(), upper);
  test_face_range("upper part of a polyhedron", to_mesh<Polyhedron>(scaled(icosphere_soup(3), 1, 2, 5)), Ellipsoid_function(),
                  upper);
  // with a part of the boundary, and in several pieces
  test_face_range("stripes", hills(30), Hills_function(),
                  [](const Point_3& p) { return std::sin(6 * (p.x() + 0.7 * p.y())) > 0.2; });
  // all but a hole
  test_face_range("all but a spot", ellipsoid(3), Ellipsoid_function(), [](const Point_3& p) { return p.z() < 4; });
}

// faces of a range that touch in a vertex only, the whole mesh as a range, one face, and none
void test_odd_face_ranges()
{
  const Mesh input = ellipsoid(2);
  {
    Mesh mesh = input;
    const Mesh::Vertex_index v(30);
    std::set<Mesh::Face_index> range;
    int k = 0;
    for (const Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if (++k % 3 != 0) // two pairs
        range.insert(mesh.face(h));
    const Rest<Mesh> rest(mesh, range);
    CGAL::anisotropic_hde_remeshing<Tag>(range, mesh, Ellipsoid_function(), params::number_of_target_faces(60));
    rest.check(mesh);
    check_validity("faces about a vertex", input, mesh, Ellipsoid_function());
    CHECK(mesh.number_of_faces() > input.number_of_faces());
  }
  {
    Mesh mesh = input;
    CGAL::anisotropic_hde_remeshing<Tag>(faces(mesh), mesh, Ellipsoid_function(), params::number_of_target_faces(1000));
    check_validity("all faces", input, mesh, Ellipsoid_function());
    check_number_of_faces(mesh, 1000);
  }
  {
    Mesh mesh = input;
    const std::vector<Mesh::Face_index> one(3, Mesh::Face_index(7)); // three times
    CGAL::anisotropic_hde_remeshing<Tag>(one, mesh, Ellipsoid_function(), params::number_of_target_faces(1));
    CHECK(mesh.number_of_faces() == input.number_of_faces()); // its edges are those of its neighbours
    check_validity("one face", input, mesh, Ellipsoid_function());
  }
  {
    Mesh mesh = input;
    const std::vector<Mesh::Face_index> none; // nothing is done, nor is a function built
    struct Listener : Hde::Remeshing_visitor
    {
      std::size_t number_of_stages = 0;
      void stage_started(Hde::Stage) { ++number_of_stages; }
    } listener;
    const std::uint64_t before = digest(mesh);
    CHECK(CGAL::anisotropic_hde_remeshing<Tag>(none, mesh, Ellipsoid_function()).number_of_faces == 0);
    CHECK(CGAL::anisotropic_hde_remeshing<Tag>(none, mesh, params::visitor(std::ref(listener))).number_of_faces == 0);
    CHECK(digest(mesh) == before);
    CHECK(listener.number_of_stages == 0);
    CHECK(contains(invalid_argument_message(
                       [&] { CGAL::anisotropic_hde_remeshing<Tag>(none, mesh, Ellipsoid_function(), params::sigma(-1)); }),
                   "sigma is -1"));
  }
  {
    Mesh mesh = input;
    const std::vector<Mesh::Face_index> some(mesh.faces().begin(), mesh.faces().begin() + 100);
    CGAL::anisotropic_hde_remeshing<Tag>(some, mesh, params::number_of_target_faces(400)); // the one call
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(mesh.number_of_faces() > input.number_of_faces() + 200);
  }
}

// --- constrained edges ---

template <typename TriangleMesh, typename IsConstrained>
Polyline constrained_edges(const TriangleMesh& mesh, const IsConstrained& is_constrained)
{
  Polyline result;
  for (const auto e : edges(mesh))
    if (get(is_constrained, e))
      result.push_back(segment<TriangleMesh>(e, mesh));
  return result;
}

// a line across the hills, and one that ends inside
void mark_lines(const Mesh& mesh, Mesh::Property_map<Mesh::Edge_index, bool>& is_constrained)
{
  const auto on = [](const double x, const double y) { return std::abs(x - y) < 1e-9; };
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    is_constrained[e] = (on(p.x(), 1) && on(q.x(), 1)) || (on(p.y(), 0.5) && on(q.y(), 0.5) && (std::max)(p.x(), q.x()) < 0.61);
  }
}

void test_constrained_edges()
{
  const Mesh input = hills(40);
  for (const std::size_t number_of_faces : {800, 3200, 9000})
  {
    Mesh mesh = input;
    auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
    mark_lines(mesh, is_constrained);
    const Polyline before = constrained_edges(mesh, is_constrained);
    const auto np = params::relative_sigma(0.02).number_of_target_faces(number_of_faces);
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Hills_function(), np.edge_is_constrained_map(is_constrained));
    const Polyline after = constrained_edges(mesh, is_constrained);
    std::cout << "constrained edges: " << before.size() << " -> " << after.size() << ", length " << length(before) << " -> "
              << length(after) << std::endl;
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    check_number_of_faces(mesh, number_of_faces);
    if (number_of_faces != input.number_of_faces())
      CHECK(after.size() != before.size());
    CHECK(largest_distance(after, before) <= 1e-12);
    CHECK(length(after) <= length(before) * (1 + 1e-9));
    CHECK(length(after) >= 0.98 * length(before));
    CHECK(Hde::measure_embedding(mesh, Hills_function()).number_of_folded_faces == 0);
    // the ends of the lines
    for (const std::pair<double, double>& xy : {std::make_pair(1., 0.), std::make_pair(1., 2.), std::make_pair(0.6, 0.5)})
    {
      const Point_3 end(xy.first, xy.second, Hills_function::height(xy.first, xy.second));
      double least = 1e300;
      for (const Mesh::Vertex_index v : mesh.vertices())
        least = (std::min)(least, CGAL::squared_distance(mesh.point(v), end));
      CHECK(least <= 1e-24);
    }
  }
}

void test_protected_edges()
{
  const Mesh input = hills(40);
  for (const std::size_t number_of_faces : {800, 9000})
  {
    Mesh mesh = input;
    auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
    mark_lines(mesh, is_constrained);
    std::map<Mesh::Edge_index, Kernel::Segment_3> kept;
    for (const Mesh::Edge_index e : mesh.edges())
      if (is_constrained[e] || mesh.is_border(e))
        kept.emplace(e, segment<Mesh>(e, mesh));
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Hills_function(),
                                         params::relative_sigma(0.02)
                                             .number_of_target_faces(number_of_faces)
                                             .edge_is_constrained_map(is_constrained)
                                             .protect_constraints(true));
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    std::size_t number_of_kept = 0;
    for (const auto& edge : kept)
      number_of_kept += !mesh.is_removed(edge.first) && segment<Mesh>(edge.first, mesh) == edge.second ? 1 : 0;
    CHECK(number_of_kept == kept.size());
    std::size_t number_of_edges = 0;
    for (const Mesh::Edge_index e : mesh.edges())
      number_of_edges += is_constrained[e] || mesh.is_border(e) ? 1 : 0;
    CHECK(number_of_edges == kept.size());
    std::cout << "protected edges " << kept.size() << ", faces " << mesh.number_of_faces() << std::endl;
    CHECK(number_of_faces < 3200 ? mesh.number_of_faces() < 2400 : mesh.number_of_faces() > 8000);
  }
}

// --- constrained vertices ---

void test_constrained_vertices()
{
  for (const std::size_t number_of_faces : {600, 5000})
  {
    Mesh mesh = ellipsoid(3);
    auto is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_constrained", false).first;
    std::map<Mesh::Vertex_index, Point_3> kept;
    for (const Mesh::Vertex_index v : mesh.vertices())
      if (int(v) % 20 == 0)
      {
        mesh.point(v) = mesh.point(v) + 0.01 * (mesh.point(v) - CGAL::ORIGIN); // off the surface, too
        is_constrained[v] = true;
        kept.emplace(v, mesh.point(v));
      }
    CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, Ellipsoid_function(), params::number_of_target_faces(number_of_faces).vertex_is_constrained_map(is_constrained));
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(CGAL::is_closed(mesh));
    std::size_t number_of_kept = 0, number_of_marked = 0;
    for (const auto& vertex : kept)
      number_of_kept += !mesh.is_removed(vertex.first) && mesh.point(vertex.first) == vertex.second ? 1 : 0;
    for (const Mesh::Vertex_index v : mesh.vertices())
      number_of_marked += is_constrained[v] ? 1 : 0;
    CHECK(number_of_kept == kept.size());
    CHECK(number_of_marked == kept.size());
    check_number_of_faces(mesh, number_of_faces);
  }
}

// --- patches ---

template <typename TriangleMesh, typename PatchMap>
Polyline patch_borders(const TriangleMesh& mesh, const PatchMap& patch)
{
  Polyline result;
  for (const auto e : edges(mesh))
    if (!is_border(e, mesh) &&
        get(patch, face(halfedge(e, mesh), mesh)) != get(patch, face(opposite(halfedge(e, mesh), mesh), mesh)))
      result.push_back(segment<TriangleMesh>(e, mesh));
  return result;
}

template <typename TriangleMesh, typename PatchMap>
std::map<std::string, double> patch_areas(const TriangleMesh& mesh, const PatchMap& patch)
{
  std::map<std::string, double> result;
  for (const auto f : faces(mesh))
    result[get(patch, f)] += PMP::face_area(f, mesh);
  return result;
}

template <typename TriangleMesh, typename PatchMap>
void test_patches(const std::string& name, TriangleMesh& mesh, const PatchMap patch, const std::size_t number_of_faces)
{
  for (const auto f : faces(mesh))
  {
    const Point_3 c = centroid(f, mesh);
    put(patch, f, std::string(c.x() > 0 ? "right" : "left") + (c.y() > 0 ? " front" : " back") + (c.z() > 2 ? " top" : ""));
  }
  const Polyline before = patch_borders(mesh, patch);
  const std::map<std::string, double> areas_before = patch_areas(mesh, patch);
  const TriangleMesh input = mesh;
  CGAL::anisotropic_hde_remeshing<Tag>(
      mesh, Ellipsoid_function(), params::relative_sigma(0.05).number_of_target_faces(number_of_faces).face_patch_map(patch));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_closed(mesh));
  check_number_of_faces(mesh, number_of_faces);
  CHECK(Hde::measure_embedding(mesh, Ellipsoid_function()).number_of_folded_faces == 0);
  const Polyline after = patch_borders(mesh, patch);
  std::cout << name << ": borders " << before.size() << " -> " << after.size() << ", length " << length(before) << " -> "
            << length(after) << std::endl;
  CHECK(largest_distance(after, before) <= 1e-12);
  CHECK(length(after) >= 0.95 * length(before));
  CHECK(length(after) <= length(before) * (1 + 1e-9));
  const std::map<std::string, double> areas = patch_areas(mesh, patch);
  CHECK(areas.size() == 8);
  for (const auto& area : areas_before)
    CHECK(areas.count(area.first) == 1 && std::abs(areas.at(area.first) / area.second - 1) < 0.05);
}

void test_face_patches()
{
  for (const std::size_t number_of_faces : {700, 5000})
  {
    Mesh mesh = ellipsoid(4);
    test_patches("patches", mesh, mesh.add_property_map<Mesh::Face_index, std::string>("f:patch").first, number_of_faces);
    Polyhedron polyhedron = to_mesh<Polyhedron>(scaled(icosphere_soup(4), 1, 2, 5));
    test_patches("patches of a polyhedron", polyhedron, get(CGAL::dynamic_face_property_t<std::string>(), polyhedron),
                 number_of_faces);
  }
}

// --- a small closed curve does not vanish, nor close ---

void test_small_loops()
{
  Mesh mesh = ellipsoid(4);
  std::vector<Mesh::Face_index> spot;
  for (const Mesh::Face_index f : mesh.faces())
    if (CGAL::squared_distance(centroid(f, mesh), Point_3(1, 0, 0)) < 0.1)
      spot.push_back(f);
  CHECK(spot.size() > 10);
  for (const Mesh::Face_index f : spot)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  const Mesh input = mesh;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::number_of_target_faces(100));
  check_validity("small hole", input, mesh, Ellipsoid_function());
  Polyline before, after;
  for (const Mesh::Edge_index e : input.edges())
    if (input.is_border(e))
      before.push_back(segment<Mesh>(e, input));
  for (const Mesh::Edge_index e : mesh.edges())
    if (mesh.is_border(e))
      after.push_back(segment<Mesh>(e, mesh));
  std::cout << "  hole: " << before.size() << " -> " << after.size() << " edges, length " << length(before) << " -> "
            << length(after) << std::endl;
  CHECK(length(after) >= 0.85 * length(before));
}

int main()
{
  test_face_ranges();
  test_odd_face_ranges();
  test_constrained_edges();
  test_protected_edges();
  test_constrained_vertices();
  test_face_patches();
  test_small_loops();
  return check_summary();
}
