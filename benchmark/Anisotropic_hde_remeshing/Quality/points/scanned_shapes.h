// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Shapes with points on them, and what scanners make of those.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SCANNED_SHAPES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SCANNED_SHAPES_H

#include "exact_surfaces.h"
#include "shapes.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace shapes;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef std::pair<Point_3, Vector_3> Oriented_point;
typedef std::vector<Oriented_point> Points;

// random points of a mesh, evenly over its area, with the normals of its vertices interpolated
inline Points random_points(const Mesh& mesh, const std::size_t n, std::mt19937& random)
{
  Mesh copy = mesh;
  const auto normals = copy.add_property_map<Mesh::Vertex_index, Vector_3>("v:n", Vector_3(0, 0, 0)).first;
  PMP::compute_vertex_normals(copy, normals);
  std::vector<double> areas; // of all faces before and this one
  for (const Mesh::Face_index f : copy.faces())
    areas.push_back(PMP::face_area(f, copy) + (areas.empty() ? 0. : areas.back()));
  std::uniform_real_distribution<double> uniform(0, 1);
  Points result;
  while (result.size() < n)
  {
    const auto at = std::upper_bound(areas.begin(), areas.end() - 1, uniform(random) * areas.back());
    const Mesh::Halfedge_index h = copy.halfedge(Mesh::Face_index(Mesh::size_type(at - areas.begin())));
    const Mesh::Vertex_index a = copy.source(h), b = copy.target(h), c = copy.target(copy.next(h));
    double u = uniform(random), v = uniform(random);
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    const Point_3& p = copy.point(a);
    result.emplace_back(p + u * (copy.point(b) - p) + v * (copy.point(c) - p),
                        (1 - u - v) * normals[a] + u * normals[b] + v * normals[c]);
  }
  return result;
}

struct Shape
{
  std::string name;
  double diagonal, spacing;
  Points clean, probes; // the latter evenly over the surface, with its normals
  std::function<double(const Point_3&)> distance;
};

inline Shape ellipsoid_shape(const std::size_t n)
{
  Shape result;
  result.name = "ellipsoid";
  const Mesh mesh = ellipsoid(6);
  const Ellipsoid_function f;
  Ellipsoid_distance exact;
  exact.ellipsoid = f;
  std::mt19937 random(1);
  const auto on_surface = [&](Points points)
  {
    for (auto& [p, normal] : points)
    {
      const auto at_p = exact.value_and_gradient(p);
      p = p - at_p.first * at_p.second;
      normal = at_p.second;
    }
    return points;
  };
  result.clean = on_surface(random_points(mesh, n, random));
  result.probes = on_surface(random_points(mesh, 20000, random));
  result.diagonal = 2 * std::sqrt(f.a * f.a + f.b * f.b + f.c * f.c);
  result.spacing = std::sqrt(PMP::area(mesh) / double(n));
  result.distance = [exact](const Point_3& p) { return exact(p); };
  return result;
}

// the mesh stays
inline std::function<double(const Point_3&)> distance_to(const Mesh& mesh)
{
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
#endif
  const auto tree = std::make_shared<Tree>(mesh.faces().begin(), mesh.faces().end(), mesh);
  tree->accelerate_distance_queries();
  return [tree](const Point_3& p) { return std::sqrt(tree->squared_distance(p)); };
}

inline Shape mesh_shape(const std::string& file, const Mesh& mesh, const std::size_t n)
{
  Shape result;
  result.name = file.substr(file.rfind('/') + 1);
  std::mt19937 random(1);
  result.clean = random_points(mesh, n, random);
  result.probes = random_points(mesh, 20000, random);
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  result.diagonal = std::sqrt(
      CGAL::squared_distance(Point_3(box.xmin(), box.ymin(), box.zmin()), Point_3(box.xmax(), box.ymax(), box.zmax())));
  result.spacing = std::sqrt(PMP::area(mesh) / double(n));
  result.distance = distance_to(mesh);
  return result;
}

// noise in units of the spacing: uniform in each coordinate, or Gaussian
inline Points noisy(const Shape& shape, const double noise, const bool is_gaussian, const double degrees, double& along_normals)
{
  std::mt19937 random(2);
  std::normal_distribution<double> gauss(0, 1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points result = shape.clean;
  along_normals = 0;
  for (auto& [p, normal] : result)
  {
    const auto number = [&] { return is_gaussian ? gauss(random) : uniform(random); };
    const double x = number(), y = number(), z = number();
    const Vector_3 shift = noise * shape.spacing * Vector_3(x, y, z);
    p = p + shift;
    normal = normal / std::sqrt(normal.squared_length());
    along_normals += std::pow(shift * normal, 2) / double(result.size());
    if (degrees > 0)
    {
      const double u = gauss(random), v = gauss(random), w = gauss(random);
      normal = normal + degrees * pi / 180 * Vector_3(u, v, w);
    }
  }
  along_normals = std::sqrt(along_normals);
  return result;
}

// one point in fifty is put anywhere in the bounding box, with any normal, or turned
inline Points with_outliers(const Shape& shape, const bool are_turned)
{
  CGAL::Bbox_3 box;
  for (const auto& [p, normal] : shape.clean)
    box += p.bbox();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> gauss(0, 1);
  Points result = shape.clean;
  for (auto& [p, normal] : result)
  {
    if (uniform(random) >= 0.02)
      continue;
    const auto coordinate = [&](const int axis) { return box.min(axis) + uniform(random) * (box.max(axis) - box.min(axis)); };
    const double x = coordinate(0), y = coordinate(1), z = coordinate(2), u = gauss(random), v = gauss(random),
                 w = gauss(random);
    p = are_turned ? p : Point_3(x, y, z);
    normal = are_turned ? -normal : Vector_3(u, v, w);
  }
  return result;
}

// without the share of the points that is the farthest along an axis
inline Points without_cap(Points points, const int axis, const double share)
{
  std::sort(points.begin(), points.end(), [&](const auto& p, const auto& q) { return p.first[axis] < q.first[axis]; });
  points.resize(points.size() - std::size_t(share * double(points.size())));
  return points;
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_SCANNED_SHAPES_H
