// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// An error that is asked for without a function: the largest distance between the mesh and the facets of the input, both ways.

#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Distance_check.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef internal::Vector Vector;

// The check against the points of a fine grid: it never passes a triangle that has a point further than the limit, and passes
// each whose points are all clearly nearer.
void test_check_of_a_triangle()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&](const double height) { return Vector(number(random), number(random), height * number(random)); };
  std::vector<Vector> points;
  std::vector<internal::Facet> facets;
  for (std::size_t i = 0; i < 60; ++i)
  {
    for (int k = 0; k < 3; ++k)
      points.push_back(point(0.2));
    facets.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const internal::Closest_facet closest_facet(points, facets);
  const internal::Distance_check check(points, facets, closest_facet);
  std::size_t number_within = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Vector a = point(0.2), b = point(0.2), c = point(0.2);
    double largest = 0;
    const int n = 40;
    for (int j = 0; j <= n; ++j)
      for (int k = 0; j + k <= n; ++k)
      {
        const Vector p = (j * a + k * b + (n - j - k) * c) / n;
        largest = (std::max)(largest, (closest_facet(p).point - p).norm());
      }
    for (const double limit : {0.05, 0.1, 0.2})
    {
      const internal::Distance_check::Answer answer = check({check.look_at(a), check.look_at(b), check.look_at(c)}, limit);
      number_within += answer.is_within ? 1 : 0;
      if (answer.is_within)
        CHECK(largest <= answer.bound + 1e-12 && answer.bound <= limit);
      else
        CHECK(largest + 2. / n > 0.98 * limit && answer.farthest.distance <= answer.bound && answer.bound > limit);
    }
  }
  CHECK(number_within > 50 && number_within < 550);
}

// The bound holds by the package's measures, too, which know nothing of it. A larger error takes no more faces.
template <typename NamedParameters>
void test_error(const std::string& name, const Mesh& input, const NamedParameters& np)
{
  std::size_t last = input.number_of_faces();
  const double diagonal = bounding_box_diagonal(input);
  for (const double relative_error : {5e-4, 2e-3, 1e-2})
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result =
        CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::begin_with(np).relative_approximation_error(relative_error));
    const Hde::Distance_measures distance = Hde::measure_distance<Tag>(mesh, input);
    std::cout << name << ", error " << relative_error << ": " << mesh.number_of_faces() << " faces, largest distance "
              << distance.max() / diagonal << ", bound " << result.approximation_error / diagonal << std::endl;
    CHECK(result.approximation_error <= relative_error * diagonal * (1 + 1e-12));
    CHECK(distance.max() <= result.approximation_error * (1 + 1e-9));
    CHECK(result.binding_target == Hde::Target::APPROXIMATION_ERROR);
    CHECK(result.sigma == 0);
    CHECK(mesh.number_of_faces() <= last);
    check_same_topology(input, mesh);
    last = mesh.number_of_faces();
  }
}

// the absolute error is the same as the relative one; the number of threads does not matter
void test_same_error()
{
  const Mesh input = bumpy_sphere(4);
  Mesh relative = input, absolute = input;
  CGAL::anisotropic_hde_remeshing<Tag>(relative, params::relative_approximation_error(2e-3));
  CGAL::anisotropic_hde_remeshing<CGAL::Sequential_tag>(absolute,
                                                        params::approximation_error(2e-3 * bounding_box_diagonal(input)));
  CHECK(digest(relative) == digest(absolute));
}

// far from the origin the mesh is the same but for rounding
void test_far_from_origin()
{
  const Mesh input = bumpy_sphere(4);
  for (const double distance : {1e3, 1e6})
  {
    Mesh near = input, far = input;
    for (const Mesh::Vertex_index v : far.vertices())
      far.point(v) = far.point(v) + distance * Vector_3(1, -2, 0.5);
    CGAL::anisotropic_hde_remeshing<Tag>(near, params::relative_approximation_error(3e-3));
    CGAL::anisotropic_hde_remeshing<Tag>(far, params::relative_approximation_error(3e-3));
    std::cout << "faces at the origin " << near.number_of_faces() << ", " << distance << " from it " << far.number_of_faces()
              << std::endl;
    CHECK(std::abs(double(far.number_of_faces()) - double(near.number_of_faces())) < 0.1 * double(near.number_of_faces()));
  }
}

// a number of faces that does not suffice is kept, and the bound is told
void test_number_of_faces()
{
  const Mesh input = bumpy_sphere(4);
  const double diagonal = bounding_box_diagonal(input);
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::relative_approximation_error(5e-4).number_of_target_faces(300));
  check_number_of_faces(mesh, 300);
  CHECK(result.binding_target == Hde::Target::NUMBER_OF_FACES);
  CHECK(result.approximation_error > 5e-4 * diagonal);
  CHECK(Hde::measure_distance<Tag>(mesh, input).max() <= result.approximation_error * (1 + 1e-9));
  mesh = input;
  const Hde::Remeshing_result plenty =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::relative_approximation_error(1e-2).number_of_target_faces(4000));
  CHECK(plenty.binding_target == Hde::Target::APPROXIMATION_ERROR && mesh.number_of_faces() < 4000);
}

// who gives an embedding or a function gets the error of that method
void test_schemes()
{
  const Mesh input = icosphere(3);
  const auto sigma_of = [&](const auto& np)
  {
    Mesh mesh = input;
    return CGAL::anisotropic_hde_remeshing<Tag>(mesh, np).sigma;
  };
  CHECK(sigma_of(params::relative_approximation_error(1e-2)) == 0);
  CHECK(sigma_of(params::relative_approximation_error(1e-2).sigma(0.1)) == 0.1);
}

void test_stopping()
{
  check_stopping(
      bumpy_sphere(3), 60, 7,
      [](Mesh& mesh, auto& visitor) {
        return CGAL::anisotropic_hde_remeshing<Tag>(mesh,
                                                    params::relative_approximation_error(3e-3).visitor(std::ref(visitor)));
      },
      [](const Hde::Remeshing_result& result, const Mesh&)
      { CHECK(result.was_stopped == std::isinf(result.approximation_error)); });
}

int main()
{
  test_check_of_a_triangle();
  test_error("bumpy sphere", bumpy_sphere(4), params::default_values());
  test_error("hills", hills(60), params::default_values());
  test_error("half sphere", half_sphere(24), params::default_values()); // its boundary is a circle
  test_error("block with creases", l_block(12), params::sharp_angle(30));
  test_same_error();
  test_far_from_origin();
  test_number_of_faces();
  test_schemes();
  test_stopping();
  return check_summary();
}
