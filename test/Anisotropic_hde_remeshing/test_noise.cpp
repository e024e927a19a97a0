// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Noise of points: it is found out, exact data are told from it, and the function is much nearer to the surface than the points.

#include "check.h"
#include "shapes.h"

#include <CGAL/Piecewise_rbf_implicit_function.h>
#include <CGAL/Rbf_implicit_function.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace shapes;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
using CGAL::Anisotropic_hde_remeshing::AUTOMATIC_SMOOTHING;
using CGAL::Anisotropic_hde_remeshing::Smoothing;

typedef CGAL::Rbf_implicit_function<Kernel> Function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Parallel_function;
typedef std::vector<std::pair<Point_3, Vector_3>> Points;

constexpr double radius = 2;
const double diagonal = 2 * std::sqrt(3.) * radius;

// On a sphere a point, its normal and the distance are known without a doubt. `offset` moves a point along its normal.
template <typename Offset>
Points sphere(const std::size_t n, const Offset& offset)
{
  Points result;
  for (const Point_3& p : spiral_points(n))
  {
    const Vector_3 normal = p - CGAL::ORIGIN;
    result.emplace_back(CGAL::ORIGIN + (radius + offset()) * normal, normal);
  }
  return result;
}

Points noisy_sphere(const std::size_t n, const double noise)
{
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(0, 1);
  return sphere(n, [&] { return noise > 0 ? noise * gauss(random) : 0.; });
}

double spacing(const std::size_t n) { return radius * std::sqrt(4 * pi / double(n)); }

// root mean squares of the distance of the zero set to the sphere, and of the angle between the normals in degrees
template <typename F>
std::pair<double, double> errors(const F& f)
{
  double distance = 0, angle = 0;
  const std::vector<Point_3> directions = spiral_points(3000);
  for (const Point_3& direction : directions)
  {
    const Vector_3 normal = direction - CGAL::ORIGIN;
    Point_3 p = CGAL::ORIGIN + radius * normal;
    for (int step = 0; step < 4; ++step)
    {
      const auto at_p = f.value_and_gradient(p);
      p = p - at_p.first / at_p.second.squared_length() * at_p.second;
    }
    const Vector_3 gradient = f.gradient(p);
    const double cosine =
        gradient * (p - CGAL::ORIGIN) / std::sqrt(gradient.squared_length() * CGAL::squared_distance(p, Point_3(CGAL::ORIGIN)));
    distance += std::pow(std::sqrt(CGAL::squared_distance(p, Point_3(CGAL::ORIGIN))) - radius, 2);
    angle += std::pow(std::acos((std::min)(cosine, 1.)) * 180 / pi, 2);
  }
  return {std::sqrt(distance / double(directions.size())), std::sqrt(angle / double(directions.size()))};
}

void test_estimate()
{
  const std::size_t n = 2500;
  for (const double relative_noise : {0.03, 0.1, 0.3, 0.5})
  {
    const double noise = relative_noise * spacing(n);
    const Points points = noisy_sphere(n, noise);
    const Parallel_function f(points, params::smoothing(AUTOMATIC_SMOOTHING));
    const auto [distance, angle] = errors(f);
    std::cout << "noise of " << relative_noise << " spacings: estimate " << f.diagnostics().noise / noise << ", rms "
              << distance / noise << " of it, normals " << angle << " degrees" << std::endl;
    CHECK_CLOSE(f.diagnostics().noise, noise, 0.15 * noise);
    CHECK(distance < 0.35 * noise);
    CHECK(angle < 4);
    CHECK(f.diagnostics().patches_on_fallback == 0);
    CHECK(distance < 0.5 * errors(Parallel_function(points)).first);
  }
}

bool are_equal(const Parallel_function& f, const Parallel_function& g)
{
  for (const Point_3& direction : spiral_points(500))
    for (const double at : {0.9, 1., 1.01})
    {
      const Point_3 p = CGAL::ORIGIN + at * radius * (direction - CGAL::ORIGIN);
      if (f.value_and_gradient(p) != g.value_and_gradient(p))
        return false;
    }
  return true;
}

// Exact points and vertices are interpolated, as without smoothing. That goes for the points on facets, too.
void test_exact_data()
{
  const Points points = noisy_sphere(2500, 0);
  const Parallel_function f(points, params::smoothing(AUTOMATIC_SMOOTHING));
  CHECK(f.diagnostics().noise == 0);
  CHECK(are_equal(f, Parallel_function(points)));
  CHECK(are_equal(f, Parallel_function(points, params::smoothing(0))));

  for (const Mesh& mesh :
       {icosphere(2), ellipsoid(2), ellipsoid(3), bumpy_sphere(2), torus(40, 10), cylinder(32, 3, 3), hills(30)})
    CHECK(Parallel_function(mesh, params::smoothing(AUTOMATIC_SMOOTHING)).diagnostics().noise == 0);

  const Mesh mesh = cylinder(32, 2, 3, radius);
  const Parallel_function g(mesh, params::smoothing(AUTOMATIC_SMOOTHING)), exact(mesh);
  CHECK(g.diagnostics().noise == 0);
  CHECK(g.diagnostics().number_of_points_on_facets == exact.diagnostics().number_of_points_on_facets);
  CHECK(are_equal(g, exact));
}

// The noise is a length: in another unit it is another number, and the surface is the same.
void test_unit()
{
  const std::size_t n = 1500;
  const double noise = 0.2 * spacing(n), unit = 1024;
  const Points points = noisy_sphere(n, noise);
  Points scaled;
  for (const auto& [p, normal] : points)
    scaled.emplace_back(CGAL::ORIGIN + unit * (p - CGAL::ORIGIN), normal);
  const Parallel_function f(points, params::smoothing(Smoothing(noise))), g(scaled, params::smoothing(unit * noise));
  CHECK_CLOSE(f.diagnostics().noise, noise, 1e-12);
  CHECK_CLOSE(g.diagnostics().noise, unit * noise, 1e-9);
  for (const Point_3& direction : spiral_points(200))
  {
    const Vector_3 way = radius * (direction - CGAL::ORIGIN);
    CHECK_CLOSE(unit * f(CGAL::ORIGIN + way), g(CGAL::ORIGIN + unit * way), 1e-9 * unit);
  }
}

void test_threads()
{
  const Points points = noisy_sphere(1500, 0.05);
  const Function f(points, params::smoothing(AUTOMATIC_SMOOTHING));
  const Parallel_function g(points, params::smoothing(AUTOMATIC_SMOOTHING));
  CHECK(f.diagnostics().noise == g.diagnostics().noise);
  for (const Point_3& direction : spiral_points(500))
  {
    const Point_3 p = CGAL::ORIGIN + radius * (direction - CGAL::ORIGIN);
    CHECK(f.value_and_gradient(p) == g.value_and_gradient(p));
  }
}

// Sharp edges of exact data are no noise, and noise is found beside them: a cube, its sides as one function and as pieces.
void test_edges()
{
  Mesh mesh = cube(12);
  const auto noise_of = [&] { return Parallel_function(mesh, params::smoothing(AUTOMATIC_SMOOTHING)).diagnostics().noise; };
  CHECK(noise_of() == 0);
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(0, 1);
  const double noise = 0.1 / 12;
  auto region = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region", 0).first;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Vector_3 normal =
        CGAL::normal(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
    for (int k = 0; k < 3; ++k)
      if (std::abs(normal[k]) > 0.5 * std::sqrt(normal.squared_length()))
        region[f] = std::size_t(2 * k + (normal[k] > 0 ? 1 : 0));
  }
  for (const Mesh::Vertex_index v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + noise * Vector_3(gauss(random), gauss(random), gauss(random));
  std::cout << "cube: estimate " << noise_of() / noise << std::endl;
  CHECK_CLOSE(noise_of(), noise, 0.25 * noise);
  typedef CGAL::Piecewise_rbf_implicit_function<Kernel> Piecewise_function;
  const Piecewise_function pieces(mesh, region, params::smoothing(AUTOMATIC_SMOOTHING));
  std::cout << "its sides: estimate " << pieces.diagnostics().noise / noise << std::endl;
  CHECK_CLOSE(pieces.diagnostics().noise, noise, 0.25 * noise);
}

// Other kernels, a sparse system among them
template <typename RadialFunction, typename NamedParameters>
void test_kernel(const RadialFunction& function, const NamedParameters& np)
{
  const std::size_t n = 2500;
  const double noise = 0.3 * spacing(n);
  const CGAL::Rbf_implicit_function<Kernel, RadialFunction, CGAL::Parallel_if_available_tag> f(
      noisy_sphere(n, noise), np.smoothing(noise).radial_function(function));
  const auto [distance, angle] = errors(f);
  std::cout << RadialFunction::name() << ": rms " << distance / noise << " of the noise, " << angle << " degrees, "
            << f.diagnostics().patches_with_sparse_cholesky << " sparse" << std::endl;
  CHECK(distance < 0.45 * noise);
}

void test_strange_data()
{
  const Points points = noisy_sphere(300, 0);
  for (const double strange : {1e-300, 1e6, 1e100})
  {
    const Parallel_function f(points, params::smoothing(strange));
    CHECK(std::isfinite(f(Point_3(0, 0, radius))));
  }
  for (const std::size_t n : {5, 30})
    CHECK_NO_THROW(Parallel_function(noisy_sphere(n, 0.01), params::smoothing(AUTOMATIC_SMOOTHING)));
  for (const double bad : {-1., std::nan(""), 1. / 0.})
    CHECK_THROWS(Parallel_function(points, params::smoothing(Smoothing(bad))), std::invalid_argument);
}

int main()
{
  test_estimate();
  test_exact_data();
  test_unit();
  test_threads();
  test_edges();
  test_kernel(CGAL::Thin_plate_rbf(), params::two_sided_offsets(false));
  test_kernel(CGAL::Wendland_C4_rbf(7), params::number_of_patches(1));
  test_strange_data();
  return check_summary();
}
