// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What `Rbf_implicit_function` makes of points as scanners deliver them: of an ellipsoid 1:2:5, and of meshes, whose facets are the
// truth. Prints three tables; see scripts/benchmark_points.sh. Usage: benchmark_points NUMBER_OF_POINTS [MESH...]

#include "Table.h"
#include "exact_surfaces.h"
#include "seconds_of.h"
#include "shapes.h"
#include "zero_set_on_grid.h"

#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace shapes;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;
typedef std::pair<Point_3, Vector_3> Oriented_point;
typedef std::vector<Oriented_point> Points;

// random points of a mesh, evenly over its area, with the normals of its vertices interpolated
Points random_points(const Mesh& mesh, const std::size_t n, std::mt19937& random)
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

Shape ellipsoid_shape(const std::size_t n)
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

Shape mesh_shape(const std::string& file, const Mesh& mesh, const std::size_t n)
{
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
#endif
  Shape result;
  result.name = file.substr(file.rfind('/') + 1);
  std::mt19937 random(1);
  result.clean = random_points(mesh, n, random);
  result.probes = random_points(mesh, 20000, random);
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  result.diagonal = std::sqrt(
      CGAL::squared_distance(Point_3(box.xmin(), box.ymin(), box.zmin()), Point_3(box.xmax(), box.ymax(), box.zmax())));
  result.spacing = std::sqrt(PMP::area(mesh) / double(n));
  const auto tree = std::make_shared<Tree>(mesh.faces().begin(), mesh.faces().end(), mesh);
  tree->accelerate_distance_queries();
  result.distance = [tree](const Point_3& p) { return std::sqrt(tree->squared_distance(p)); };
  return result;
}

// noise in units of the spacing: uniform in each coordinate, or Gaussian
Points noisy(const Shape& shape, const double noise, const bool is_gaussian, const double degrees, double& along_normals)
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

struct Errors
{
  double rms = 0, largest = 0, angle = 0;
};

// of the zero set, from the probes of the shape
Errors errors_of(const Function& f, const Shape& shape)
{
  Errors result;
  for (const auto& [start, normal] : shape.probes)
  {
    Point_3 p = start;
    for (int step = 0; step < 5; ++step)
    {
      const auto at_p = f.value_and_gradient(p);
      p = p - at_p.first / at_p.second.squared_length() * at_p.second;
    }
    const double distance = std::abs(shape.distance(p));
    result.rms += distance * distance / double(shape.probes.size());
    result.largest = (std::max)(result.largest, distance);
    const Vector_3 gradient = f.gradient(p);
    const double cosine = gradient * normal / std::sqrt(gradient.squared_length() * normal.squared_length());
    result.angle += std::pow(std::acos((std::max)(-1., (std::min)(cosine, 1.))) * 180 / pi, 2) / double(shape.probes.size());
  }
  result.rms = std::sqrt(result.rms);
  result.angle = std::sqrt(result.angle);
  return result;
}

void add_row(Table& table, const Shape& shape, const std::string& what, const Points& points, const double noise,
             const CGAL::Anisotropic_hde_remeshing::Smoothing& smoothing)
{
  std::unique_ptr<Function> f;
  const double seconds = seconds_of([&] { f = std::make_unique<Function>(points, params::smoothing(smoothing)); });
  const Errors errors = errors_of(*f, shape);
  table.add(shape.name, what, smoothing.is_automatic() ? "auto" : "0", noise / shape.diagonal,
            noise > 0 ? text(f->diagnostics().noise / noise) : text(f->diagnostics().noise), errors.rms / shape.diagonal,
            errors.largest / shape.diagonal, errors.angle, f->diagnostics().patches_on_fallback, seconds);
}

constexpr int resolution_of_grid = 60;

// the number of parts of the sign on a grid around the shape, without the outside: 1 for one solid without a hollow
int number_of_components(const Function& f)
{
  const Zero_set_on_grid zeros = zero_set_on_grid(f, resolution_of_grid);
  return zeros.negative_parts + zeros.other_parts - 1;
}

// one point in fifty is put anywhere in the bounding box, with any normal, or turned
Points with_outliers(const Shape& shape, const bool are_turned)
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

void add_rows_of_outliers(Table& table, const Shape& shape)
{
  for (const bool are_turned : {false, true})
    for (const bool are_detected : {false, true})
    {
      const Function f(with_outliers(shape, are_turned), params::detect_outliers(are_detected));
      table.add(shape.name, are_turned ? "turned normals" : "outliers", are_detected ? "yes" : "no",
                f.diagnostics().number_of_outliers, f.diagnostics().number_of_wrong_normals,
                errors_of(f, shape).rms / shape.diagonal, number_of_components(f));
    }
}

// without the share of the points that is the farthest along an axis
Points without_cap(Points points, const int axis, const double share)
{
  std::sort(points.begin(), points.end(), [&](const auto& p, const auto& q) { return p.first[axis] < q.first[axis]; });
  points.resize(points.size() - std::size_t(share * double(points.size())));
  return points;
}

// how the zero set is closed: its parts, and its distance to the shape over the diagonal
void add_rows_of_holes(Table& table, const Shape& shape)
{
  for (const double share : {0., 0.1, 0.5})
    for (int axis = 0; axis < (share > 0 ? 3 : 1); ++axis)
    {
      const Points points = without_cap(shape.clean, axis, share);
      std::unique_ptr<Function> f;
      const double seconds = seconds_of([&] { f = std::make_unique<Function>(points); });
      const Zero_set_on_grid zeros = zero_set_on_grid(*f, resolution_of_grid);
      double largest = 0, farthest = 0;
      for (const Point_3& p : zeros.points)
      {
        largest = (std::max)(largest, std::abs(shape.distance(p)));
        farthest = (std::max)(farthest, CGAL::squared_distance(p, f->bounding_sphere().center()));
      }
      table.add(shape.name, share, axis, f->diagnostics().number_of_holes, zeros.negative_parts, zeros.other_parts,
                largest / shape.diagonal, std::sqrt(farthest / f->bounding_sphere().squared_radius()), seconds);
    }
}

void add_rows(Table& table, const Shape& shape)
{
  struct Defect
  {
    const char* name;
    double noise;
    bool is_gaussian;
    double degrees;
  };
  for (const Defect& defect :
       {Defect{"clean", 0, false, 0}, Defect{"uniform .05", .05, false, 0}, Defect{"uniform .25", .25, false, 0},
        Defect{"uniform .5", .5, false, 0}, Defect{"Gaussian .25", .25, true, 0}, Defect{"Gaussian .5", .5, true, 0},
        Defect{"Gaussian .25, normals 15", .25, true, 15}})
  {
    double noise = 0;
    const Points points = noisy(shape, defect.noise, defect.is_gaussian, defect.degrees, noise);
    add_row(table, shape, defect.name, points, noise, CGAL::Anisotropic_hde_remeshing::Smoothing(0));
    add_row(table, shape, defect.name, points, noise, CGAL::Anisotropic_hde_remeshing::AUTOMATIC_SMOOTHING);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t n = argc > 1 ? std::size_t(std::stoul(argv[1])) : 10000;
  Table table(std::to_string(n) +
              " random points with normals; noise in units of the spacing, its standard deviation along the normal, "
              "distances of the zero set and their maximum over the diagonal, rms angles of the normals in degrees");
  table.add("shape", "points", "smoothing", "noise", "estimate/noise", "rms", "largest", "normals", "fallback", "s");
  Table outliers(
      "the same with 2% outliers in the bounding box, or 2% of the normals turned: detect_outliers, points and normals found");
  outliers.add("shape", "points", "detected", "outliers", "wrong normals", "rms", "components");
  Table holes("the same without the points that are the farthest along an axis: holes found, parts inside and outside, "
              "distance of the zero "
              "set to the shape over the diagonal, and its distance from the centre of the bounding sphere over the radius");
  holes.add("shape", "missing", "axis", "holes", "inside", "outside", "largest", "reach", "s");
  const auto add_all = [&](const Shape& shape)
  {
    add_rows(table, shape);
    add_rows_of_outliers(outliers, shape);
    add_rows_of_holes(holes, shape);
  };
  add_all(ellipsoid_shape(n));
  for (int i = 2; i < argc; ++i)
  {
    Mesh mesh;
    if (!PMP::IO::read_polygon_mesh(argv[i], mesh))
    {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return 1;
    }
    add_all(mesh_shape(argv[i], mesh, n));
  }
  table.print();
  outliers.print();
  holes.print();
  return 0;
}
