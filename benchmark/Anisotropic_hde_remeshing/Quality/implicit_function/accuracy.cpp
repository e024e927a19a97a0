// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// A file of its own: compilers inline less in a file of many kernels, and the other sections measure one kernel, as in the
// programs of users.

#include "accuracy.h"

#include "Table.h"
#include "common.h"

#include <CGAL/Radial_basis_functions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

namespace {

constexpr std::size_t number_of_exact_points = 50000;

// points of the ellipsoid itself, spread evenly over its area
std::vector<Point_3> points_on_ellipsoid(const std::size_t number_of_points)
{
  const Ellipsoid_function exact;
  std::vector<Point_3> points = points_on(ellipsoid(6), number_of_points);
  for (Point_3& p : points)
    p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / (1 + exact(p));
  return points;
}

// The distance of the zero set of `function` to the ellipsoid, at the points of the zero set next to those given, to which
// Newton's method goes. To first order, which is exact to two digits: it is a hundredth of the radii of curvature at most.
template <typename Function>
Hde::internal::Rms_and_max distance_to_ellipsoid(const Function& function, const std::vector<Point_3>& points)
{
  const Ellipsoid_function exact;
  const auto distance = [&](const std::size_t i)
  {
    Point_3 p = points[i];
    for (int step = 0; step < 4; ++step)
    {
      const auto at_p = function.value_and_gradient(p);
      p = p - at_p.first / at_p.second.squared_length() * at_p.second;
    }
    return std::abs(exact(p)) / std::sqrt(exact.gradient(p).squared_length());
  };
  return Hde::internal::rms_and_max<Tag>(points.size(), distance);
}

struct Pair_of_errors
{
  double first = 0, second = 0;
};

// the largest differences to the data, at the vertices and at the off-surface points of the default offset, none of which
// is shortened on the ellipsoid
template <typename Function>
Pair_of_errors residuals(const Function& function, const Mesh& mesh)
{
  static constexpr double relative_offset = 0.05;
  Hde::internal::Interruption never;
  const Hde::internal::Surface_sample sample =
      Hde::internal::sample_mesh(mesh, get(CGAL::vertex_point, mesh), CGAL::internal_np::Param_not_found(), never);
  // the sample is normalised
  const double unit = 1 / sample.normalization.scale;
  const auto value = [&](const Hde::internal::Vector& normalized)
  {
    const Hde::internal::Vector p = sample.normalization.centre + unit * normalized;
    return function(Point_3(p.x(), p.y(), p.z())) * sample.normalization.scale;
  };
  Pair_of_errors result;
  for (std::size_t i = 0; i < sample.size(); ++i)
  {
    const double offset = relative_offset * sample.spacings[i];
    result.first = (std::max)(result.first, std::abs(value(sample.points[i])));
    result.second = (std::max)(result.second, std::abs(value(sample.points[i] + offset * sample.normals[i]) - offset));
  }
  result.first *= unit;
  result.second *= unit;
  return result;
}

// the central difference of fourth order of a function along each of the axes
template <typename Value, typename Function>
std::array<Value, 3> central_differences(const Function& function, const Point_3& p, const double step)
{
  std::array<Value, 3> result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector_3 axis(k == 0 ? step : 0, k == 1 ? step : 0, k == 2 ? step : 0);
    const Value near = function(p + axis) - function(p - axis), far = function(p + 2 * axis) - function(p - 2 * axis);
    result[k] = (8 * near - far) / (12 * step);
  }
  return result;
}

// The largest differences of the gradient and of the Hessian to central differences, relative to their lengths. Of several
// steps the best one of each point counts: a large step errs by the higher derivatives, a small one by rounding, and a
// derivative that is wrong agrees with none.
template <typename Function>
Pair_of_errors derivative_errors(const Function& function, const std::vector<Point_3>& points)
{
  const auto gradient = [&](const Point_3& p) -> Eigen::Vector3d
  {
    const Vector_3 g = function.gradient(p);
    return {g.x(), g.y(), g.z()};
  };
  Pair_of_errors result;
  for (const Point_3& p : points)
  {
    const Eigen::Vector3d exact_gradient = gradient(p);
    const Eigen::Matrix3d exact_hessian = function.hessian(p);
    Pair_of_errors best{1e300, 1e300};
    for (const double step : {1e-2, 1e-3, 1e-4, 1e-5})
    {
      const std::array<double, 3> first = central_differences<double>(function, p, step);
      const std::array<Eigen::Vector3d, 3> second = central_differences<Eigen::Vector3d>(gradient, p, step);
      Eigen::Matrix3d hessian;
      hessian << second[0], second[1], second[2];
      best.first = (std::min)(best.first, (Eigen::Vector3d(first.data()) - exact_gradient).norm() / exact_gradient.norm());
      best.second = (std::min)(best.second, (hessian - exact_hessian).norm() / exact_hessian.norm());
    }
    result.first = (std::max)(result.first, best.first);
    result.second = (std::max)(result.second, best.second);
  }
  return result;
}

// the points, in turn moved in and out by a hundredth
std::vector<Point_3> points_near(const std::vector<Point_3>& points)
{
  std::vector<Point_3> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back(CGAL::ORIGIN + (i % 2 == 0 ? 0.99 : 1.01) * (points[i] - CGAL::ORIGIN));
  return result;
}

// --- (a) ---

class Kernel_section
{
public:
  Kernel_section()
    : m_mesh(ellipsoid(4)),
      m_points(points_on_ellipsoid(number_of_exact_points)),
      m_points_near(points_near(points_on_ellipsoid(500))),
      m_diagonal(bounding_box_diagonal(m_mesh)),
      m_table("(a) kernels: ellipsoid 1:2:5, " + text(m_mesh.number_of_faces()) +
              " faces; distances over the diagonal D, derivatives relative to central differences")
  {
  }

  void run()
  {
    m_table.add("kernel", "shape", "rms/D", "max/D", "on/D", "off/D", "gradient", "Hessian", "ridge", "LU", "fallback",
                "repaired", "build s", "us");
    m_table.add("asked", "", "", "", "1e-10", "1e-10", "1e-06", "1e-06", "0", "0", "0", "", "", "");
    add("r^3", "", CGAL::Polyharmonic_rbf());
    add("thin plate", "", CGAL::Thin_plate_rbf());
    add_with_length("Gaussian", CGAL::Gaussian_rbf());
    add_with_length("multiquadric", CGAL::Multiquadric_rbf());
    add_with_length("inverse multiquadric", CGAL::Inverse_multiquadric_rbf());
    add_with_length("Wendland C2", CGAL::Wendland_C2_rbf());
    add_with_length("Wendland C4", CGAL::Wendland_C4_rbf());
    add_with_length("Wendland C6", CGAL::Wendland_C6_rbf());
    const CGAL::Wendland_C2_rbf small_support(4);
    add("Wendland C2, K=1, sparse", text(small_support.length()), small_support,
        params::number_of_patches(1).radial_function(small_support));
    m_table.print();
  }

private:
  template <typename RadialFunction>
  void add_with_length(const std::string& name, const RadialFunction& radial_function)
  {
    add(name, text(radial_function.length()), radial_function);
  }

  template <typename RadialFunction, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  void add(const std::string& name, const std::string& shape, const RadialFunction&,
           const NamedParameters& np = CGAL::parameters::default_values())
  {
    CGAL::Real_timer timer;
    timer.start();
    const CGAL::Rbf_implicit_function<Kernel, RadialFunction, CGAL::Parallel_if_available_tag> function(m_mesh, np);
    const double seconds = timer.time();
    const Hde::internal::Rms_and_max distance = distance_to_ellipsoid(function, m_points);
    const Pair_of_errors residual = residuals(function, m_mesh), derivative = derivative_errors(function, m_points_near);
    const Hde::Rbf_diagnostics& diagnostics = function.diagnostics();
    m_table.add(name, shape, distance.rms / m_diagonal, distance.max / m_diagonal, residual.first / m_diagonal,
                residual.second / m_diagonal, derivative.first, derivative.second, diagnostics.patches_with_ridge,
                diagnostics.patches_with_lu, diagnostics.patches_on_fallback, diagnostics.patches_repaired, seconds,
                microseconds_of_evaluation(function, m_points));
  }

  Mesh m_mesh;
  std::vector<Point_3> m_points, m_points_near;
  double m_diagonal;
  Table m_table;
};

} // namespace

void run_kernel_section() { Kernel_section().run(); }

// --- (b) ---

void run_convergence_section()
{
  Table table("(b) convergence of r^3 on the ellipsoid 1:2:5");
  table.add("faces", "rms/D", "asked", "order", "asked");
  const std::vector<Point_3> points = points_on_ellipsoid(number_of_exact_points);
  const std::array<std::string, 3> asked{"4.5e-05", "3.5e-06", "5e-07"};
  double last = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const Mesh mesh = ellipsoid(3 + i);
    const double rms = distance_to_ellipsoid(Rbf_function(mesh), points).rms / bounding_box_diagonal(mesh);
    table.add(mesh.number_of_faces(), rms, asked[i], i == 0 ? "" : text(std::log2(last / rms)), i == 0 ? "" : "3");
    last = rms;
  }
  table.print();
}
