// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Triangle soups that no surface reconstruction would make, but users have.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_AWKWARD_SHAPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_AWKWARD_SHAPES_H

#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>

namespace awkward_shapes {

using shapes::pi;
using shapes::Point_3;
using shapes::Soup;
using shapes::Vector_3;

inline void append(Soup& soup, const Soup& other, const Vector_3& shift = Vector_3(0, 0, 0), const double scale = 1)
{
  const std::size_t n = soup.points.size();
  for (const Point_3& p : other.points)
    soup.points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN) + shift);
  for (const auto& t : other.triangles)
    soup.triangles.push_back({n + t[0], n + t[1], n + t[2]});
}

// a strip of n quads that closes with `half_turns` half turns: one for the strip of Moebius, which no orientation suits
inline Soup twisted_strip(const std::size_t n, const int half_turns)
{
  Soup soup;
  for (std::size_t i = 0; i < n; ++i)
    for (const double s : {-0.3, 0.3})
    {
      const double u = 2 * pi * double(i) / double(n), turn = half_turns * u / 2, r = 1 + s * std::cos(turn);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), s * std::sin(turn));
    }
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool is_last = i + 1 == n, is_swapped = is_last && half_turns % 2 != 0;
    const std::size_t a = 2 * i, b = 2 * i + 1, next = is_last ? 0 : 2 * i + 2;
    const std::size_t c = next + (is_swapped ? 1 : 0), d = next + (is_swapped ? 0 : 1);
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({b, c, d});
  }
  return soup;
}

// n triangles about a vertex, of which the last and the first do not meet
inline Soup fan(const std::size_t n)
{
  Soup soup;
  soup.points.emplace_back(0, 0, 0.1);
  for (std::size_t i = 0; i <= n; ++i)
    soup.points.emplace_back(std::cos(6 * double(i) / double(n)), std::sin(6 * double(i) / double(n)), 0);
  for (std::size_t i = 0; i < n; ++i)
    soup.triangles.push_back({0, i + 1, i + 2});
  return soup;
}

// two closed cones of n sides, tip to tip
inline Soup two_cones(const std::size_t n)
{
  Soup soup;
  soup.points.emplace_back(0, 0, 0);
  for (const double z : {1., -1.})
  {
    const std::size_t base = soup.points.size();
    for (std::size_t i = 0; i < n; ++i)
      soup.points.emplace_back(std::cos(2 * pi * double(i) / double(n)), std::sin(2 * pi * double(i) / double(n)), z);
    soup.points.emplace_back(0, 0, z);
    for (std::size_t i = 0; i < n; ++i)
    {
      std::size_t a = base + i, b = base + (i + 1) % n;
      if (z < 0)
        std::swap(a, b);
      soup.triangles.push_back({0, b, a});
      soup.triangles.push_back({base + n, a, b});
    }
  }
  return soup;
}

// a box of n x n quads on both sides, of this thickness; 0 makes both sides lie in each other
inline Soup plate(const std::size_t n, const double thickness)
{
  Soup soup;
  const auto index = [n](const std::size_t side, const std::size_t i, const std::size_t j)
  { return side * (n + 1) * (n + 1) + i * (n + 1) + j; };
  for (const double z : {0., thickness})
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; j <= n; ++j)
        soup.points.emplace_back(double(i) / double(n), double(j) / double(n), z);
  const auto add_quad = [&](const std::size_t a, const std::size_t b, const std::size_t c, const std::size_t d)
  {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      add_quad(index(0, i, j), index(0, i, j + 1), index(0, i + 1, j + 1), index(0, i + 1, j));
      add_quad(index(1, i, j), index(1, i + 1, j), index(1, i + 1, j + 1), index(1, i, j + 1));
    }
  for (std::size_t i = 0; i < n; ++i)
  {
    add_quad(index(0, i, 0), index(0, i + 1, 0), index(1, i + 1, 0), index(1, i, 0));
    add_quad(index(0, i + 1, n), index(0, i, n), index(1, i, n), index(1, i + 1, n));
    add_quad(index(0, 0, i + 1), index(0, 0, i), index(1, 0, i), index(1, 0, i + 1));
    add_quad(index(0, n, i), index(0, n, i + 1), index(1, n, i + 1), index(1, n, i));
  }
  return soup;
}

inline Soup random_triangles(const std::size_t n, const unsigned int seed)
{
  Soup soup;
  std::mt19937 random(seed);
  const auto coordinate = [&random] { return double(random()) / double(std::mt19937::max()); };
  for (std::size_t i = 0; i < 3 * n; ++i)
  {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    soup.points.emplace_back(x, y, z);
  }
  for (std::size_t i = 0; i < n; ++i)
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return soup;
}

// a closed cylinder of n sides whose faces are `length` times as long as wide
inline Soup needles(const std::size_t n, const double length)
{
  Soup soup;
  const double height = length * 2 * pi / double(n);
  for (const double z : {0., height})
  {
    for (std::size_t i = 0; i < n; ++i)
      soup.points.emplace_back(std::cos(2 * pi * double(i) / double(n)), std::sin(2 * pi * double(i) / double(n)), z);
    soup.points.emplace_back(0, 0, z);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = i, b = (i + 1) % n, c = n + 1 + i, d = n + 1 + b;
    soup.triangles.push_back({a, b, d});
    soup.triangles.push_back({a, d, c});
    soup.triangles.push_back({n, b, a});
    soup.triangles.push_back({2 * n + 1, c, d});
  }
  return soup;
}

inline Soup spheres(const double gap)
{
  Soup soup = shapes::icosphere_soup(3);
  append(soup, shapes::icosphere_soup(3), Vector_3(2 + gap, 0, 0));
  return soup;
}

// One sphere in another, turned: where the sheets are near, the points are not.
inline Soup turned_shell(const unsigned int level, const double gap)
{
  Soup soup = shapes::icosphere_soup(level), inner = soup;
  for (auto& t : inner.triangles)
    std::swap(t[0], t[1]);
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (Point_3& p : inner.points)
  {
    const Point_3 q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    p = Point_3(q.x(), c * q.y() - s * q.z(), s * q.y() + c * q.z());
  }
  append(soup, inner, Vector_3(0, 0, 0), 1 - gap);
  return soup;
}

// one sphere in another, nearly as large
inline Soup shell(const double gap)
{
  Soup soup = shapes::icosphere_soup(3), inner = soup;
  for (auto& t : inner.triangles)
    std::swap(t[0], t[1]);
  append(soup, inner, Vector_3(0, 0, 0), 1 - gap);
  return soup;
}

inline Soup scaled_sphere(const double scale)
{
  Soup soup;
  append(soup, shapes::icosphere_soup(3), Vector_3(0, 0, 0), scale);
  return soup;
}

inline Soup sphere_with_point(const Point_3& p, const bool is_isolated)
{
  Soup soup = shapes::icosphere_soup(3);
  if (is_isolated)
    soup.points.push_back(p);
  else
    soup.points.front() = p;
  return soup;
}

// a sphere with needles of next to no area that are far longer than all else
inline Soup sphere_with_long_needles(const double length)
{
  Soup soup = shapes::icosphere_soup(2);
  const std::size_t tip = soup.points.size();
  soup.points.emplace_back(length, 0, 0);
  // a face is replaced by three, two of which go to the tip on one line
  const std::array<std::size_t, 3> t = soup.triangles.back();
  soup.triangles.pop_back();
  soup.points.push_back(CGAL::midpoint(soup.points[tip], soup.points[t[0]]));
  soup.triangles.push_back({t[0], t[1], tip + 1});
  soup.triangles.push_back({t[1], t[2], tip + 1});
  soup.triangles.push_back({t[2], tip, tip + 1});
  soup.triangles.push_back({t[2], t[0], tip});
  soup.triangles.push_back({tip, t[0], tip + 1});
  return soup;
}

inline Soup far_from_origin()
{
  Soup soup;
  append(soup, shapes::icosphere_soup(3), Vector_3(1e7, -1e7, 1e7));
  return soup;
}

inline Soup sphere_without_thickness()
{
  Soup soup = shapes::icosphere_soup(3);
  for (Point_3& p : soup.points)
    p = Point_3(p.x(), p.y(), 0);
  return soup;
}

inline Soup triangle() { return Soup{{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)}, {{0, 1, 2}}}; }

// by name
inline std::map<std::string, std::function<Soup()>> all()
{
  const double nan_value = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  return {{"strip-of-moebius", [] { return twisted_strip(60, 1); }},
          {"strip-of-two-half-turns", [] { return twisted_strip(60, 2); }},
          {"fan-of-1000", [] { return fan(1000); }},
          {"two-cones", [] { return two_cones(24); }},
          {"plate", [] { return plate(12, 1e-3); }},
          {"plate-without-thickness", [] { return plate(12, 0); }},
          {"random-triangles", [] { return random_triangles(200, 7); }},
          {"needles-of-1e3", [] { return needles(40, 1e3); }},
          {"needles-of-1e8", [] { return needles(40, 1e8); }},
          {"spheres-1e-7-apart", [] { return spheres(1e-7); }},
          {"spheres-that-touch", [] { return spheres(0); }},
          {"spheres-that-cross", [] { return spheres(-0.3); }},
          {"shell-of-1e-7", [] { return shell(1e-7); }},
          {"shell-of-1e-2", [] { return shell(1e-2); }},
          {"sphere-of-1e-300", [] { return scaled_sphere(1e-300); }},
          {"sphere-of-1e-150", [] { return scaled_sphere(1e-150); }},
          {"sphere-of-1e150", [] { return scaled_sphere(1e150); }},
          {"sphere-of-1e300", [] { return scaled_sphere(1e300); }},
          {"sphere-far-away", far_from_origin},
          {"sphere-without-thickness", sphere_without_thickness},
          {"sphere-with-isolated-vertex", [] { return sphere_with_point(Point_3(9, 9, 9), true); }},
          {"sphere-with-spike", [] { return sphere_with_point(Point_3(1000, 0, 0), false); }},
          {"sphere-with-long-needles", [] { return sphere_with_long_needles(1e9); }},
          {"sphere-with-nan", [=] { return sphere_with_point(Point_3(nan_value, 0, 0), false); }},
          {"sphere-with-infinity", [=] { return sphere_with_point(Point_3(0, -infinity, 0), false); }},
          {"triangle", triangle},
          {"no-faces", [] {
             return Soup{{Point_3(0, 0, 0)}, {}};
           }}};
}

} // namespace awkward_shapes

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_AWKWARD_SHAPES_H
