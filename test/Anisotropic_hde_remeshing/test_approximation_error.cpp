// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
// The distance to the surface: asymptotic bounds, an error as the target, which the result keeps, and vertices fitted to the
// surface.

#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/approximation_bounds.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

using namespace shapes;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

// on a sphere the integrals are known
void test_bounds()
{
  const Mesh sphere = icosphere(5);
  const double n = double(sphere.number_of_faces()), area = 4 * pi;
  const Hde::Approximation_bounds bounds = Hde::approximation_bounds(sphere, Sphere_function());
  CHECK(bounds.number_of_faces == sphere.number_of_faces());
  CHECK_CLOSE(bounds.rms_on_surface, 0.298142 * area / n, 0.01 * bounds.rms_on_surface);
  CHECK_CLOSE(bounds.rms_off_surface, 0.0745356 * area / n, 0.01 * bounds.rms_off_surface);
  CHECK_CLOSE(bounds.max_on_surface, 0.3849 * area / n, 0.01 * bounds.max_on_surface);
  CHECK_CLOSE(bounds.max_off_surface, 0.5 * bounds.max_on_surface, 1e-12);
  const Hde::Approximation_bounds of_ten = bounds.for_number_of_faces(10);
  CHECK(of_ten.number_of_faces == 10);
  CHECK_CLOSE(of_ten.max_on_surface, 0.3849 * area / 10, 0.01 * of_ten.max_on_surface);
  CHECK_CLOSE(of_ten.rms_on_surface, 0.298142 * area / 10, 0.01 * of_ten.rms_on_surface);
  CHECK_CLOSE(of_ten.rms_off_surface, 0.0745356 * area / 10, 0.01 * of_ten.rms_off_surface);
  // a mesh of nearly equilateral triangles comes near it, never below
  const double rms = Hde::measure_distance_to_zero_set(sphere, Sphere_function()).face_rms;
  CHECK(rms > 0.999 * bounds.rms_on_surface && rms < 1.1 * bounds.rms_on_surface);
  CHECK(Hde::approximation_bounds(Mesh(), Sphere_function()).number_of_faces == 0);
}

// of points of a fine grid on the faces; every function here has a zero set that Newton's method finds along the gradient
template <typename Function>
double largest_distance(const Mesh& mesh, const Function& function)
{
  static constexpr int n = 12;
  double largest = 0;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
      {
        const Point_3 p = a + double(i) / n * (b - a) + double(j) / n * (c - a);
        Point_3 q = p;
        for (int step = 0; step < 5; ++step)
        {
          const Vector_3 g = function.gradient(q);
          q = q - function(q) / g.squared_length() * g;
        }
        largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(p, q)));
      }
  }
  return largest;
}

template <typename Function>
void test_error(const std::string& name, const Mesh& input, const Function& function, const double relative_error,
                const double largest_ratio)
{
  const double error = relative_error * bounding_box_diagonal(input);
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::relative_approximation_error(relative_error));
  remeshing_checks::check_validity(name, input, mesh, function);
  const double distance = largest_distance(mesh, function);
  const double ratio = Hde::approximation_bounds(mesh, function).max_on_surface / error;
  std::cout << "  error " << relative_error << " D: " << mesh.number_of_faces() << " faces, " << ratio
            << " of the bound's efficiency inverted, distance / error " << distance / error << ", said to be "
            << result.approximation_error / error << std::endl;
  CHECK(result.binding_target == Hde::Target::APPROXIMATION_ERROR);
  CHECK(result.approximation_error <= error * (1 + 1e-12));
  CHECK(distance <= result.approximation_error * (1 + 1e-9));
  CHECK(1 / ratio <= largest_ratio);

  // the same by one thread, and in the unit of the mesh
  Mesh same = input, absolute = input;
  {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
#endif
    CGAL::anisotropic_hde_remeshing<Tag>(same, function, params::relative_approximation_error(relative_error));
  }
  CHECK(remeshing_checks::digest(mesh) == remeshing_checks::digest(same));
  CHECK(CGAL::anisotropic_hde_remeshing<Tag>(absolute, function, params::approximation_error(error)).approximation_error <=
        error * (1 + 1e-12));
  CHECK_CLOSE(double(absolute.number_of_faces()), double(mesh.number_of_faces()), 0.1 * double(mesh.number_of_faces()));
}

void test_errors()
{
  test_error("ellipsoid", ellipsoid(5), Ellipsoid_function(), 1e-3, 1.8);
  test_error("ellipsoid", ellipsoid(5), Ellipsoid_function(), 2e-4, 1.6);
  test_error("torus", torus(256, 64), Torus_function(), 1e-3, 1.8);

  // other embeddings, too, need more faces
  Mesh by_normals = ellipsoid(5), by_metric = by_normals;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(
      by_normals, Ellipsoid_function(), params::relative_sigma(0.15).relative_approximation_error(5e-4));
  CHECK(result.approximation_error <= 5e-4 * bounding_box_diagonal(by_metric) * (1 + 1e-12));
  CGAL::anisotropic_hde_remeshing<Tag>(by_metric, Ellipsoid_function(), params::relative_approximation_error(5e-4));
  CHECK(by_metric.number_of_faces() < by_normals.number_of_faces());

  // the number of faces binds first
  Mesh few = ellipsoid(5);
  const Hde::Remeshing_result of_few = CGAL::anisotropic_hde_remeshing<Tag>(
      few, Ellipsoid_function(), params::relative_approximation_error(1e-4).number_of_target_faces(1000));
  CHECK(of_few.binding_target == Hde::Target::NUMBER_OF_FACES);
  remeshing_checks::check_number_of_faces(few, 1000);
  CHECK(of_few.approximation_error > 1e-4 * bounding_box_diagonal(few));
  CHECK(largest_distance(few, Ellipsoid_function()) <= of_few.approximation_error);
  // it does not
  Mesh many = ellipsoid(5);
  CHECK(CGAL::anisotropic_hde_remeshing<Tag>(many, Ellipsoid_function(),
                                             params::relative_approximation_error(1e-3).number_of_target_faces(100000))
            .binding_target == Hde::Target::APPROXIMATION_ERROR);
  CHECK(many.number_of_faces() < 5000);

  for (const double bad : {0., -1., std::nan(""), std::numeric_limits<double>::infinity()})
  {
    Mesh mesh = ellipsoid(2);
    CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::approximation_error(bad)),
                 std::invalid_argument);
    CHECK_THROWS(CGAL::anisotropic_hde_remeshing<Tag>(mesh, Ellipsoid_function(), params::relative_approximation_error(bad)),
                 std::invalid_argument);
  }
}

void test_fit()
{
  const Mesh input = ellipsoid(5);
  Mesh on_surface = input, fitted = input;
  CGAL::anisotropic_hde_remeshing<Tag>(on_surface, Ellipsoid_function(),
                                       params::relative_sigma(0.15).number_of_target_faces(4000));
  CGAL::anisotropic_hde_remeshing<Tag>(fitted, Ellipsoid_function(),
                                       params::relative_sigma(0.15).number_of_target_faces(4000).fit_to_surface(true));
  // only positions differ; the distance becomes a third of what it was: at best a quarter, where the surface is curved to one side
  CHECK(fitted.number_of_faces() == on_surface.number_of_faces());
  remeshing_checks::check_validity("fitted", input, fitted, Ellipsoid_function(), 1e-2);
  const double before = Hde::measure_distance_to_zero_set(on_surface, Ellipsoid_function()).face_rms,
               after = Hde::measure_distance_to_zero_set(fitted, Ellipsoid_function()).face_rms;
  std::cout << "fit: rms from " << before << " to " << after << std::endl;
  CHECK(3 * after < before);

  // the boundary stays
  const Mesh half = half_sphere(24);
  Mesh open = half, open_fitted = half;
  const auto np = params::relative_sigma(0.1).number_of_target_faces(2000);
  CGAL::anisotropic_hde_remeshing<Tag>(open, Sphere_function(), np);
  CGAL::anisotropic_hde_remeshing<Tag>(open_fitted, Sphere_function(), np.fit_to_surface(true));
  CHECK(open.number_of_vertices() == open_fitted.number_of_vertices());
  std::size_t number_on_boundary = 0, number_moved = 0;
  for (const Mesh::Vertex_index v : open.vertices())
    if (open.is_border(v))
    {
      ++number_on_boundary;
      CHECK(open.point(v) == open_fitted.point(v));
    }
    else
      number_moved += open.point(v) != open_fitted.point(v) ? 1 : 0;
  CHECK(number_on_boundary > 10 && 2 * number_moved > open.number_of_vertices());
  CHECK(3 * Hde::measure_distance_to_zero_set(open_fitted, Sphere_function()).face_rms <
        2 * Hde::measure_distance_to_zero_set(open, Sphere_function()).face_rms);
}

int main()
{
  test_bounds();
  test_errors();
  test_fit();
  return check_summary();
}
