// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The parallel parts under ThreadSanitizer, which fails the test where threads race: building and evaluating the function, both
// schemes, constraints, tests of self-intersection, an error as the target, measures; a visitor that stops and a function that
// throws. The result is that of one thread. All but the error with the remesher that tests for self-intersections, as fewer remeshers
// compile sooner.
//   test_threads [all]: both schemes with and without the tests, as scripts/run_tests.sh --all does

#include "../check.h"
#include "../remeshing_checks.h"
#include "../shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Function;

std::uint64_t digest_of_remeshing(const Hde::Remeshing_scheme scheme, const bool has_tests)
{
  Mesh mesh = ellipsoid(3);
  const Function function(mesh);
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  for (const Mesh::Face_index f : mesh.faces())
    patch[f] = mesh.point(mesh.target(mesh.halfedge(f))).z() > 0 ? 1 : 0;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, function,
                                       params::relative_sigma(0.1)
                                           .number_of_target_faces(2000)
                                           .number_of_iterations(4)
                                           .remeshing_scheme(scheme)
                                           .face_patch_map(patch)
                                           .fit_to_surface(has_tests)
                                           .do_self_intersection_tests(has_tests));
  const auto embedding = Hde::measure_embedding<Tag>(mesh, function);
  const auto distance = Hde::measure_distance_to_zero_set<Tag>(mesh, function);
  CHECK(embedding.number_of_folded_faces == 0);
  CHECK(std::isfinite(distance.face_rms));
  return remeshing_checks::digest(mesh);
}

std::uint64_t digest_with_error()
{
  Mesh mesh = ellipsoid(3);
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(),
                                       params::relative_approximation_error(2e-3).number_of_iterations(4));
  return remeshing_checks::digest(mesh);
}

struct Stopping_visitor : Hde::Remeshing_visitor
{
  int* questions;
  bool go_further() { return ++*questions < 40; }
};

struct Failure : std::runtime_error
{
  Failure() : std::runtime_error("failure") {}
};

struct Failing_function : Ellipsoid_function
{
  FT operator()(const Point_3& p) const
  {
    if (p.x() > 0.9)
      throw Failure();
    return Ellipsoid_function::operator()(p);
  }
};

// whether many threads make the same of it as one
template <typename Digest>
bool is_independent_of_threads(const Digest& digest)
{
  const std::uint64_t of_many = digest();
  const std::size_t many = Hde::internal::number_of_threads;
  Hde::internal::number_of_threads = 1;
  const std::uint64_t of_one = digest();
  Hde::internal::number_of_threads = many;
  return of_many == of_one;
}

int main(int argc, char*[])
{
  const bool is_all = argc > 1;
  for (const auto scheme : {Hde::Remeshing_scheme::DEFAULT, Hde::Remeshing_scheme::PAPER})
    for (const bool has_tests : {false, true})
      if (is_all || has_tests == (scheme == Hde::Remeshing_scheme::DEFAULT))
        CHECK(is_independent_of_threads([=] { return digest_of_remeshing(scheme, has_tests); }));
  CHECK(is_independent_of_threads(digest_with_error));

  const auto np = params::do_self_intersection_tests(false);
  Mesh mesh = ellipsoid(3);
  int questions = 0;
  Stopping_visitor visitor;
  visitor.questions = &questions;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), np.visitor(visitor));
  CHECK(questions >= 40);
  CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Failing_function(), np), Failure);
  return check_summary();
}
