// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "mesh_of_points.h"
#include "Failure.h"
#include "Nearest_points.h"
#include "Stopwatch.h"
#include "estimate_normals.h"
#include "in_short.h"
#include "reconstruct.h"
#include "trim.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

constexpr std::size_t least_number_of_points = 10; // what a quadric takes

[[noreturn]] void fail(const Options& options, const std::string& reason)
{
  throw Failure(in_quotes(options.input) + ": " + reason);
}

std::string counted(const std::size_t number, const std::string& what)
{
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

void check(const Soup& points, const Options& options)
{
  const std::size_t number = points.points.size();
  if (number < least_number_of_points)
    fail(options, "it has " + counted(number, "point") + " and no faces: too few for a surface");
  if (options.repair || options.merge)
    fail(options, std::string(options.repair ? "--repair" : "--merge") + " is for meshes, and it has points and no faces");
  CGAL::Bbox_3 box;
  for (const Point_3& p : points.points)
    box += p.bbox();
  const double squared_diagonal =
      Vector_3(Point_3(box.xmin(), box.ymin(), box.zmin()), Point_3(box.xmax(), box.ymax(), box.zmax())).squared_length();
  if (!std::isfinite(squared_diagonal) || !(squared_diagonal > 0))
    fail(options, "its bounding box has the diagonal " + std::to_string(std::sqrt(squared_diagonal)) +
                      ", with which nobody can compute");
}

bool is_known(const Vector_3& normal)
{
  const double squared_length = normal.squared_length();
  return std::isfinite(squared_length) && squared_length > 0;
}

// those of the file, zero where they are none; or estimated, if there are none at all
std::vector<Vector_3> normals_of(const Soup& points, Points_figures& figures, Report& report, Progress& progress)
{
  std::vector<Vector_3> normals = points.normals;
  for (Vector_3& normal : normals)
    if (!is_known(normal))
      normal = Vector_3(0, 0, 0);
  figures.are_normals_estimated = std::none_of(normals.begin(), normals.end(), is_known);
  if (figures.are_normals_estimated)
  {
    progress.stage("normals");
    const Stopwatch stopwatch;
    normals = estimate_normals(points.points);
    report.stages.emplace_back("normals", stopwatch.seconds());
  }
  const auto unknown = [](const Vector_3& normal) { return !is_known(normal); };
  figures.number_without_normal = std::size_t(std::count_if(normals.begin(), normals.end(), unknown));
  return normals;
}

void tell_normals(const Soup& points, const Points_figures& figures, Report& report)
{
  report.notes.push_back("IN has " + std::to_string(points.points.size()) +
                         " points and no faces: a surface is made of them, and that is meant by IN from here on");
  const std::string number = std::to_string(figures.number_without_normal);
  if (figures.are_normals_estimated)
    report.notes.push_back("IN has no normals: they are estimated, and oriented from point to point; " + number +
                           " points could not be oriented, and count without a normal");
  else if (figures.number_without_normal > 0)
    report.notes.push_back(number + " points of IN have no normal, and count without");
}

void tell_found(const Hde::Reconstruction_result& found, Report& report)
{
  std::string noise = found.noise > 0 ? "noise of " + in_short(found.noise) : "no noise";
  if (found.noise > 0 && found.spacing > 0)
    noise += ", " + in_short(found.noise / found.spacing) + " of the spacing";
  report.notes.push_back("found " + noise + "; " + counted(found.number_of_outliers, "outlier") + ", left out; " +
                         counted(found.number_of_wrong_normals, "wrong normal") + ", turned or dropped; " +
                         counted(found.number_of_closed_holes, "hole") + ", closed; " +
                         counted(found.number_of_components, "component") + " of " + counted(found.number_of_faces, "face"));
  if (found.number_of_missed_places > 0)
    report.warnings.push_back("at " + counted(found.number_of_missed_places, "place") +
                              " near points the surface is too small for facets of the size of the spacing, and is missing");
}

void trim(const Soup& points, const Options& options, Mesh& mesh, Points_figures& figures, Report& report)
{
  const Soup soup = trimmed(soup_of_mesh(mesh), Nearest_points(points.points), *options.trim);
  figures.trim = options.trim;
  figures.number_of_faces_after_trimming = soup.faces.size();
  if (soup.faces.empty())
    throw Failure("--trim " + in_short(*options.trim) +
                  " leaves nothing: the surface is further from all points, whose spacing is " +
                  in_short(figures.found.spacing));
  mesh = mesh_of_soup(soup, options.input).mesh;
  static constexpr double wide_gap = 2; // in units of the spacing, as random points have
  if (*options.trim < wide_gap * figures.found.spacing)
    report.warnings.push_back("--trim " + in_short(*options.trim) + " is less than two spacings of the points, " +
                              in_short(wide_gap * figures.found.spacing) + ": it may cut holes between points");
}

void keep_largest(Mesh& mesh, Points_figures& figures)
{
  figures.number_of_removed_components = PMP::keep_largest_connected_components(mesh, 1);
  mesh.collect_garbage();
}

const Array* find_array(const Soup& points, const std::string& name)
{
  const auto found = std::find_if(points.vertex_arrays.begin(), points.vertex_arrays.end(),
                                  [&](const Array& array) { return array.name == name; });
  return found == points.vertex_arrays.end() ? nullptr : &*found;
}

void add_field_of_points(const Soup& points, const Options& options, Mesh& mesh)
{
  const Array* const array = find_array(points, options.field);
  if (!array)
    fail(options, "its points have no property " + in_quotes(options.field) + " of numbers");
  for (const double value : array->values)
    if (!std::isfinite(value))
      fail(options, "the property " + in_quotes(options.field) + " has the value " + std::to_string(value));
  const Nearest_points nearest(points.points);
  Field field = add_field(mesh);
  for (const Mesh::Vertex_index v : mesh.vertices())
    field[v] = array->values[nearest.nearest(mesh.point(v))];
}

} // namespace

Mesh mesh_of_points(const Soup& points, const Options& options, Report& report, Progress& progress)
{
  check(points, options);
  Points_figures& figures = report.points.emplace();
  figures.number = points.points.size();
  const std::vector<Vector_3> normals = normals_of(points, figures, report, progress);
  tell_normals(points, figures, report);
  if (std::none_of(normals.begin(), normals.end(), is_known))
    fail(options, "no normals could be estimated: its points are on a line, or equal");
  const Stopwatch stopwatch;
  Reconstructed reconstructed = reconstruct(points.points, normals, options, progress);
  Mesh& mesh = reconstructed.mesh;
  figures.found = reconstructed.result;
  tell_found(figures.found, report);
  if (options.trim)
    trim(points, options, mesh, figures, report);
  if (options.keep_largest)
    keep_largest(mesh, figures);
  if (!options.field.empty())
    add_field_of_points(points, options, mesh);
  report.stages.emplace_back("surface of the points", stopwatch.seconds());
  return std::move(mesh);
}

void carry_to(Soup& soup, const Soup& points, Report& report)
{
  if (points.vertex_arrays.empty())
    return;
  const Nearest_points nearest(points.points);
  std::vector<std::size_t> places;
  for (const Point_3& p : soup.points)
    places.push_back(nearest.nearest(p));
  for (const Array& array : points.vertex_arrays)
  {
    Array carried{find_array(soup, array.name) ? array.name + "_of_points" : array.name, {}, array.are_bytes};
    for (const std::size_t i : places)
      carried.values.push_back(array.values[i]);
    report.points->carried.push_back(carried.name);
    soup.vertex_arrays.push_back(std::move(carried));
  }
}

Options without_noise(Options options)
{
  options.smoothing.reset();
  options.automatic_smoothing = false;
  return options;
}

void check_options_of_mesh(const Options& options)
{
  for (const auto& [name, is_given] :
       {std::make_pair("--trim", options.trim.has_value()), std::make_pair("--keep-largest", options.keep_largest),
        std::make_pair("--keep-outliers", !options.detect_outliers)})
    if (is_given)
      throw Failure(std::string(name) + " is for points, and " + in_quotes(options.input) + " is a mesh");
}

} // namespace hde_remesh
