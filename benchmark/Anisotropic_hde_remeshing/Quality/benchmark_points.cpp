// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What `Rbf_implicit_function` makes of points as scanners deliver them: of an ellipsoid 1:2:5, and of meshes, whose facets are the
// truth. Prints four tables; see scripts/benchmark_points.sh. Usage: benchmark_points NUMBER_OF_POINTS [MESH...]

#include "Table.h"
#include "points/meshes_of_points.h"
#include "points/scanned_shapes.h"
#include "seconds_of.h"
#include "zero_set_on_grid.h"

#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>

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

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

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
  Table meshes("meshes by one call: rbf_surface_reconstruction() with AUTOMATIC_SMOOTHING and detect_outliers, and "
               "CGAL::poisson_surface_reconstruction_delaunay(); distances over the diagonal, without a cap or a half both of "
               "the closing");
  meshes.add("shape", "points", "by", "faces", "components", "rms", "largest", "of shape", "s", "MB");
  const auto add_all = [&](const Shape& shape)
  {
    add_rows_of_meshes(meshes, shape);
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
  meshes.print();
  return 0;
}
