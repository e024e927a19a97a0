// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The mathematics of Rbf_implicit_function: interpolation, accuracy on a known surface, smoothness, sign.

#include "check.h"
#include "shapes.h"

#include <CGAL/Random.h>
#include <CGAL/Rbf_implicit_function.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace shapes;

typedef CGAL::Rbf_implicit_function<Kernel> Function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Thin_plate_rbf> Thin_plate_function;

const Ellipsoid_function exact;
const double diagonal = 2 * std::sqrt(30.); // of the box of the ellipsoid

Point_3 on_ellipsoid(const Point_3& p)
{
  return Point_3(exact.a * p.x(), exact.b * p.y(), exact.c * p.z());
}

Vector_3 unit_normal(const Point_3& p)
{
  const Vector_3 gradient = exact.gradient(p);
  return gradient / std::sqrt(gradient.squared_length());
}

// a mesh with the exact normals of the ellipsoid
struct Ellipsoid_with_normals
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Vector_3> normals;

  explicit Ellipsoid_with_normals(const unsigned int level) : mesh(ellipsoid(level))
  {
    normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:exact_normal").first;
    for (const Mesh::Vertex_index v : mesh.vertices())
      normals[v] = unit_normal(mesh.point(v));
  }
};

// The distance of the zero set to the ellipsoid, to first order, as it is small: rms over the area of the ellipsoid, over
// the diagonal. The area of the ellipsoid over that of the unit sphere is 10 |(x, y / 2, z / 5)| at (x, y, z) of the sphere.
template <typename F>
double rms_distance(const F& f)
{
  double sum = 0, weights = 0;
  for (const Point_3& q : spiral_points(20000))
  {
    const double weight = std::sqrt(q.x() * q.x() + q.y() * q.y() / 4 + q.z() * q.z() / 25);
    const auto at_p = f.value_and_gradient(on_ellipsoid(q));
    sum += weight * at_p.first * at_p.first / at_p.second.squared_length();
    weights += weight;
  }
  return std::sqrt(sum / weights) / diagonal;
}

// random points within `distance` of the ellipsoid
std::vector<Point_3> points_near_the_surface(const std::size_t n, const double distance)
{
  CGAL::Random random(7);
  std::vector<Point_3> result;
  for (const Point_3& q : spiral_points(n))
  {
    const Point_3 p = on_ellipsoid(q);
    result.push_back(p + random.get_double(-distance, distance) * unit_normal(p));
  }
  return result;
}

void test_accuracy()
{
  const double error_3 = rms_distance(Function(ellipsoid(3))), error_4 = rms_distance(Function(ellipsoid(4)));
  std::cout << "r^3: rms/D " << error_3 << " " << error_4 << ", order " << std::log2(error_3 / error_4) << std::endl;
  CHECK(error_3 < 5e-5);
  CHECK(error_4 < 4e-6);
  CHECK(std::log2(error_3 / error_4) >= 3);

  // on finer meshes patches with a wider view keep the order
  const auto overlap = CGAL::parameters::patch_overlap(5);
  const double wide_4 = rms_distance(Function(ellipsoid(4), overlap)),
               wide_5 = rms_distance(Function(ellipsoid(5), overlap));
  std::cout << "r^3, overlap 5: rms/D " << wide_4 << " " << wide_5 << ", order " << std::log2(wide_4 / wide_5)
            << std::endl;
  CHECK(wide_5 < 4e-7);
  CHECK(std::log2(wide_4 / wide_5) >= 3);

  const double thin_plate_3 = rms_distance(Thin_plate_function(ellipsoid(3))),
               thin_plate_4 = rms_distance(Thin_plate_function(ellipsoid(4)));
  std::cout << "thin plate: rms/D " << thin_plate_3 << " " << thin_plate_4 << std::endl;
  CHECK(thin_plate_3 < 4e-4);
  CHECK(std::log2(thin_plate_3 / thin_plate_4) >= 2);
  CHECK(thin_plate_4 > error_4);
}

template <typename F>
void test_interpolation()
{
  const Ellipsoid_with_normals input(4);
  const double offset = 0.01;
  const F f(input.mesh, CGAL::parameters::offset_distance(offset).vertex_normal_map(input.normals));
  CHECK(f.diagnostics().number_of_points == 2562);
  CHECK(f.diagnostics().number_of_shortened_offsets == 0);
  CHECK(f.diagnostics().patches_on_fallback == 0);
  CHECK(f.diagnostics().worst_residual <= 1e-9);
  double on_surface = 0, off_surface = 0;
  for (const Mesh::Vertex_index v : input.mesh.vertices())
  {
    const Point_3& p = input.mesh.point(v);
    on_surface = (std::max)(on_surface, std::abs(f(p)));
    off_surface = (std::max)(off_surface, std::abs(f(p + offset * input.normals[v]) - offset));
  }
  std::cout << "residuals/offset: " << on_surface / offset << " " << off_surface / offset << std::endl;
  CHECK(on_surface <= 1e-8 * offset);
  CHECK(off_surface <= 1e-8 * offset);
}

// One patch must be the interpolant of the books: s = sum alpha_j r_j^3 + a polynomial of degree 1 that solves the saddle
// point system. The reference knows neither the scaling to the unit ball nor the null space method.
template <typename F, typename Phi>
void test_one_patch_against_dense_solve(const Phi& phi, const double offset)
{
  const Ellipsoid_with_normals input(2);
  const F f(input.mesh,
            CGAL::parameters::number_of_patches(1).offset_distance(offset).vertex_normal_map(input.normals));
  CHECK(f.diagnostics().number_of_patches == 1);

  std::vector<Eigen::Vector3d> centres;
  for (const double distance : {0., offset})
    for (const Mesh::Vertex_index v : input.mesh.vertices())
    {
      const Point_3 p = input.mesh.point(v) + distance * input.normals[v];
      centres.emplace_back(p.x(), p.y(), p.z());
    }
  const Eigen::Index n = Eigen::Index(centres.size());
  CHECK(f.diagnostics().max_centres == centres.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 4, n + 4);
  Eigen::VectorXd data = Eigen::VectorXd::Zero(n + 4);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    for (Eigen::Index j = 0; j < n; ++j)
      matrix(i, j) = phi((centres[i] - centres[j]).norm());
    matrix(i, n) = matrix(n, i) = 1;
    matrix.block<1, 3>(i, n + 1) = centres[i].transpose();
    matrix.block<3, 1>(n + 1, i) = centres[i];
    data[i] = i < n / 2 ? 0. : offset;
  }
  const Eigen::VectorXd solution = matrix.fullPivLu().solve(data);
  double largest = 0;
  for (const Point_3& p : points_near_the_surface(500, 0.5))
  {
    const Eigen::Vector3d x(p.x(), p.y(), p.z());
    double value = solution[n] + solution.tail<3>().dot(x);
    for (Eigen::Index j = 0; j < n; ++j)
      value += solution[j] * phi((x - centres[j]).norm());
    largest = (std::max)(largest, std::abs(f(p) - value));
  }
  std::cout << "one patch against the dense solve: " << largest << std::endl;
  CHECK(largest <= 1e-8);
}

// As many patches as these have slabs between them nearly everywhere, where the gradient has the terms of the weights.
template <typename F>
void test_gradient(const double tolerance)
{
  const Mesh mesh = ellipsoid(3);
  for (const std::size_t number_of_patches : {26, 100})
  {
    const F f(mesh, CGAL::parameters::number_of_patches(number_of_patches));
    CHECK(f.diagnostics().number_of_patches >= number_of_patches / 2);
    const double h = 1e-5;
    double largest = 0;
    bool is_same = true;
    for (const Point_3& p : points_near_the_surface(2000, 0.05))
    {
      const auto difference = [&](const Vector_3& e) { return (f(p + h * e) - f(p - h * e)) / (2 * h); };
      const Vector_3 differences(difference(Vector_3(1, 0, 0)), difference(Vector_3(0, 1, 0)),
                                 difference(Vector_3(0, 0, 1)));
      const Vector_3 gradient = f.gradient(p);
      largest = (std::max)(largest, std::sqrt((gradient - differences).squared_length() / gradient.squared_length()));
      const auto both = f.value_and_gradient(p);
      is_same = is_same && both.first == f(p) && both.second == gradient;
    }
    std::cout << "gradient against differences: " << largest << std::endl;
    CHECK(largest <= tolerance);
    CHECK(is_same);
  }
}

// Along a line through all patches, a value or a gradient that jumps breaks the bounds that a Lipschitz continuous gradient
// sets to the steps. The neighbours of a patch differ from it by some 1e-4, a hundred times what the bounds let through.
void test_continuity()
{
  const Function f(ellipsoid(3), CGAL::parameters::number_of_patches(60));
  // largest curvature of the ellipsoid: 5, at its tips; the blending adds a little
  const double lipschitz = 4 * 5;
  const std::size_t steps = 200000;
  double largest_value = 0, largest_gradient = 0;
  Point_3 last;
  std::pair<double, Vector_3> at_last;
  for (std::size_t i = 0; i <= steps; ++i)
  {
    const double u = 2 * pi * double(i) / double(steps), v = 0.3 + 2 * u; // winds about the ellipsoid
    const Point_3 p = on_ellipsoid(Point_3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u)));
    const auto at_p = f.value_and_gradient(p);
    if (i > 0)
    {
      const Vector_3 step = p - last;
      const double length = std::sqrt(step.squared_length());
      const double trapezium = 0.5 * ((at_p.second + at_last.second) * step);
      largest_value = (std::max)(largest_value, std::abs(at_p.first - at_last.first - trapezium) / (length * length));
      largest_gradient =
          (std::max)(largest_gradient, std::sqrt((at_p.second - at_last.second).squared_length()) / length);
    }
    last = p;
    at_last = at_p;
  }
  std::cout << "continuity: " << largest_value << " " << largest_gradient << std::endl;
  CHECK(largest_value <= lipschitz / 2);
  CHECK(largest_gradient <= lipschitz);
}

// negative inside and positive outside, far away too
void test_sign()
{
  const Function f(ellipsoid(4));
  const Kernel::Sphere_3 sphere = f.bounding_sphere();
  for (const double factor : {0., 0.25, 0.5, 0.9, 0.99, 0.999, 1.001, 1.01, 1.1, 1.5, 2., 4.})
  {
    std::size_t wrong = 0;
    for (const Point_3& q : spiral_points(2000))
      wrong += (f(CGAL::ORIGIN + factor * (on_ellipsoid(q) - CGAL::ORIGIN)) < 0) == (factor < 1) ? 0 : 1;
    std::cout << "wrong signs at " << factor << ": " << wrong << std::endl;
    CHECK(wrong == 0);
  }
  double least_cosine = 1, least_length = 1, largest_length = 1;
  std::size_t outside_sphere = 0;
  for (const Point_3& q : spiral_points(2000))
  {
    const Point_3 p = on_ellipsoid(q);
    const Vector_3 gradient = f.gradient(p);
    const double length = std::sqrt(gradient.squared_length());
    least_cosine = (std::min)(least_cosine, gradient * unit_normal(p) / length);
    least_length = (std::min)(least_length, length);
    largest_length = (std::max)(largest_length, length);
    outside_sphere += sphere.has_on_bounded_side(p) ? 0 : 1;
  }
  std::cout << "gradients: " << least_cosine << " " << least_length << " " << largest_length << std::endl;
  CHECK(least_cosine > 0.999);
  CHECK(least_length > 0.9);
  CHECK(largest_length < 1.1);
  CHECK(outside_sphere == 0);
}

template <typename F>
std::vector<double> values_of(const F& f, const std::vector<Point_3>& points)
{
  std::vector<double> values;
  for (const Point_3& p : points)
  {
    const auto at_p = f.value_and_gradient(p);
    values.insert(values.end(), {at_p.first, at_p.second.x(), at_p.second.y(), at_p.second.z()});
  }
  return values;
}

void test_copies()
{
  const Mesh mesh = ellipsoid(2);
  const std::vector<Point_3> points = points_near_the_surface(50, 0.1);
  std::vector<Function> copies;
  std::vector<double> expected;
  {
    const Function f(mesh);
    expected = values_of(f, points);
    copies.assign(10, f);
    // they share the data, hence are as cheap as their size
    CHECK(&copies[3].diagnostics() == &f.diagnostics());
    static_assert(sizeof(Function) <= 64, "a copy must not hold the data itself");
  }
  // and keep them alive
  for (const Function& copy : copies)
    CHECK(values_of(copy, points) == expected);
}

int main()
{
  test_accuracy();
  test_interpolation<Function>();
  test_interpolation<Thin_plate_function>();
  for (const double offset : {0.05, 0.02})
  {
    test_one_patch_against_dense_solve<Function>([](const double r) { return r * r * r; }, offset);
    test_one_patch_against_dense_solve<Thin_plate_function>(
        [](const double r) { return r > 0 ? r * r * std::log(r) : 0.; }, offset);
  }
  test_gradient<Function>(1e-6);
  test_continuity();
  test_sign();
  test_copies();
  return check_summary();
}
