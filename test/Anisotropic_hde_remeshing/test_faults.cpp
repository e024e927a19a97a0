// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Faults inside a call: memory that runs out at any request, functions that lie about their sign or jump. The exception reaches
// the caller with the mesh as it was, or the result is a valid mesh.

#include "remeshing_checks.h"

#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <new>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// ------------------------------------------------------------------------------------------- an allocator that can fail

namespace {

std::atomic<long long> number_of_requests{0};
std::atomic<long long> request_that_fails{std::numeric_limits<long long>::max()};

void* request(const std::size_t size)
{
  if (number_of_requests.fetch_add(1) >= request_that_fails.load())
    throw std::bad_alloc();
  if (void* const memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}

} // namespace

void* operator new(const std::size_t size) { return request(size); }
void* operator new[](const std::size_t size) { return request(size); }
void operator delete(void* const memory) noexcept { std::free(memory); }
void operator delete[](void* const memory) noexcept { std::free(memory); }
void operator delete(void* const memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* const memory, std::size_t) noexcept { std::free(memory); }

namespace {

// Lets every request from the n-th on fail while `call` runs on a copy of the mesh; for all n, but with steps where there are
// many: the last ones, when the result is stored, all.
template <typename Call>
void check_exhaustion(const std::string& name, const Mesh& input, const Call& call)
{
  long long number_of_failures = 0;
  const auto requests_of = [&](const long long n)
  {
    Mesh mesh = input;
    CHECK(mesh.number_of_faces() == input.number_of_faces());
    const std::uint64_t before = digest(mesh);
    number_of_requests = 0;
    request_that_fails = n;
    bool has_thrown = false;
    try
    {
      call(mesh);
    }
    catch (const std::bad_alloc&)
    {
      has_thrown = true;
    }
    request_that_fails = std::numeric_limits<long long>::max();
    const long long count = number_of_requests;
    if (has_thrown)
      CHECK(digest(mesh) == before);
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(count > n || !has_thrown);
    number_of_failures += has_thrown;
    return count;
  };
  const long long count = requests_of(std::numeric_limits<long long>::max()), last = 60, steps = 150;
  for (long long n = 0; n < count; n += n < count - last ? (std::max)((count - last) / steps, 1ll) : 1)
    requests_of(n);
  CHECK(number_of_failures >= last);
  std::cout << name << ": " << count << " requests for memory" << std::endl;
}

void test_exhaustion()
{
  const Mesh input = ellipsoid(2);
  const auto np = params::number_of_target_faces(500).number_of_iterations(3);
  check_exhaustion("own function", input, [&](Mesh& mesh) { CGAL::anisotropic_hde_remeshing(mesh, Ellipsoid_function(), np); });
  check_exhaustion("function from the mesh", input, [&](Mesh& mesh) { CGAL::anisotropic_hde_remeshing(mesh, np); });
  check_exhaustion("some faces", input,
                   [&](Mesh& mesh)
                   {
                     std::vector<Mesh::Face_index> some;
                     for (const Mesh::Face_index f : mesh.faces())
                       if (std::size_t(f) < 100)
                         some.push_back(f);
                     CGAL::anisotropic_hde_remeshing(some, mesh, Ellipsoid_function(), params::number_of_iterations(3));
                   });
  Mesh with_garbage = input;
  CGAL::Euler::collapse_edge(*with_garbage.edges().begin(), with_garbage);
  Mesh mesh = with_garbage;
  CHECK(mesh.has_garbage());
  CGAL::anisotropic_hde_remeshing(mesh, Ellipsoid_function(), np);
  CHECK(!mesh.has_garbage());
  check_validity("garbage", input, mesh, Ellipsoid_function());
}

// A property map that asks for memory when a key is new, behind a std::map that its copies share. What is not in it has a value by
// default.
template <typename Key_, typename Value_>
struct Allocating_map
{
  typedef Key_ key_type;
  typedef Value_ value_type;
  typedef Value_ reference;
  typedef boost::read_write_property_map_tag category;

  std::map<Key_, Value_>* values;
  Value_ default_value;

  friend Value_ get(const Allocating_map& map, const Key_& key)
  {
    const auto found = map.values->find(key);
    return found == map.values->end() ? map.default_value : found->second;
  }
  friend void put(const Allocating_map& map, const Key_& key, const Value_& value) { (*map.values)[key] = value; }
};

// the same for calls whose maps are not parts of the mesh: `values` of the elements of the input are as they were, too
template <typename Key, typename Value, typename Elements, typename Call>
void check_exhaustion_with_map(const std::string& name, const Mesh& input, const Value& default_value, const Elements& elements,
                               const std::map<Key, Value>& values, const Call& call)
{
  std::map<Key, Value> written;
  const Allocating_map<Key, Value> before{const_cast<std::map<Key, Value>*>(&values), default_value};
  check_exhaustion(name, input,
                   [&](Mesh& mesh)
                   {
                     const long long n = request_that_fails;
                     request_that_fails = std::numeric_limits<long long>::max();
                     written = values;
                     request_that_fails = n;
                     number_of_requests = 0;
                     const Allocating_map<Key, Value> map{&written, default_value};
                     try
                     {
                       call(mesh, map);
                     }
                     catch (const std::bad_alloc&)
                     {
                       request_that_fails = std::numeric_limits<long long>::max();
                       bool is_as_before = true;
                       for (const Key key : elements)
                         is_as_before = is_as_before && get(map, key) == get(before, key);
                       CHECK(is_as_before);
                       throw;
                     }
                   });
}

// maps of the caller's, each of which runs out of memory when it is written
void test_exhausted_maps()
{
  const Mesh input = ellipsoid(1);
  const auto np = params::number_of_target_faces(200).number_of_iterations(2);
  const auto remesh = [](Mesh& mesh, const auto& parameters)
  { CGAL::anisotropic_hde_remeshing(mesh, Ellipsoid_function(), parameters); };
  typedef Mesh::Vertex_index Vertex;
  typedef Mesh::Edge_index Edge;
  typedef Mesh::Face_index Face;

  // protected edges, of which the caller has marked some; all that separate patches are marked in the end
  std::map<Edge, bool> constrained;
  std::map<Face, int> patches;
  for (const Face f : input.faces())
    patches[f] = input.point(input.target(input.halfedge(f))).x() > 0.1 ? 7 : 3;
  for (const Edge e : input.edges())
    if (std::size_t(e) % 20 == 0)
      constrained[e] = true;
  const auto patch = [&](Mesh& mesh)
  {
    auto map = mesh.add_property_map<Face, int>("f:patch", 0).first;
    for (const auto& value : patches)
      map[value.first] = value.second;
    return map;
  };
  check_exhaustion_with_map("edge_is_constrained_map", input, false, input.edges(), constrained,
                            [&](Mesh& mesh, const auto& map) { remesh(mesh, np.edge_is_constrained_map(map)); });
  check_exhaustion_with_map(
      "protected patches", input, false, input.edges(), constrained,
      [&](Mesh& mesh, const auto& map)
      { remesh(mesh, np.edge_is_constrained_map(map).protect_constraints(true).face_patch_map(patch(mesh))); });
  check_exhaustion_with_map("face_patch_map", input, 0, input.faces(), patches,
                            [&](Mesh& mesh, const auto& map) { remesh(mesh, np.face_patch_map(map)); });
  std::map<Vertex, Point_3> points;
  for (const Vertex v : input.vertices())
    points[v] = input.point(v);
  for (const bool is_constrained : {false, true})
    check_exhaustion_with_map("vertex_point_map", input, Point_3(0, 0, 0), input.vertices(), points,
                              [&](Mesh& mesh, const auto& map)
                              {
                                if (is_constrained)
                                  remesh(mesh, np.vertex_point_map(map).protect_constraints(true));
                                else
                                  remesh(mesh, np.vertex_point_map(map));
                              });
  bool is_complete = true;
  check_exhaustion("vertex_location_map", input,
                   [&](Mesh& mesh)
                   {
                     std::map<Vertex, Hde::Input_location> locations;
                     const Allocating_map<Vertex, Hde::Input_location> map{&locations, {}};
                     remesh(mesh, np.vertex_location_map(map));
                     is_complete = is_complete && locations.size() == mesh.number_of_vertices();
                   });
  CHECK(is_complete);
}

// ---------------------------------------------------------------------------------------------------- functions that lie

double noise_of(const Point_3& p)
{
  const double x = std::sin(12.9898 * p.x() + 78.233 * p.y() + 37.719 * p.z()) * 43758.5453;
  return x - std::floor(x);
}

// the sign changes from point to point
struct Flickering_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return (noise_of(p) < 0.5 ? -1 : 1) * Ellipsoid_function::operator()(p); }
};

struct Jumping_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return Ellipsoid_function::operator()(p) + (p.z() > 0.3 ? 0.2 : 0); }
};

struct Steep_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return 1e200 * Ellipsoid_function::operator()(p); }
  Vector_3 gradient(const Point_3& p) const { return 1e200 * Ellipsoid_function::gradient(p); }
};

struct Wrong_gradient : Ellipsoid_function
{
  Vector_3 gradient(const Point_3& p) const { return Vector_3(noise_of(p) - 0.5, p.x(), -p.y()); }
};

template <typename Function>
void check_survival(const char* name, const Function& function)
{
  const Mesh input = ellipsoid(3);
  for (const double sigma : {0., 0.5})
  {
    Mesh mesh = input;
    const auto np = params::sigma(sigma).number_of_target_faces(2000);
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(mesh, function, np);
    std::cout << name << ": " << mesh.number_of_faces() << " faces, closest points " << result.projections.closest_point
              << std::endl;
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(CGAL::is_triangle_mesh(mesh));
    CHECK(CGAL::is_closed(mesh));
    CHECK(Hde::measure_topology(mesh).euler_characteristic == 2);
    CHECK(Hde::measure_shape(mesh).number_of_degenerate_faces == 0);
    bool is_finite = true;
    for (const Mesh::Vertex_index v : mesh.vertices())
      for (int i = 0; i < 3; ++i)
        is_finite = is_finite && std::isfinite(mesh.point(v)[i]);
    CHECK(is_finite);
  }
}

} // namespace

int main()
{
  test_exhaustion();
  test_exhausted_maps();
  check_survival("sign", Flickering_function());
  check_survival("jump", Jumping_function());
  check_survival("steep", Steep_function());
  check_survival("gradient", Wrong_gradient());
  return check_summary();
}
