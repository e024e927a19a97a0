// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Gradients, Hessians and curvatures of Rbf_implicit_function: against differences, against exact formulas, across seams.

#include "check.h"
#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Random.h>
#include <CGAL/Rbf_implicit_function.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

using namespace shapes;

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Multiquadric_rbf, CGAL::Parallel_if_available_tag> Multiquadric_function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Wendland_C4_rbf, CGAL::Parallel_if_available_tag> Wendland_function;

const Ellipsoid_function exact;

Point_3 on_ellipsoid(const Point_3& p) { return Point_3(exact.a * p.x(), exact.b * p.y(), exact.c * p.z()); }

Eigen::Vector3d to_eigen(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }

Vector_3 unit_vector(const int axis) { return Vector_3(axis == 0, axis == 1, axis == 2); }

// points at random distances along the normals of the ellipsoid
std::vector<Point_3> points_near_the_surface(const std::size_t n, const double least_distance, const double largest_distance)
{
  CGAL::Random random(7);
  std::vector<Point_3> result;
  for (const Point_3& q : spiral_points(n))
  {
    const Point_3 p = on_ellipsoid(q);
    const Vector_3 normal = exact.gradient(p);
    result.push_back(p + random.get_double(least_distance, largest_distance) / std::sqrt(normal.squared_length()) * normal);
  }
  return result;
}

// the derivative of g along an axis by differences of fourth order
template <typename G>
auto difference(const G& g, const Point_3& p, const int axis) -> decltype(g(p))
{
  const double h = 5e-5;
  const Vector_3 step = h * unit_vector(axis);
  return (8 * (g(p + step) - g(p - step)) - (g(p + 2 * step) - g(p - 2 * step))) / (12 * h);
}

template <typename F>
double error_of_gradient(const F& f, const Point_3& p)
{
  Eigen::Vector3d differences;
  for (int i = 0; i < 3; ++i)
    differences[i] = difference(f, p, i);
  return (to_eigen(f.gradient(p)) - differences).norm() / differences.norm();
}

template <typename F>
double error_of_hessian(const F& f, const Point_3& p)
{
  Eigen::Matrix3d differences;
  for (int i = 0; i < 3; ++i)
    differences.col(i) = to_eigen(difference([&f](const Point_3& q) { return f.gradient(q); }, p, i));
  return (f.hessian(p) - differences).norm() / differences.norm();
}

// As many patches as these have slabs between them nearly everywhere, where the derivatives have the terms of the weights.
template <typename F>
void test_against_differences()
{
  const Mesh mesh = ellipsoid(3);
  for (const std::size_t number_of_patches : {26, 100})
  {
    const F f(mesh, params::number_of_patches(number_of_patches));
    CHECK(f.diagnostics().number_of_patches >= number_of_patches);
    CHECK(f.diagnostics().patches_on_fallback == 0);
    double gradient = 0, hessian = 0, far_gradient = 0;
    bool is_same = true;
    for (const Point_3& p : points_near_the_surface(2000, -0.05, 0.05))
    {
      gradient = (std::max)(gradient, error_of_gradient(f, p));
      hessian = (std::max)(hessian, error_of_hessian(f, p));
      const auto both = f.value_and_gradient(p);
      is_same = is_same && both.first == f(p) && both.second == f.gradient(p);
    }
    // through the passage to the distance, whose gradient is Lipschitz continuous outside of a convex mesh
    for (const Point_3& p : points_near_the_surface(500, 0.1, 3))
      far_gradient = (std::max)(far_gradient, error_of_gradient(f, p));
    std::cout << "against differences: gradient " << gradient << ", Hessian " << hessian << ", far gradient " << far_gradient
              << std::endl;
    CHECK(gradient <= 1e-6);
    CHECK(hessian <= 6e-6); // third derivatives jump at the centres and the seams
    CHECK(far_gradient <= 1e-5);
    CHECK(is_same);
  }
}

// T H T / |g| for the implicit function (x/a)^2 + (y/b)^2 + (z/c)^2, and its eigenvalues but for that of the normal
std::pair<double, double> exact_curvatures_of_ellipsoid(const Point_3& p)
{
  const Eigen::Vector3d inverse(1 / (exact.a * exact.a), 1 / (exact.b * exact.b), 1 / (exact.c * exact.c));
  const Eigen::Vector3d gradient = 2 * inverse.cwiseProduct(to_eigen(p - CGAL::ORIGIN)), normal = gradient.normalized();
  const Eigen::Matrix3d hessian = (2 * inverse).asDiagonal(),
                        tangential = Eigen::Matrix3d::Identity() - normal * normal.transpose(),
                        shape = tangential * hessian * tangential / gradient.norm();
  // all curvatures of the ellipsoid are positive: the zero is the normal's
  const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(shape).eigenvalues();
  return std::make_pair(values[1], values[2]);
}

// symmetric, without the normal, and the eigenvalues and eigenvectors are told
template <typename F>
void check_shape_operator(const F& f, const Point_3& p)
{
  const Eigen::Matrix3d hessian = f.hessian(p), shape = f.shape_operator(p);
  const Eigen::Vector3d normal = to_eigen(f.gradient(p)).normalized();
  const double size = hessian.norm() + 1;
  CHECK((hessian - hessian.transpose()).norm() <= 1e-14 * size);
  CHECK(shape == shape.transpose());
  CHECK((shape * normal).norm() <= 1e-13 * size);
  const auto curvatures = f.principal_curvatures(p);
  const double least = curvatures.min_curvature, largest = curvatures.max_curvature;
  const Eigen::Vector3d u = to_eigen(curvatures.min_direction), v = to_eigen(curvatures.max_direction);
  CHECK(least <= largest);
  CHECK((shape * u - least * u).norm() <= 1e-7 * size);
  CHECK((shape * v - largest * v).norm() <= 1e-7 * size);
  CHECK_CLOSE(least + largest, shape.trace(), 1e-12 * size);
  Eigen::Matrix3d basis;
  basis << u, v, normal;
  CHECK((basis.transpose() * basis - Eigen::Matrix3d::Identity()).norm() <= 1e-12);
}

void test_curvatures_of_ellipsoid()
{
  const double bounds[3] = {0.03, 0.01, 0.003};
  double last = 0;
  for (const unsigned int level : {3u, 4u, 5u})
  {
    const Function f(ellipsoid(level));
    double sum = 0, largest = 0;
    const std::size_t n = 3000;
    for (const Point_3& q : spiral_points(n))
    {
      const Point_3 p = on_ellipsoid(q);
      const auto curvatures = f.principal_curvatures(p);
      const std::pair<double, double> expected = exact_curvatures_of_ellipsoid(p);
      const double error =
          std::hypot(curvatures.min_curvature - expected.first, curvatures.max_curvature - expected.second) / expected.second;
      sum += error * error;
      largest = (std::max)(largest, error);
    }
    const double error = std::sqrt(sum / double(n));
    std::cout << "curvatures of the ellipsoid, level " << level << ": relative error, rms " << error << ", largest " << largest
              << ", order " << std::log2(last / error) << std::endl;
    CHECK(error <= bounds[level - 3]);
    CHECK(level == 3 || std::log2(last / error) >= 1);
    last = error;
    for (const Point_3& p : points_near_the_surface(50, -0.05, 0.05))
      check_shape_operator(f, p);
  }
}

// the largest difference to the curvatures `expected(p)` at points of a known surface
template <typename F, typename Expected>
double error_of_curvatures(const F& f, const std::vector<Point_3>& points, const Expected& expected)
{
  double result = 0;
  for (const Point_3& p : points)
  {
    const auto curvatures = f.principal_curvatures(p);
    const std::pair<double, double> values = expected(p);
    result = (std::max)(
        {result, std::abs(curvatures.min_curvature - values.first), std::abs(curvatures.max_curvature - values.second)});
  }
  return result;
}

template <typename F>
void test_curvatures_of_sphere()
{
  const double radius = 2;
  Mesh mesh = icosphere(4, radius);
  std::vector<Point_3> points;
  for (const Point_3& q : spiral_points(500))
    points.push_back(CGAL::ORIGIN + radius * (q - CGAL::ORIGIN));
  const double error =
      error_of_curvatures(F(mesh), points, [&](const Point_3&) { return std::make_pair(1 / radius, 1 / radius); });
  // seen from the other side it is hollow
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  const double hollow_error =
      error_of_curvatures(F(mesh), points, [&](const Point_3&) { return std::make_pair(-1 / radius, -1 / radius); });
  std::cout << "curvatures of the sphere: largest error " << error << ", from inside " << hollow_error << std::endl;
  CHECK(error <= 0.02 / radius);
  CHECK(hollow_error <= 0.02 / radius);
}

// where the data end, at the boundary, curvatures are worse
void test_curvatures_of_cylinder()
{
  const Function f(cylinder(60, 30, 3));
  std::vector<Point_3> points;
  for (const Point_3& q : spiral_points(500))
    points.emplace_back(q.x() / std::hypot(q.x(), q.y()), q.y() / std::hypot(q.x(), q.y()), 1.5 + q.z());
  const double error = error_of_curvatures(f, points, [](const Point_3&) { return std::make_pair(0., 1.); });
  std::cout << "curvatures of the cylinder: largest error " << error << std::endl;
  CHECK(error <= 0.05);
  for (const Point_3& p : points)
  {
    const auto curvatures = f.principal_curvatures(p);
    CHECK(std::abs(curvatures.min_direction.z()) > 0.99);
  }
}

void test_curvatures_of_torus()
{
  const Torus_function torus_function;
  const Function f(torus(120, 40));
  std::vector<Point_3> points;
  for (int i = 0; i < 37; ++i)
    for (int j = 0; j < 23; ++j)
    {
      const double u = 2 * pi * i / 37, v = 2 * pi * j / 23,
                   radius = torus_function.large_radius + torus_function.small_radius * std::cos(v);
      points.emplace_back(radius * std::cos(u), radius * std::sin(u), torus_function.small_radius * std::sin(v));
    }
  const auto expected = [&](const Point_3& p)
  {
    const double radius = std::hypot(p.x(), p.y());
    // cos(v) / radius, positive on the outer half only
    return std::make_pair((radius - torus_function.large_radius) / (torus_function.small_radius * radius),
                          1 / torus_function.small_radius);
  };
  const double error = error_of_curvatures(f, points, expected);
  std::cout << "curvatures of the torus: largest error " << error << std::endl;
  CHECK(error <= 0.1);
  std::size_t wrong_signs = 0;
  for (const Point_3& p : points)
    if (std::abs(expected(p).first) > 0.1)
      wrong_signs += f.principal_curvatures(p).min_curvature * expected(p).first > 0 ? 0 : 1;
  CHECK(wrong_signs == 0);
}

// the patches and their tree without the function about them, in normalised coordinates
template <typename Radial_function>
struct Bare_interpolant
{
  typedef internal::Patchwise_interpolant<Radial_function, CGAL::Parallel_if_available_tag> Interpolant;

  internal::Normalization normalization;
  std::unique_ptr<Interpolant> interpolant;

  Bare_interpolant(const Mesh& mesh, const std::size_t number_of_patches)
  {
    internal::Interruption never;
    const auto sample = std::make_shared<internal::Surface_sample>(
        internal::sample_mesh(mesh, mesh.points(), CGAL::internal_np::Param_not_found(), never));
    normalization = sample->normalization;
    internal::Interpolation_parameters parameters;
    parameters.number_of_patches = number_of_patches;
    interpolant = std::make_unique<Interpolant>(sample, std::make_shared<internal::Facet_distance>(sample), parameters,
                                                Radial_function(), normalization.scale, never);
  }
};

struct Jumps
{
  double value = 0, angle = 0, hessian = 0;
  std::size_t number = 0;
};

// the jumps over the plane at the foot of `p` on it, if the patches that count change there
template <typename Interpolant>
void add_jumps(const Interpolant& interpolant, const internal::Vector& normal, const double position, internal::Vector p,
               Jumps& jumps)
{
  const auto patches_at = [&](const internal::Vector& q)
  {
    std::set<std::size_t> result;
    interpolant.tree().visit_leaves(q, [&](const std::size_t k) { result.insert(k); });
    return result;
  };
  p += (position - normal.dot(p)) * normal;
  const internal::Vector before = p - 1e-14 * normal, after = p + 1e-14 * normal;
  if (patches_at(before) == patches_at(after))
    return;
  const internal::Jet<2> left = interpolant.template evaluate<2>(before), right = interpolant.template evaluate<2>(after);
  jumps.value = (std::max)(jumps.value, std::abs(left.value - right.value));
  jumps.angle =
      (std::max)(jumps.angle, std::atan2(left.gradient.cross(right.gradient).norm(), left.gradient.dot(right.gradient)));
  jumps.hessian = (std::max)(jumps.hessian, (left.hessian - right.hessian).norm() / left.hessian.norm());
  ++jumps.number;
}

// Each slab is bounded by two planes, beyond which one of its sides counts no more. Points near the planes.
template <typename Radial_function>
Jumps largest_jumps(const Bare_interpolant<Radial_function>& bare, const std::vector<Point_3>& near_surface)
{
  std::vector<internal::Vector> points;
  for (const Point_3& p : near_surface)
    points.push_back(bare.normalization(to_eigen(p - CGAL::ORIGIN)));
  Jumps jumps;
  std::size_t number_of_planes = 0, number_of_planes_with_points = 0;
  bare.interpolant->tree().visit_slabs(
      [&](const internal::Vector& normal, const double position, const double half_width)
      {
        CHECK(half_width > 0);
        for (const double plane : {position - half_width, position + half_width})
        {
          const std::size_t before = jumps.number;
          for (const internal::Vector& p : points)
            if (std::abs(normal.dot(p) - plane) < 0.2 * half_width)
              add_jumps(*bare.interpolant, normal, plane, p, jumps);
          number_of_planes_with_points += jumps.number > before ? 1 : 0;
          ++number_of_planes;
        }
      });
  std::cout << Radial_function::name() << ": jumps at " << jumps.number << " points of " << number_of_planes_with_points
            << " planes: value/D " << jumps.value << ", normal " << jumps.angle << ", Hessian " << jumps.hessian << std::endl;
  CHECK(2 * number_of_planes_with_points > number_of_planes);
  return jumps;
}

template <typename Radial_function>
void test_seams()
{
  const Jumps jumps =
      largest_jumps(Bare_interpolant<Radial_function>(ellipsoid(3), 60), points_near_the_surface(4000, -0.05, 0.05));
  CHECK(jumps.number > 2000);
  CHECK(jumps.value <= 0.5e-12); // the diagonal is from 1/2 to 1
  CHECK(jumps.angle <= 1e-9);
  CHECK(jumps.hessian <= 1e-6);
}

// a mesh some of whose patches are left to the input itself, random points on its faces
void test_seams_of_fallback()
{
  Mesh mesh;
  if (!CHECK(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(CGAL::data_file_path("meshes/anchor.off"), mesh)))
    return;
  const Bare_interpolant<CGAL::Polyharmonic_rbf> bare(mesh, 40);
  const std::size_t on_fallback = bare.interpolant->diagnostics().patches_on_fallback;
  std::cout << "anchor: " << on_fallback << " of " << bare.interpolant->diagnostics().number_of_patches
            << " patches on fallback" << std::endl;
  CHECK(on_fallback > 0 && on_fallback < bare.interpolant->diagnostics().number_of_patches);
  std::vector<Point_3> points;
  CGAL::Random random(29);
  for (const Mesh::Face_index f : mesh.faces())
    for (int k = 0; k < 20; ++k)
    {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      const double u = std::sqrt(random.get_double()), v = random.get_double();
      points.push_back(CGAL::barycenter(mesh.point(mesh.source(h)), 1 - u, mesh.point(mesh.target(h)), u * (1 - v),
                                        mesh.point(mesh.target(mesh.next(h))), u * v));
    }
  // the directions of a distance jump wherever two facets are equally near
  CHECK(largest_jumps(bare, points).value <= 0.5e-12);
}

// a cube of 12 triangles is left to the input itself: no second derivatives but those of the blends, symmetric all the same
void test_fallback()
{
  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                    {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  const Mesh mesh = to_mesh(soup);
  for (const std::size_t number_of_patches : {1, 3})
  {
    const Function f(mesh, params::number_of_patches(number_of_patches));
    CHECK(f.diagnostics().patches_on_fallback > 0);
    for (const Point_3& q : spiral_points(100))
      check_shape_operator(f, Point_3(0.5, 0.5, 0.5) + 0.7 * (q - CGAL::ORIGIN));
  }
}

void test_without_gradient()
{
  internal::Jet<2> jet;
  jet.hessian.setIdentity();
  CHECK(internal::shape_operator(jet).isZero(0));
  const auto curvatures = internal::principal_curvatures<Kernel>(jet, 1);
  CHECK(curvatures.min_curvature == 0 && curvatures.max_curvature == 0);
  CHECK_CLOSE(curvatures.min_direction.squared_length(), 1, 1e-14);
}

int main()
{
  test_against_differences<Function>();
  test_against_differences<Multiquadric_function>();
  test_against_differences<Wendland_function>();
  test_curvatures_of_ellipsoid();
  test_curvatures_of_sphere<Function>();
  test_curvatures_of_sphere<Wendland_function>();
  test_curvatures_of_cylinder();
  test_curvatures_of_torus();
  test_seams<CGAL::Polyharmonic_rbf>();
  test_seams<CGAL::Multiquadric_rbf>();
  test_seams<CGAL::Wendland_C4_rbf>();
  test_seams_of_fallback();
  test_fallback();
  test_without_gradient();
  return check_summary();
}
