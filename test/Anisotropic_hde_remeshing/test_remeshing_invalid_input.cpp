// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What anisotropic_hde_remeshing() refuses, and what it leaves behind when it is stopped or its function fails: the mesh as
// it was, or a valid one.

#include "remeshing_checks.h"

#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

typedef CGAL::Parallel_if_available_tag Tag;

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

// the message of the refusal; the mesh must be as it was
template <typename NamedParameters>
std::string message_of(const Mesh& input, const NamedParameters& np)
{
  Mesh mesh = input;
  const std::string message =
      invalid_argument_message([&] { CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_function(), np); });
  CHECK(digest(mesh) == digest(input));
  return message;
}

// the same of the call that builds the function itself
template <typename NamedParameters>
std::string message_of_one_call(const Mesh& input, const NamedParameters& np)
{
  Mesh mesh = input;
  const std::string message = invalid_argument_message([&] { CGAL::anisotropic_hde_remeshing<Tag>(mesh, np); });
  CHECK(digest(mesh) == digest(input));
  return message;
}

void test_invalid_meshes()
{
  const auto none = CGAL::parameters::default_values();
  CHECK(!message_of(Mesh(), none).empty());
  CHECK(!message_of_one_call(Mesh(), none).empty());
  Mesh only_isolated;
  only_isolated.add_vertex(Point_3(0, 0, 0));
  CHECK(!message_of(only_isolated, none).empty());

  Mesh cube;
  CGAL::make_hexahedron(Point_3(-1, -1, -1), Point_3(1, -1, -1), Point_3(1, 1, -1), Point_3(-1, 1, -1),
                        Point_3(-1, 1, 1), Point_3(-1, -1, 1), Point_3(1, -1, 1), Point_3(1, 1, 1), cube);
  CHECK(contains(message_of(cube, none), "not a triangle"));
  CHECK(contains(message_of_one_call(cube, none), "not a triangle"));

  for (const double bad : {nan_value, infinity, -infinity})
    for (int coordinate = 0; coordinate < 3; ++coordinate)
    {
      Mesh mesh = icosphere(1);
      double p[3] = {0, 0, 0};
      p[coordinate] = bad;
      mesh.point(Mesh::Vertex_index(17)) = Point_3(p[0], p[1], p[2]);
      CHECK(contains(message_of(mesh, none), "vertex 17"));
      CHECK(contains(message_of_one_call(mesh, none), "vertex 17"));
    }

  Mesh in_one_point;
  CGAL::make_triangle(Point_3(1, 0, 0), Point_3(1, 0, 0), Point_3(1, 0, 0), in_one_point);
  CHECK(!message_of(in_one_point, none).empty());
  CHECK(!message_of_one_call(in_one_point, none).empty());
}

void test_invalid_parameters()
{
  using namespace CGAL::parameters;
  const Mesh mesh = icosphere(1);
  for (const double bad : {-1., nan_value, infinity})
  {
    CHECK(contains(message_of(mesh, sigma(bad)), "sigma is"));
    CHECK(contains(message_of_one_call(mesh, sigma(bad)), "sigma is"));
    CHECK(contains(message_of(mesh, target_edge_length(bad)), "target_edge_length is"));
    CHECK(contains(message_of(mesh, smoothing_ratio(bad)), "smoothing_ratio is"));
    CHECK(contains(message_of(mesh, collapse_ratio(bad)), "collapse_ratio is"));
    CHECK(contains(message_of(mesh, split_ratio(bad)), "split_ratio is"));
  }
  CHECK(contains(message_of(mesh, target_edge_length(0)), "target_edge_length is 0"));
  CHECK(contains(message_of(mesh, number_of_target_faces(0)), "number_of_target_faces is 0"));
  CHECK(contains(message_of(mesh, number_of_target_faces(-5)), "number_of_target_faces is -5"));
  CHECK(contains(message_of(mesh, number_of_iterations(-1)), "number_of_iterations is -1"));
  CHECK(contains(message_of(mesh, number_of_relaxation_steps(-1)), "number_of_relaxation_steps is -1"));
  CHECK(contains(message_of(mesh, smoothing_ratio(1.01)), "smoothing_ratio is 1.01"));
  CHECK(contains(message_of(mesh, collapse_ratio(1.5)), "collapse_ratio is 1.5"));
  CHECK(contains(message_of(mesh, split_ratio(0.9)), "split_ratio is 0.9"));
  CHECK(contains(message_of_one_call(mesh, number_of_patches(0)), "number_of_patches is 0"));
  CHECK(contains(message_of_one_call(mesh, patch_overlap(-1)), "patch_overlap is -1"));
  CHECK(contains(message_of_one_call(mesh, offset_distance(0)), "offset_distance is 0"));
}

// parameters at the edge of sense are no errors, and what comes out is valid
void test_extreme_parameters()
{
  using namespace CGAL::parameters;
  const Mesh input = ellipsoid(2);
  const auto remesh = [&](const std::string& name, const auto& np)
  {
    Mesh mesh = input;
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), np);
    check_validity(name, input, mesh, Ellipsoid_function());
  };
  remesh("one face", number_of_target_faces(1));
  remesh("no smoothing", smoothing_ratio(0).number_of_target_faces(1000));
  remesh("no contraction", collapse_ratio(0));
  remesh("no relaxation", number_of_relaxation_steps(0));
  remesh("split at once", split_ratio(1).number_of_target_faces(1000));
  remesh("contract all that is shorter", collapse_ratio(1).split_ratio(1));
  remesh("huge length", target_edge_length(1e10));
  remesh("sigma tiny", sigma(1e-300));
}

// what the visitor has heard, shared by its copies
struct Record
{
  std::vector<Hde::Stage> stages;
  std::vector<double> shares;
  std::size_t questions = 0;
};

struct Recording_visitor : Hde::Remeshing_visitor
{
  Record* record;
  std::size_t largest_number_of_questions = std::numeric_limits<std::size_t>::max(); // then it stops

  explicit Recording_visitor(Record& r) : record(&r) {}
  void stage_started(const Hde::Stage stage) { record->stages.push_back(stage); }
  void progress(const double share) { record->shares.push_back(share); }
  bool go_further() { return record->questions++ < largest_number_of_questions; }
};

void check_record(const Record& record, const bool is_complete)
{
  double last = 0;
  for (const double share : record.shares)
  {
    CHECK(share >= last && share <= 1);
    last = share;
  }
  if (is_complete)
    CHECK_CLOSE(last, 1, 1e-12);
}

void test_visitor()
{
  const Mesh input = ellipsoid(3);
  Record record;
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                       CGAL::parameters::visitor(Recording_visitor(record)));
  check_record(record, true);
  CHECK(record.stages == std::vector<Hde::Stage>({Hde::Stage::PROJECTION, Hde::Stage::REMESHING, Hde::Stage::OUTPUT}));
  CHECK(record.shares.size() >= 10);
  CHECK(record.questions >= 10);

  Record of_one_call;
  mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, CGAL::parameters::visitor(Recording_visitor(of_one_call)));
  check_record(of_one_call, true);
  CHECK(of_one_call.stages == std::vector<Hde::Stage>({Hde::Stage::IMPLICIT_FUNCTION, Hde::Stage::PROJECTION,
                                                       Hde::Stage::REMESHING, Hde::Stage::OUTPUT}));

  // a visitor that only listens changes nothing
  Mesh without = input;
  CGAL::anisotropic_hde_remeshing<Tag>(without, CGAL::parameters::default_values());
  CHECK(digest(mesh) == digest(without));
}

void test_stopping()
{
  const Mesh input = ellipsoid(3);
  for (const std::size_t questions : {0, 1, 2, 3, 5, 8, 13, 21, 34})
  {
    Record record;
    Recording_visitor visitor(record);
    visitor.largest_number_of_questions = questions;
    Mesh mesh = input;
    const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
        mesh, Ellipsoid_function(), CGAL::parameters::visitor(visitor).sigma(1).number_of_target_faces(4000));
    CHECK(result.was_stopped);
    CHECK(record.questions <= questions + 1); // asked no more after the answer
    check_record(record, false);
    check_validity("stopped after " + std::to_string(questions), input, mesh, Ellipsoid_function());
  }
}

struct Stop : std::runtime_error
{
  Stop() : std::runtime_error("stop") {}
};

// throws at the n-th call of any kind
struct Throwing_visitor : Hde::Remeshing_visitor
{
  std::size_t* calls;
  std::size_t n;

  Throwing_visitor(std::size_t& calls, const std::size_t n) : calls(&calls), n(n) {}
  void count() const
  {
    if (++*calls == n)
      throw Stop();
  }
  void stage_started(Hde::Stage) { count(); }
  void progress(double) { count(); }
  bool go_further()
  {
    count();
    return true;
  }
};

void test_throwing_visitor()
{
  const Mesh input = ellipsoid(3);
  std::size_t all = 0;
  {
    Mesh mesh = input;
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                         CGAL::parameters::visitor(Throwing_visitor(all, 0)));
  }
  CHECK(all > 20);
  // at the first calls, some in the middle, the last ones
  for (const std::size_t n : {std::size_t(1), std::size_t(2), std::size_t(3), std::size_t(10), all / 2, all - 1, all})
  {
    Mesh mesh = input;
    std::size_t calls = 0;
    CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                                      CGAL::parameters::visitor(Throwing_visitor(calls, n))),
                 Stop);
    CHECK(digest(mesh) == digest(input));
  }
}

// --- Functions that fail ---

struct Throwing_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const
  {
    if (p.x() > 0.99)
      throw Stop();
    return Ellipsoid_function::operator()(p);
  }
};

// values and gradients of no use on a part of the surface: not a number, or zero
struct Nan_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return p.z() > 3 ? nan_value : Ellipsoid_function::operator()(p); }
  Vector_3 gradient(const Point_3& p) const
  {
    return p.z() > 3 ? Vector_3(nan_value, 0, 0) : Ellipsoid_function::gradient(p);
  }
};

struct Zero_function : Ellipsoid_function
{
  FT operator()(const Point_3&) const { return 0; }
  Vector_3 gradient(const Point_3&) const { return Vector_3(0, 0, 0); }
};

// a surface that is nowhere near
struct Far_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const { return Ellipsoid_function::operator()(p + Vector_3(1000, 0, 0)); }
  Vector_3 gradient(const Point_3& p) const { return Ellipsoid_function::gradient(p + Vector_3(1000, 0, 0)); }
};

template <typename Function>
void check_survival(const char* name, const Function& function)
{
  const Mesh input = ellipsoid(3);
  Mesh mesh = input;
  Hde::Remeshing_result result;
  try
  {
    result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, CGAL::parameters::number_of_target_faces(2000));
  }
  catch (const std::exception& error)
  {
    std::cout << name << ": " << error.what() << std::endl;
    CHECK(digest(mesh) == digest(input));
    return;
  }
  std::cout << name << ": " << num_faces(mesh) << " faces, closest points " << result.projections.closest_point
            << std::endl;
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_closed(mesh));
  CHECK(Hde::measure_topology(mesh).euler_characteristic == 2);
  CHECK(result.projections.closest_point > 0);
  bool is_finite = true, is_near = true;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Point_3& p = mesh.point(v);
    is_finite = is_finite && std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
    is_near = is_near && std::abs(Ellipsoid_function()(p)) < 0.2;
  }
  CHECK(is_finite);
  CHECK(is_near);
}

void test_failing_functions()
{
  Mesh mesh = ellipsoid(3);
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Throwing_function()), Stop);
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<CGAL::Sequential_tag>(mesh, Throwing_function()), Stop);
  CHECK(digest(mesh) == digest(ellipsoid(3)));
  check_survival("NaN", Nan_function());
  check_survival("zero", Zero_function());
  check_survival("far", Far_function());
}

int main()
{
  test_invalid_meshes();
  test_invalid_parameters();
  test_extreme_parameters();
  test_visitor();
  test_stopping();
  test_throwing_visitor();
  test_failing_functions();
  return check_summary();
}
