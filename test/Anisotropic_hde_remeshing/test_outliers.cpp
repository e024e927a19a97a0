// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Outliers and wrong normals among points: they are found, and nothing else is.

#include "check.h"
#include "shapes.h"

#include <CGAL/Rbf_implicit_function.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

using namespace shapes;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Rbf_implicit_function<Kernel> Function;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Parallel_function;
typedef std::vector<std::pair<Point_3, Vector_3>> Points;

constexpr std::size_t number_of_points = 3000;

Points unit_sphere()
{
  Points result;
  for (const Point_3& p : spiral_points(number_of_points))
    result.emplace_back(p, p - CGAL::ORIGIN);
  return result;
}

// a cube of edge 2, with the normals of its sides
Points cube_points(const int n)
{
  Points result;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1., 1.})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
        {
          double p[3], normal[3] = {0, 0, 0};
          p[axis] = normal[axis] = side;
          p[(axis + 1) % 3] = (2. * i + 1) / n - 1;
          p[(axis + 2) % 3] = (2. * j + 1) / n - 1;
          result.emplace_back(Point_3(p[0], p[1], p[2]), Vector_3(normal[0], normal[1], normal[2]));
        }
  return result;
}

template <typename F>
double largest_value(const F& f)
{
  double result = 0;
  for (const Point_3& p : spiral_points(2000))
    result = (std::max)(result, std::abs(f(p)));
  return result;
}

template <typename F, typename G>
bool are_equal(const F& f, const G& g)
{
  for (const Point_3& p : spiral_points(300))
    if (f.value_and_gradient(p) != g.value_and_gradient(p))
      return false;
  return true;
}

// spurious sheets change the sign inside or outside
template <typename F>
bool has_one_sheet(const F& f)
{
  for (const Point_3& p : spiral_points(20000))
    for (const double r : {0.3, 0.5, 0.7, 0.9, 0.97, 1.03, 1.1, 1.3})
      if ((f(CGAL::ORIGIN + r * (p - CGAL::ORIGIN)) < 0) != (r < 1))
        return false;
  return true;
}

void test_outliers()
{
  Points points = unit_sphere();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-2, 2);
  std::size_t number = 0;
  for (std::size_t i = 0; i < points.size(); i += 50)
  {
    const double x = uniform(random), y = uniform(random), z = uniform(random), u = uniform(random), v = uniform(random),
                 w = uniform(random);
    const Point_3 p(x, y, z);
    if (std::abs(std::sqrt(CGAL::squared_distance(p, Point_3(CGAL::ORIGIN))) - 1) < 0.05)
      continue; // as good as on the surface
    points[i] = {p, Vector_3(u, v, w)};
    ++number;
  }
  const Function plain(points), f(points, params::detect_outliers(true));
  const Parallel_function parallel(points, params::detect_outliers(true));
  std::cout << number << " outliers, found " << f.diagnostics().number_of_outliers << ", wrong normals "
            << f.diagnostics().number_of_wrong_normals << ", largest value " << largest_value(f) << std::endl;
  CHECK(f.diagnostics().number_of_outliers == number);
  CHECK(f.diagnostics().number_of_wrong_normals == 0);
  CHECK(f.diagnostics().number_of_points == points.size() - number);
  CHECK(plain.diagnostics().number_of_outliers == 0);
  CHECK(!has_one_sheet(plain));
  CHECK(has_one_sheet(f));
  CHECK(largest_value(f) < 1e-4);
  CHECK(are_equal(f, parallel));
}

void test_turned_normals()
{
  const Points exact = unit_sphere();
  Points points = exact;
  for (std::size_t i = 0; i < points.size(); i += 50)
    points[i].second = -points[i].second;
  const Function plain(points), f(points, params::detect_outliers(true)), clean(exact);
  CHECK(f.diagnostics().number_of_wrong_normals == number_of_points / 50);
  CHECK(f.diagnostics().number_of_outliers == 0);
  CHECK(!has_one_sheet(plain));
  // turned back they are as they were
  CHECK(are_equal(f, clean));

  // those that are across are dropped
  for (std::size_t i = 0; i < points.size(); i += 50)
    points[i].second =
        points[i].second.x() == 0 ? Vector_3(1, 0, 0) : CGAL::cross_product(points[i].second, Vector_3(0, 0.6, 0.8));
  const Function dropped(points, params::detect_outliers(true));
  CHECK(dropped.diagnostics().number_of_wrong_normals == number_of_points / 50);
  CHECK(dropped.diagnostics().number_of_points_without_normal == number_of_points / 50);
  CHECK(has_one_sheet(dropped));
}

// Nothing of clean points is changed: of edges and corners, of two close sheets, of a density that varies, of few points.
void test_clean_points()
{
  Points uneven, sheets;
  for (const auto& [p, normal] : unit_sphere())
    uneven.emplace_back(Point_3(p.x(), 2 * p.y(), 5 * p.z()), Vector_3(p.x(), p.y() / 2, p.z() / 5));
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      for (const double side : {-1., 1.})
        if (side > 0 || (i % 2 == 0 && j % 2 == 0)) // most neighbours of a point of the lower sheet are on the upper one
          sheets.emplace_back(Point_3(i, j, 1.5 * side), Vector_3(0, 0, side));
  Points few = unit_sphere();
  few.resize(10);
  for (const Points& points : {unit_sphere(), cube_points(20), uneven, sheets, few})
  {
    const Parallel_function f(points, params::detect_outliers(true)), plain(points);
    CHECK(f.diagnostics().number_of_outliers == 0);
    CHECK(f.diagnostics().number_of_wrong_normals == 0);
    CHECK(are_equal(f, plain));
  }
}

// Where most are contradicted, no one knows who is right.
void test_many()
{
  Points points = unit_sphere();
  for (std::size_t i = 0; i < points.size(); i += 3)
    points[i].second = -points[i].second;
  const Parallel_function f(points, params::detect_outliers(true));
  CHECK(f.diagnostics().number_of_wrong_normals == 0);
  CHECK(f.diagnostics().number_of_points == points.size());
}

int main()
{
  test_outliers();
  test_turned_normals();
  test_clean_points();
  test_many();
  return check_summary();
}
