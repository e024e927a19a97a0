// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Property maps of every kind that a caller may have: those of the mesh, whose values of bool are proxies, sets, std::map, maps that
// return values, references or proxies, and maps that `put` takes no const object of. All give the same.

#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/Interpolated_vertex_field.h>
#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>
#include <CGAL/Anisotropic_hde_remeshing/transfer_vertex_property.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

// ------------------------------------------------------------------------------------------------------- the kinds of maps

// a map of the mesh itself; that of bool is a vector of bool
template <typename Key, typename Value>
struct Of_mesh
{
  typedef Mesh::Property_map<Key, Value> Map;
  Map map;
  Of_mesh(Mesh& mesh, const std::string& name) : map(mesh.add_property_map<Key, Value>("test:" + name).first) {}
};

// what std::map keeps, by reference
template <typename Key, typename Value>
struct By_reference
{
  typedef std::map<Key, Value> Values;
  typedef boost::associative_property_map<Values> Map;
  std::shared_ptr<Values> values = std::make_shared<Values>();
  Map map{*values};
  By_reference(Mesh&, const std::string&) {}
};

template <typename Key, typename Value_>
struct By_value_map
{
  typedef Key key_type;
  typedef Value_ value_type;
  typedef Value_ reference;
  typedef boost::read_write_property_map_tag category;
  std::map<Key, Value_>* values;
  friend Value_ get(const By_value_map& map, const Key& key)
  {
    const auto found = map.values->find(key);
    return found == map.values->end() ? Value_() : found->second;
  }
  friend void put(By_value_map& map, const Key& key, const Value_& value) { (*map.values)[key] = value; }
};

// by value, and `put` takes the map by a reference that is not const, as that of CGAL::Boolean_property_map does
template <typename Key, typename Value>
struct By_value
{
  typedef By_value_map<Key, Value> Map;
  std::shared_ptr<std::map<Key, Value>> values = std::make_shared<std::map<Key, Value>>();
  Map map{values.get()};
  By_value(Mesh&, const std::string&) {}
};

// stands for a value, as what a vector of bool returns
template <typename Value>
struct Proxy
{
  Value value;
  operator Value() const { return value; }
};

template <typename Key, typename Value_>
struct By_proxy_map
{
  typedef Key key_type;
  typedef Value_ value_type;
  typedef Proxy<Value_> reference;
  typedef boost::read_write_property_map_tag category;
  std::map<Key, Value_>* values;
  friend Proxy<Value_> get(const By_proxy_map& map, const Key& key) { return Proxy<Value_>{(*map.values)[key]}; }
  friend void put(const By_proxy_map& map, const Key& key, const Value_& value) { (*map.values)[key] = value; }
};

template <typename Key, typename Value>
struct By_proxy
{
  typedef By_proxy_map<Key, Value> Map;
  std::shared_ptr<std::map<Key, Value>> values = std::make_shared<std::map<Key, Value>>();
  Map map{values.get()};
  By_proxy(Mesh&, const std::string&) {}
};

// a set of those whose value is true; other values by std::map
template <typename Key, typename Value>
struct By_set : By_reference<Key, Value>
{
  using By_reference<Key, Value>::By_reference;
};
template <typename Key>
struct By_set<Key, bool>
{
  typedef CGAL::Boolean_property_map<std::set<Key>> Map;
  std::shared_ptr<std::set<Key>> values = std::make_shared<std::set<Key>>();
  Map map{*values};
  By_set(Mesh&, const std::string&) {}
};

// A set has nothing but the edges that are marked: none of those that are gone.
template <typename Edges>
void check_edges_of_set(const Edges&, std::size_t)
{
}
void check_edges_of_set(const By_set<Edge, bool>& edges, const std::size_t number_of_constrained_edges)
{
  CHECK(edges.values->size() == number_of_constrained_edges);
}

// ------------------------------------------------------------------------------------------------------------- what is done

// a line, some vertices and two patches
struct Marked
{
  static bool edge(const Mesh& mesh, const Edge e)
  {
    const auto on = [&](const Vertex v) { return std::abs(mesh.point(v).x() - 1) < 1e-9; };
    return on(mesh.vertex(e, 0)) && on(mesh.vertex(e, 1));
  }
  static bool vertex(const Vertex v) { return std::size_t(v) % 50 == 7; }
  static int patch(const Mesh& mesh, const Face f) { return mesh.point(mesh.target(mesh.halfedge(f))).y() > 1.2 ? 5 : -3; }
};

// what is compared: the mesh and what its maps say
struct Outcome
{
  std::uint64_t mesh = 0;
  std::size_t number_of_constrained_edges = 0, number_of_first_faces = 0;
  double sum_of_locations = 0, sum_of_flags = 0, sum_of_numbers = 0;

  bool operator==(const Outcome& other) const
  {
    return mesh == other.mesh && number_of_constrained_edges == other.number_of_constrained_edges &&
           number_of_first_faces == other.number_of_first_faces && sum_of_locations == other.sum_of_locations &&
           sum_of_flags == other.sum_of_flags && sum_of_numbers == other.sum_of_numbers;
  }
};

// with the points of a map
template <typename PointMap>
std::uint64_t digest_of(Mesh mesh, const PointMap points)
{
  for (const Vertex v : mesh.vertices())
    mesh.point(v) = Point_3(get(points, v));
  return digest(mesh);
}

template <template <typename, typename> class Kind>
Outcome with_constraints()
{
  Mesh mesh = hills(16);
  Mesh input = mesh;
  Kind<Edge, bool> edges(mesh, "edges");
  Kind<Vertex, bool> vertices(mesh, "vertices"), flags(input, "flags"), carried_flags(mesh, "flags");
  Kind<Vertex, double> numbers(input, "numbers"), carried_numbers(mesh, "numbers");
  Kind<Face, int> patches(mesh, "patches");
  Kind<Vertex, Point_3> points(mesh, "points");
  Kind<Vertex, Hde::Input_location> locations(mesh, "locations");
  for (const Edge e : mesh.edges())
    put(edges.map, e, Marked::edge(mesh, e));
  for (const Face f : mesh.faces())
    put(patches.map, f, Marked::patch(mesh, f));
  for (const Vertex v : mesh.vertices())
  {
    put(vertices.map, v, Marked::vertex(v));
    put(points.map, v, mesh.point(v));
    put(flags.map, v, mesh.point(v).x() > 0.7);
    put(numbers.map, v, mesh.point(v).x());
  }
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Hills_function(),
                                       params::number_of_target_faces(900)
                                           .number_of_iterations(3)
                                           .edge_is_constrained_map(edges.map)
                                           .vertex_is_constrained_map(vertices.map)
                                           .face_patch_map(patches.map)
                                           .vertex_point_map(points.map)
                                           .vertex_location_map(locations.map));
  Hde::transfer_vertex_property(input, flags.map, mesh, locations.map, carried_flags.map);
  Hde::transfer_vertex_property(input, numbers.map, mesh, locations.map, carried_numbers.map);
  Outcome result;
  result.mesh = digest_of(mesh, points.map);
  for (const Edge e : mesh.edges())
    result.number_of_constrained_edges += get(edges.map, e) ? 1 : 0;
  check_edges_of_set(edges, result.number_of_constrained_edges);
  for (const Face f : mesh.faces())
    result.number_of_first_faces += int(get(patches.map, f)) == 5 ? 1 : 0;
  std::size_t number_of_wrong = 0;
  for (const Vertex v : mesh.vertices())
  {
    const double x = Point_3(get(points.map, v)).x();
    const Hde::Input_location location = get(locations.map, v);
    result.sum_of_locations += double(location.face) + location.barycentric_coordinates[1];
    result.sum_of_flags += get(carried_flags.map, v) ? 1 : 0;
    result.sum_of_numbers += get(carried_numbers.map, v);
    // to the width of a face of the input
    number_of_wrong += bool(get(carried_flags.map, v)) != (x > 0.7) && std::abs(x - 0.7) > 0.2 ? 1 : 0;
    number_of_wrong += std::abs(double(get(carried_numbers.map, v)) - x) > 0.02 ? 1 : 0;
  }
  CHECK(number_of_wrong == 0);
  CHECK(result.number_of_constrained_edges > 20);
  CHECK(result.number_of_first_faces > 100);
  return result;
}

// all elements are replaced
template <template <typename, typename> class Kind>
std::uint64_t without_constraints()
{
  Mesh mesh = hills(16);
  Kind<Vertex, Point_3> points(mesh, "points");
  Kind<Vertex, Hde::Input_location> locations(mesh, "locations");
  for (const Vertex v : mesh.vertices())
    put(points.map, v, mesh.point(v));
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Hills_function(),
                                       params::number_of_target_faces(900)
                                           .number_of_iterations(3)
                                           .vertex_point_map(points.map)
                                           .vertex_location_map(locations.map));
  for (const Vertex v : mesh.vertices())
    CHECK(Hde::Input_location(get(locations.map, v)).has_face());
  return digest_of(mesh, points.map);
}

// what is read by functions, fields and the detection of regions
template <template <typename, typename> class Kind>
double read_only()
{
  Mesh mesh = hills(16);
  Kind<Vertex, Point_3> points(mesh, "points");
  Kind<Vertex, Vector_3> normals(mesh, "normals");
  Kind<Vertex, double> numbers(mesh, "numbers");
  Kind<Edge, bool> edges(mesh, "edges"), creases(mesh, "creases");
  Kind<Face, int> patches(mesh, "patches");
  Kind<Face, std::size_t> regions(mesh, "regions");
  for (const Vertex v : mesh.vertices())
  {
    put(points.map, v, mesh.point(v));
    put(normals.map, v, CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh));
    put(numbers.map, v, mesh.point(v).y());
  }
  for (const Edge e : mesh.edges())
    put(edges.map, e, Marked::edge(mesh, e));
  for (const Face f : mesh.faces())
    put(patches.map, f, Marked::patch(mesh, f));
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(
      mesh, params::vertex_point_map(points.map).vertex_normal_map(normals.map));
  const Hde::Surface_regions found = Hde::detect_surface_regions(
      mesh, creases.map, regions.map,
      params::sharp_angle(60).edge_is_constrained_map(edges.map).face_patch_map(patches.map).vertex_point_map(points.map));
  CHECK(found.number_of_regions >= 4);
  std::size_t number_of_creases = 0, sum_of_regions = 0;
  for (const Edge e : mesh.edges())
    number_of_creases += get(creases.map, e) ? 1 : 0;
  for (const Face f : mesh.faces())
    sum_of_regions += get(regions.map, f);
  CHECK(number_of_creases == found.number_of_crease_edges);
  const Hde::Interpolated_vertex_field field(mesh, numbers.map, params::vertex_point_map(points.map));
  const Point_3 p(0.4, 0.8, 0.3);
  return function(p) + field(p) + double(number_of_creases) + double(sum_of_regions);
}

template <template <typename, typename> class Kind>
void test(const std::string& name)
{
  static const Outcome outcome = with_constraints<Of_mesh>();
  static const std::uint64_t all_replaced = without_constraints<Of_mesh>();
  static const double read = read_only<Of_mesh>();
  std::cout << name << std::endl;
  CHECK(with_constraints<Kind>() == outcome);
  CHECK(without_constraints<Kind>() == all_replaced);
  CHECK(read_only<Kind>() == read);
}

int main()
{
  test<By_reference>("std::map, by reference");
  test<By_value>("by value");
  test<By_proxy>("by proxy");
  test<By_set>("sets");
  return check_summary();
}
