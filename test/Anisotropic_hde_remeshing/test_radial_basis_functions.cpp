// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The kernels against their formulas, in extended precision, and the sums over centres against plain loops.

#include "check.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Local_interpolant.h>
#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Random.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;

typedef long double Real;
typedef Eigen::Matrix<double, 3, Eigen::Dynamic> Points;
typedef Eigen::Matrix<Real, 3, 1> Real_vector;
typedef Eigen::Matrix<Real, 3, 3> Real_matrix;

const double width = 1.7, support = 2.6;

Real power(const Real x, const int n) { return n == 0 ? 1 : x * power(x, n - 1); }

// (1 - t)_+^n
Real cut(const Real t, const int n) { return t < 1 ? power(1 - t, n) : 0; }

// calls test(kernel, its formula)
template <typename Test>
void for_each_kernel(const Test& test)
{
  test(CGAL::Polyharmonic_rbf(), [](const Real r) { return power(r, 3); });
  test(CGAL::Thin_plate_rbf(), [](const Real r) { return r > 0 ? r * r * std::log(r) : Real(0); });
  test(CGAL::Gaussian_rbf(width), [](const Real r) { return std::exp(-power(r / width, 2)); });
  test(CGAL::Multiquadric_rbf(width), [](const Real r) { return std::sqrt(1 + power(r / width, 2)); });
  test(CGAL::Inverse_multiquadric_rbf(width), [](const Real r) { return 1 / std::sqrt(1 + power(r / width, 2)); });
  test(CGAL::Wendland_C2_rbf(support),
       [](const Real r)
       {
         const Real t = r / support;
         return cut(t, 4) * (4 * t + 1);
       });
  test(CGAL::Wendland_C4_rbf(support),
       [](const Real r)
       {
         const Real t = r / support;
         return cut(t, 6) * (35 * t * t + 18 * t + 3);
       });
  test(CGAL::Wendland_C6_rbf(support),
       [](const Real r)
       {
         const Real t = r / support;
         return cut(t, 8) * (32 * t * t * t + 25 * t * t + 8 * t + 1);
       });
}

// what a kernel returns, from the formula, with derivatives by differences of fourth order
template <typename Phi>
CGAL::Rbf_jet<Real> values_of_formula(const Phi& phi, const Real r)
{
  CGAL::Rbf_jet<Real> result;
  const Real h = 1e-3L;
  const Real far = phi(r + 2 * h), next = phi(r + h), here = phi(r), last = phi(r - h), before = phi(r - 2 * h);
  const Real derivative = (before - 8 * last + 8 * next - far) / (12 * h);
  const Real second_derivative = (-before + 16 * last - 30 * here + 16 * next - far) / (12 * h * h);
  result.value = here;
  result.first = derivative / r;
  result.second = (second_derivative - derivative / r) / (r * r);
  return result;
}

double relative_difference(const Real a, const Real b, const Real scale)
{
  return double(std::abs(a - b) / ((std::max)(std::abs(b), scale)));
}

template <typename Kernel, typename Phi>
void test_formula(const Kernel& kernel, const Phi& phi)
{
  double value = 0, first = 0, second = 0;
  for (double r = 0.1; r < 4; r += 0.0173)
  {
    const CGAL::Rbf_jet<double> computed = kernel(r * r);
    const CGAL::Rbf_jet<Real> expected = values_of_formula(phi, r);
    value = (std::max)(value, relative_difference(computed.value, expected.value, 1));
    first = (std::max)(first, relative_difference(computed.first, expected.first, 1));
    second = (std::max)(second, relative_difference(computed.second, expected.second, 1));
  }
  std::cout << Kernel::name() << ": value " << value << ", derivatives " << first << " " << second << std::endl;
  CHECK(value <= 1e-14);
  CHECK(first <= 1e-9);
  CHECK(second <= 1e-7); // less than four derivatives at the end of the support

  const CGAL::Rbf_jet<double> at_centre = kernel(0.);
  CHECK_CLOSE(at_centre.value, phi(0), 1e-14);
  CHECK(std::isfinite(at_centre.first) && std::isfinite(at_centre.second));
  for (const double tiny : {1e-300, 1e-160, 1e-20})
  {
    const CGAL::Rbf_jet<double> near_centre = kernel(tiny * tiny);
    CHECK_CLOSE(near_centre.value, phi(0), 1e-14);
    // what a Hessian is made of
    CHECK(std::isfinite(near_centre.first) && std::isfinite(near_centre.second * tiny * tiny));
  }
  if constexpr (internal::Has_compact_support<Kernel>::value)
  {
    CHECK_CLOSE(kernel.support_radius(), support, 1e-14);
    for (const double r : {1., 1.5, 100.})
    {
      const CGAL::Rbf_jet<double> beyond = kernel(r * r * support * support);
      CHECK_CLOSE(beyond.value, 0, 1e-50);
      CHECK_CLOSE(beyond.first, 0, 1e-40);
      CHECK_CLOSE(beyond.second, 0, 1e-25);
    }
  }
}

// numbers and arrays
template <typename Array, typename Kernel>
double difference_to_array(const Kernel& kernel, const Array& squared_radii)
{
  const CGAL::Rbf_jet<Array> computed = kernel(squared_radii);
  double result = 0;
  for (Eigen::Index i = 0; i < squared_radii.size(); ++i)
  {
    const CGAL::Rbf_jet<double> expected = kernel(squared_radii[i]);
    // relative to the terms that the numbers are differences of
    result = (std::max)(result, relative_difference(computed.value[i], expected.value, 1));
    result = (std::max)(result, relative_difference(computed.first[i], expected.first, 1));
    result = (std::max)(result, relative_difference(computed.second[i], expected.second, 1));
  }
  return result;
}

template <typename Kernel>
void test_arrays(const Kernel& kernel)
{
  double largest = 0;
  for (int k = 0; k < 100; ++k)
  {
    const double low = 0.01 + 0.2 * k, high = low + 0.2; // beyond the support, too
    const Eigen::Array<double, 8, 1> eight = Eigen::Array<double, 8, 1>::LinSpaced(low, high);
    const Eigen::Array<double, 2, 1> two(low, high);
    const Eigen::Array<double, 1, 1> one(low);
    largest = (std::max)(
        {largest, difference_to_array(kernel, eight), difference_to_array(kernel, two), difference_to_array(kernel, one)});
  }
  std::cout << Kernel::name() << ": numbers and arrays " << largest << std::endl;
  CHECK(largest <= 1e-15);
}

// random centres in a cube, no two of them nearer than `least_distance`
Points random_centres(CGAL::Random& random, const Eigen::Index n, const double size, const double least_distance)
{
  Points result(3, n);
  for (Eigen::Index i = 0; i < n;)
  {
    for (Eigen::Index k = 0; k < 3; ++k)
      result(k, i) = random.get_double(-0.5 * size, 0.5 * size);
    const auto others = result.leftCols(i);
    if (i == 0 || (others.colwise() - result.col(i)).colwise().norm().minCoeff() >= least_distance)
      ++i;
  }
  return result;
}

// sign * phi(|y_i - y_j|)
template <typename Kernel>
Eigen::MatrixXd interpolation_matrix(const Kernel& kernel, const Points& centres)
{
  Eigen::MatrixXd matrix(centres.cols(), centres.cols());
  for (Eigen::Index i = 0; i < centres.cols(); ++i)
    for (Eigen::Index j = 0; j < centres.cols(); ++j)
      matrix(i, j) = Kernel::sign * kernel((centres.col(i) - centres.col(j)).squaredNorm()).value;
  return matrix;
}

// the least and the largest eigenvalue of the matrix where the polynomials of degree < order vanish
std::pair<double, double> extreme_eigenvalues(const Eigen::MatrixXd& matrix, const Points& centres, const unsigned int order)
{
  const Eigen::Index n = centres.cols(), q = order == 0 ? 0 : order == 1 ? 1 : 4;
  Eigen::MatrixXd polynomials(n, 4);
  polynomials << Eigen::VectorXd::Ones(n), centres.transpose();
  Eigen::MatrixXd projector = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index k = 0; k < q; ++k)
  {
    const Eigen::VectorXd direction = (projector.lazyProduct(polynomials.col(k))).normalized();
    projector -= direction.lazyProduct(direction.transpose());
  }
  // the polynomials themselves get a value between the others
  const Eigen::MatrixXd projected = projector.lazyProduct(matrix).eval().lazyProduct(projector),
                        complete = projected +
                                   std::abs(projected.trace()) / double(n - q) * (Eigen::MatrixXd::Identity(n, n) - projector);
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(complete, Eigen::EigenvaluesOnly).eigenvalues();
  return std::make_pair(values.minCoeff(), values.maxCoeff());
}

template <typename Kernel>
void test_definiteness(const Kernel& kernel)
{
  CGAL::Random random(11);
  for (int run = 0; run < 10; ++run)
  {
    const Points centres = random_centres(random, 40, 5, 0.5);
    const Eigen::MatrixXd matrix = interpolation_matrix(kernel, centres);
    const std::pair<double, double> values = extreme_eigenvalues(matrix, centres, Kernel::order);
    // not by rounding alone
    CHECK(values.first > 1e-13 * values.second);
    // no lower order will do
    if constexpr (Kernel::order > 0)
      CHECK(extreme_eigenvalues(matrix, centres, Kernel::order - 1).first < 0);
  }
}

template <typename Call>
std::string message_of(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return std::string();
}

template <typename Kernel>
void test_shape_parameter(const std::string& name)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan_value = std::numeric_limits<double>::quiet_NaN();
  for (const CGAL::Rbf_length_unit unit : {CGAL::Rbf_length_unit::LOCAL_SPACING, CGAL::Rbf_length_unit::COORDINATES})
  {
    CHECK(message_of([&] { Kernel(0., unit); }).find(name + " is 0") != std::string::npos);
    CHECK(message_of([&] { Kernel(-2.5, unit); }).find(name + " is -2.5") != std::string::npos);
    for (const double bad : {infinity, -infinity, nan_value})
      CHECK(message_of([&] { Kernel(bad, unit); }).find(name + " is ") != std::string::npos);
    CHECK_NO_THROW(Kernel(1e-3, unit));
    CHECK(Kernel(3.5, unit).length() == 3.5);
  }

  // a length in coordinates is the same one in spacings, where the spacing is known
  const double spacing = 0.03;
  Kernel relative(2.2), absolute(2.2 * spacing, CGAL::Rbf_length_unit::COORDINATES);
  relative.set_unit(spacing);
  absolute.set_unit(spacing);
  double largest = 0;
  for (double r = 0; r < 4; r += 0.1)
  {
    const CGAL::Rbf_jet<double> a = relative(r * r), b = absolute(r * r);
    largest = (std::max)({largest, relative_difference(a.value, b.value, 1), relative_difference(a.first, b.first, 1),
                          relative_difference(a.second, b.second, 1)});
  }
  CHECK(largest <= 1e-13);
  // but where it is another one, they differ
  absolute.set_unit(2 * spacing);
  CHECK(std::abs(relative(1.).value - absolute(1.).value) > 0.01);
}

// a sum with the sum of the absolute values of its terms, to which its error is relative
struct Reference_sum
{
  Real value = 0, absolute_value = 0;

  void add(const Real term)
  {
    value += term;
    absolute_value += std::abs(term);
  }
};

// value, gradient and Hessian of a sum over centres, in this order; those of the polynomial are added
struct Reference_jet
{
  Reference_sum sums[13];

  template <typename Kernel>
  void add_kernels(const Kernel& kernel, const Points& centres, const Eigen::VectorXd& weights, const Real_vector& y)
  {
    for (Eigen::Index j = 0; j < centres.cols(); ++j)
    {
      const Real_vector difference = y - centres.col(j).cast<Real>();
      add(weights[j], kernel(Real(difference.squaredNorm())), difference);
    }
  }

  void add(const Real weight, const CGAL::Rbf_jet<Real>& values, const Real_vector& difference)
  {
    const Real_matrix hessian = values.first * Real_matrix::Identity() + (values.second * difference) * difference.transpose();
    add(weight * values.value, weight * values.first * difference, weight * hessian);
  }

  void add(const Real value, const Real_vector& gradient, const Real_matrix& hessian)
  {
    sums[0].add(value);
    for (int i = 0; i < 3; ++i)
      sums[1 + i].add(gradient[i]);
    for (int i = 0; i < 9; ++i)
      sums[4 + i].add(hessian(i / 3, i % 3));
  }

  // the largest error of a jet, relative to the largest of the terms of its kind
  template <int order>
  double error(const internal::Jet<order>& jet, const Real value_unit = 1, const Real hessian_unit = 1) const
  {
    Real result = std::abs(jet.value - value_unit * sums[0].value) / (value_unit * sums[0].absolute_value);
    if constexpr (order >= 1)
      for (int i = 0; i < 3; ++i)
        result = (std::max)(result, std::abs(jet.gradient[i] - sums[1 + i].value) / largest(1, 4));
    if constexpr (order >= 2)
      for (int i = 0; i < 9; ++i)
        result = (std::max)(result, std::abs(jet.hessian(i / 3, i % 3) - hessian_unit * sums[4 + i].value) /
                                        (hessian_unit * largest(4, 13)));
    return double(result);
  }

private:
  Real largest(const int begin, const int end) const
  {
    Real result = 0;
    for (int i = begin; i < end; ++i)
      result = (std::max)(result, sums[i].absolute_value);
    return result;
  }
};

// no terms: the errors are of numbers that must vanish
template <int order>
bool is_zero(const internal::Jet<order>& jet)
{
  bool result = jet.value == 0;
  if constexpr (order >= 1)
    result = result && jet.gradient.isZero(0);
  if constexpr (order >= 2)
    result = result && jet.hessian.isZero(0);
  return result;
}

template <int order, typename Kernel>
double error_of_sum(const internal::Kernel_sum<Kernel>& sum, const Reference_jet& expected, const internal::Vector& y,
                    const double expected_squared_distance)
{
  double squared_distance = -1;
  const internal::Jet<order> jet = sum.template evaluate<order>(y, squared_distance);
  if (expected.sums[0].absolute_value == 0) // all centres beyond the support
    return is_zero(jet) ? 0. : 1.;
  return (std::max)(expected.error(jet), std::abs(squared_distance - expected_squared_distance));
}

template <typename Kernel>
void test_kernel_sum(const Kernel& kernel)
{
  CGAL::Random random(3);
  std::vector<Eigen::Index> sizes(40);
  std::iota(sizes.begin(), sizes.end(), Eigen::Index(1));
  sizes.push_back(500);
  double largest = 0;
  for (const Eigen::Index n : sizes)
  {
    // a cube that is several supports wide
    const Points centres = random_centres(random, n, 1.1 * std::cbrt(double(n)), 0.2);
    Eigen::VectorXd weights(n);
    for (double& weight : weights)
      weight = random.get_double(-1, 1);
    const internal::Kernel_sum<Kernel> sum(centres, weights, kernel);
    for (int k = 0; k < 20; ++k)
    {
      const internal::Vector y = 1.5 * random_centres(random, 1, 1.1 * std::cbrt(double(n)), 0).col(0);
      Reference_jet expected;
      expected.add_kernels(kernel, centres, weights, y.cast<Real>());
      const double squared_distance = (centres.colwise() - y).colwise().squaredNorm().minCoeff();
      largest = (std::max)({largest, error_of_sum<0>(sum, expected, y, squared_distance),
                            error_of_sum<1>(sum, expected, y, squared_distance),
                            error_of_sum<2>(sum, expected, y, squared_distance)});
    }
    // at a centre
    double squared_distance = -1;
    const internal::Jet<2> jet = sum.template evaluate<2>(centres.col(n / 2), squared_distance);
    CHECK(squared_distance == 0);
    CHECK(std::isfinite(jet.value) && jet.gradient.allFinite() && jet.hessian.allFinite());
  }
  std::cout << Kernel::name() << ": sums against plain loops " << largest << std::endl;
  CHECK(largest <= 1e-12);
}

// the frame and the polynomial
template <typename Kernel>
void test_local_interpolant(const Kernel& kernel)
{
  CGAL::Random random(5);
  const internal::Patch_frame frame{internal::Vector(0.3, -0.2, 0.4), 0.037};
  internal::Quadratic_polynomial polynomial;
  polynomial.constant = 0.7;
  polynomial.linear = internal::Vector(0.1, -0.3, 0.9);
  polynomial.quadratic << 0.3, 0.1, -0.2, 0.1, -0.4, 0.05, -0.2, 0.05, 0.25;
  double largest = 0;
  for (const Eigen::Index n : {1, 7, 8, 9, 100})
  {
    const Points centres = random_centres(random, n, 5, 0.2);
    const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(n, -1, 1.3);
    const internal::Local_interpolant<Kernel> interpolant(frame, centres, weights, polynomial, kernel);
    for (int k = 0; k < 20; ++k)
    {
      const internal::Vector p = frame.centre + frame.unit * random_centres(random, 1, 5, 0).col(0);
      const Real_vector y = (p.cast<Real>() - frame.centre.cast<Real>()) / Real(frame.unit);
      const Real_matrix quadratic = polynomial.quadratic.cast<Real>();
      Reference_jet expected;
      expected.add_kernels(kernel, centres, weights, y);
      expected.add(polynomial.constant + polynomial.linear.cast<Real>().dot(y) + y.dot(quadratic * y),
                   polynomial.linear.cast<Real>() + 2 * quadratic * y, 2 * quadratic);
      double unused;
      largest = (std::max)({largest, expected.error(interpolant.template evaluate<0>(p, unused), frame.unit),
                            expected.error(interpolant.template evaluate<1>(p, unused), frame.unit),
                            expected.error(interpolant.template evaluate<2>(p, unused), frame.unit, 1 / Real(frame.unit))});
    }
  }
  std::cout << Kernel::name() << ": interpolant " << largest << std::endl;
  CHECK(largest <= 1e-12);
}

// at most the distance to the nearest centre, at least what so many centres make of it, its derivatives those of its values
void test_smooth_distance()
{
  CGAL::Random random(17);
  const internal::Patch_frame frame{internal::Vector(0.1, 0.2, -0.1), 0.25};
  double first = 0, second = 0;
  for (const Eigen::Index n : {1, 5, 64, 300})
  {
    const Points centres = random_centres(random, n, 4, 0.1);
    const internal::Local_interpolant<CGAL::Polyharmonic_rbf> interpolant(
        frame, centres, Eigen::VectorXd::Zero(n), internal::Quadratic_polynomial(), CGAL::Polyharmonic_rbf());
    const auto jet = [&](const internal::Vector& p)
    {
      const double squared_distance = (centres.colwise() - frame(p)).colwise().squaredNorm().minCoeff();
      return interpolant.smooth_distance<2>(p, squared_distance);
    };
    for (int k = 0; k < 50; ++k)
    {
      const internal::Vector p = frame.centre + frame.unit * random_centres(random, 1, 12, 0).col(0);
      const double distance = (centres.colwise() - frame(p)).colwise().norm().minCoeff();
      const internal::Jet<2> at_p = jet(p);
      CHECK(at_p.value <= distance * (1 + 1e-14));
      CHECK(at_p.value >= 0.99 * distance * std::pow(double(8 * ((n + 7) / 8)), -1. / 16));
      const double h = 1e-5 * distance * frame.unit;
      for (int i = 0; i < 3; ++i)
      {
        const internal::Vector step = h * internal::Vector::Unit(i);
        const internal::Jet<2> next = jet(p + step), last = jet(p - step);
        first = (std::max)(first, frame.unit * std::abs((next.value - last.value) / (2 * h) - at_p.gradient[i]));
        second = (std::max)(second, frame.unit * frame.unit * distance *
                                        ((next.gradient - last.gradient) / (2 * h) - at_p.hessian.col(i)).norm());
      }
    }
  }
  std::cout << "smooth distance: derivatives " << first << " " << second << std::endl;
  CHECK(first <= 1e-7);
  CHECK(second <= 1e-6);
}

int main()
{
  for_each_kernel(
      [](const auto& kernel, const auto& phi)
      {
        test_formula(kernel, phi);
        test_arrays(kernel);
        test_definiteness(kernel);
        test_kernel_sum(kernel);
        test_local_interpolant(kernel);
      });
  test_shape_parameter<CGAL::Gaussian_rbf>("width of the radial function");
  test_shape_parameter<CGAL::Multiquadric_rbf>("width of the radial function");
  test_shape_parameter<CGAL::Inverse_multiquadric_rbf>("width of the radial function");
  test_shape_parameter<CGAL::Wendland_C2_rbf>("support_radius of the radial function");
  test_shape_parameter<CGAL::Wendland_C4_rbf>("support_radius of the radial function");
  test_shape_parameter<CGAL::Wendland_C6_rbf>("support_radius of the radial function");
  test_smooth_distance();
  return check_summary();
}
