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

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <new>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

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
  const auto np = CGAL::parameters::number_of_target_faces(500).number_of_iterations(3);
  check_exhaustion("own function", input, [&](Mesh& mesh) { CGAL::anisotropic_hde_remeshing(mesh, Ellipsoid_function(), np); });
  check_exhaustion("function from the mesh", input, [&](Mesh& mesh) { CGAL::anisotropic_hde_remeshing(mesh, np); });
  check_exhaustion("some faces", input,
                   [&](Mesh& mesh)
                   {
                     std::vector<Mesh::Face_index> some;
                     for (const Mesh::Face_index f : mesh.faces())
                       if (std::size_t(f) < 100)
                         some.push_back(f);
                     CGAL::anisotropic_hde_remeshing(some, mesh, Ellipsoid_function(),
                                                     CGAL::parameters::number_of_iterations(3));
                   });
  Mesh with_garbage = input;
  CGAL::Euler::collapse_edge(*with_garbage.edges().begin(), with_garbage);
  Mesh mesh = with_garbage;
  CHECK(mesh.has_garbage());
  CGAL::anisotropic_hde_remeshing(mesh, Ellipsoid_function(), np);
  CHECK(!mesh.has_garbage());
  check_validity("garbage", input, mesh, Ellipsoid_function());
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
    const auto np = CGAL::parameters::sigma(sigma).number_of_target_faces(2000);
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
  check_survival("sign", Flickering_function());
  check_survival("jump", Jumping_function());
  check_survival("steep", Steep_function());
  check_survival("gradient", Wrong_gradient());
  return check_summary();
}
