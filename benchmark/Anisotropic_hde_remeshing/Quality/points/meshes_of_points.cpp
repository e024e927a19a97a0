// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "meshes_of_points.h"
#include "Peak_memory.h"
#include "seconds_of.h"

#include <CGAL/compute_average_spacing.h>
#ifndef CGAL_NO_DEPRECATION_WARNINGS
#  define CGAL_NO_DEPRECATION_WARNINGS // the surface mesher is one that CGAL 6 would rather see replaced
#endif
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/rbf_surface_reconstruction.h>

namespace {

namespace AHR = CGAL::Anisotropic_hde_remeshing;
namespace params = AHR::parameters;
typedef CGAL::First_of_pair_property_map<Oriented_point> Point_map;
typedef CGAL::Second_of_pair_property_map<Oriented_point> Normal_map;

bool by_rbf(const Points& points, Mesh& mesh)
{
  try
  {
    CGAL::rbf_surface_reconstruction<CGAL::Parallel_if_available_tag>(
        points, mesh, params::smoothing(AHR::AUTOMATIC_SMOOTHING).detect_outliers(true));
    return true;
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

bool by_poisson(const Points& points, Mesh& mesh)
{
  const double spacing =
      CGAL::compute_average_spacing<CGAL::Parallel_if_available_tag>(points, 6, CGAL::parameters::point_map(Point_map()));
  return CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), Point_map(), Normal_map(), mesh, spacing);
}

struct Distances
{
  double rms = 0, largest = 0, of_shape = 0;
};

Distances distances(const Mesh& mesh, const Shape& shape)
{
  Distances result;
  for (const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    const Point_3 p =
        CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
    const double distance = std::abs(shape.distance(p));
    result.rms += distance * distance / double(mesh.number_of_faces());
    result.largest = (std::max)(result.largest, distance);
  }
  result.rms = std::sqrt(result.rms);
  const auto distance = distance_to(mesh);
  for (const auto& probe : shape.probes)
    result.of_shape = (std::max)(result.of_shape, distance(probe.first));
  return result;
}

int number_of_components(const Mesh& mesh)
{
  Mesh copy = mesh;
  const auto component = copy.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  return int(PMP::connected_components(copy, component));
}

void add_row(Table& table, const Shape& shape, const std::string& what, const Points& points, const bool is_poisson)
{
  Mesh mesh;
  bool is_made = false;
  const Peak_memory memory;
  const double seconds = seconds_of([&] { is_made = is_poisson ? by_poisson(points, mesh) : by_rbf(points, mesh); });
  const double megabytes = memory.megabytes();
  const std::string by = is_poisson ? "Poisson" : "rbf";
  if (!is_made || mesh.number_of_faces() == 0)
  {
    table.add(shape.name, what, by, "none", "", "", "", "", seconds, megabytes);
    return;
  }
  const Distances d = distances(mesh, shape);
  table.add(shape.name, what, by, mesh.number_of_faces(), number_of_components(mesh), d.rms / shape.diagonal,
            d.largest / shape.diagonal, d.of_shape / shape.diagonal, seconds, megabytes);
}

} // namespace

void add_rows_of_meshes(Table& table, const Shape& shape)
{
  double along_normals = 0;
  const std::vector<std::pair<std::string, Points>> inputs = {{"clean", shape.clean},
                                                              {"noise .25", noisy(shape, 0.25, false, 0, along_normals)},
                                                              {"noise .5", noisy(shape, 0.5, false, 0, along_normals)},
                                                              {"2% outliers", with_outliers(shape, false)},
                                                              {"2% turned", with_outliers(shape, true)},
                                                              {"without 10% along z", without_cap(shape.clean, 2, 0.1)},
                                                              {"without half along z", without_cap(shape.clean, 2, 0.5)}};
  for (const auto& [what, points] : inputs)
    for (const bool is_poisson : {false, true})
      add_row(table, shape, what, points, is_poisson);
}
