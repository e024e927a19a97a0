// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "measure.h"

#include <CGAL/Anisotropic_hde_remeshing/alignment_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

namespace {

typedef CGAL::Parallel_if_available_tag Tag;

std::size_t number_of_self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<Tag>(mesh, std::back_inserter(pairs));
  return pairs.size();
}

} // namespace

Hde::Topology_measures measure_topology(const Mesh& mesh) { return Hde::measure_topology(mesh); }

double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

namespace {

Function_figures measure_by_function(const Mesh& mesh, const Function_view& function, const double sigma,
                                     const double target_edge_length, const std::function<void()>& step_is_done)
{
  const auto np = params::sigma(sigma).face_patch_map(creases_of(mesh).region);
  Function_figures figures;
  figures.embedding = Hde::measure_embedding<Tag>(mesh, function, np);
  step_is_done();
  figures.embedding_to_target = Hde::measure_embedding<Tag>(mesh, function, np.target_edge_length(target_edge_length));
  step_is_done();
  figures.alignment = Hde::measure_alignment<Tag>(mesh, function, np);
  step_is_done();
  figures.zero_set = Hde::measure_distance_to_zero_set<Tag>(mesh, function, np);
  step_is_done();
  figures.bounds = Hde::approximation_bounds<Tag>(mesh, function, np);
  step_is_done();
  return figures;
}

} // namespace

std::vector<double> costs_of_measures(const Mesh& mesh, const Function_view& function, const bool with_self_intersections)
{
  std::vector<double> costs = {1}; // of a face, measured on the bunny
  if (function.has_values())
    costs.insert(costs.end(), {1, 1, 3, 7, 4});
  if (with_self_intersections)
    costs.push_back(3);
  for (double& cost : costs)
    cost *= static_cast<double>(mesh.number_of_faces());
  return costs;
}

Figures measure(const Mesh& mesh, const Function_view& function, const double sigma, const double target_edge_length,
                const bool with_self_intersections, const std::function<void()>& step_is_done)
{
  Figures figures;
  figures.topology = Hde::measure_topology(mesh);
  figures.shape = Hde::measure_shape(mesh);
  step_is_done();
  if (function.has_values())
    figures.of_function = measure_by_function(mesh, function, sigma, target_edge_length, step_is_done);
  if (with_self_intersections)
  {
    figures.self_intersections = number_of_self_intersections(mesh);
    step_is_done();
  }
  return figures;
}

double distance_of_sharp_edges(const Mesh& mesh, const Mesh& other, const double degrees)
{
  const auto normal = [&mesh](const Mesh::Halfedge_index h)
  { return CGAL::Polygon_mesh_processing::compute_face_normal(mesh.face(h), mesh); };
  const double largest_cosine = std::cos(degrees * CGAL_PI / 180);
  std::vector<Point_3> points;
  for (const Mesh::Edge_index e : mesh.edges())
    if (!mesh.is_border(e) && normal(mesh.halfedge(e, 0)) * normal(mesh.halfedge(e, 1)) <= largest_cosine)
    {
      const Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
      points.insert(points.end(), {p, CGAL::midpoint(p, q), q});
    }
  const Hde::internal::Distance_to_mesh<Mesh, CGAL::parameters::Default_named_parameters> distance(
      other, CGAL::parameters::default_values());
  const auto of_point = [&](const std::size_t i)
  { return distance(Hde::internal::Vector(points[i].x(), points[i].y(), points[i].z())); };
  return points.empty() ? 0 : Hde::internal::rms_and_max<Tag>(points.size(), of_point).max;
}

Hde::Distance_measures measure_distance(const Mesh& first, const Mesh& second)
{
  return Hde::measure_distance<Tag>(first, second);
}

} // namespace hde_remesh
