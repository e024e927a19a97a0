// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How long a call takes.

// The distance to surfaces that are known exactly, and the deviation of normals from theirs.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_EXACT_SURFACES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_EXACT_SURFACES_H

#include "shapes.h"

#include <array>
#include <cmath>
#include <utility>

// The signed distance to the ellipsoid, exactly: the closest point of p is (a^2 x / (a^2 + t), ...) for the root t of
// (a x / (a^2 + t))^2 + ... = 1, to which Newton's method comes down monotonically from a t where the left side is larger.
struct Ellipsoid_distance
{
  typedef shapes::Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  shapes::Ellipsoid_function ellipsoid;

  std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
  {
    const std::array<double, 3> axes{ellipsoid.a, ellipsoid.b, ellipsoid.c};
    double t = -1e300;
    for (int i = 0; i < 3; ++i)
      t = (std::max)(t, axes[i] * (std::abs(p[i]) - axes[i]));
    for (int step = 0; step < 100; ++step)
    {
      double value = -1, slope = 0;
      for (int i = 0; i < 3; ++i)
      {
        const double s = axes[i] * axes[i] + t, quotient = axes[i] * p[i] / s;
        value += quotient * quotient;
        slope -= 2 * quotient * quotient / s;
      }
      const double last = t;
      t -= value / slope;
      if (!(std::abs(t - last) > 1e-15))
        break;
    }
    std::array<double, 3> q;
    for (int i = 0; i < 3; ++i)
      q[i] = axes[i] * axes[i] * p[i] / (axes[i] * axes[i] + t);
    const Point_3 closest(q[0], q[1], q[2]);
    const Vector_3 gradient = ellipsoid.gradient(closest);
    const double distance = std::sqrt(CGAL::squared_distance(p, closest));
    return {t < 0 ? -distance : distance, gradient / std::sqrt(gradient.squared_length())};
  }
  FT operator()(const Point_3& p) const { return value_and_gradient(p).first; }
  Vector_3 gradient(const Point_3& p) const { return value_and_gradient(p).second; }
};

// root mean square, over the area, of the angle between the faces and the exact normals at points of them, in degrees
template <typename Distance>
double normal_deviation(const shapes::Mesh& mesh, const Distance& exact)
{
  static constexpr int n = 16; // cut into n * n small faces, upright and inverted, with a point in each centre
  double sum = 0, area = 0;
  for (const shapes::Mesh::Face_index f : mesh.faces())
  {
    const shapes::Mesh::Halfedge_index h = mesh.halfedge(f);
    const shapes::Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                          &r = mesh.point(mesh.target(mesh.next(h)));
    const shapes::Vector_3 product = CGAL::cross_product(q - p, r - p);
    const double weight = std::sqrt(product.squared_length());
    const auto add = [&](const double u, const double v)
    {
      const shapes::Vector_3 normal = exact.gradient(p + u / n * (q - p) + v / n * (r - p));
      const double angle = std::atan2(std::sqrt(CGAL::cross_product(normal, product).squared_length()), normal * product);
      sum += weight * angle * angle;
      area += weight;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
      {
        add(i + 1. / 3, j + 1. / 3);
        if (i + j < n - 1)
          add(i + 2. / 3, j + 2. / 3);
      }
  }
  return std::sqrt(sum / area) * 180 / shapes::pi;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_EXACT_SURFACES_H
