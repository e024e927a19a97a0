// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_RECONSTRUCT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_RECONSTRUCT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Reconstruction_result.h>
#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Tangent_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/input_of_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Duration.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/Any_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/text_of_number.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/visitor_parameter.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Limited_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Meshing_plan.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Spread_points.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/mesh_zero_set.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/points_on_zero_set.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/remesh_on_surface.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

typedef Exact_predicates_inexact_constructions_kernel Kernel_of_reconstruction;
typedef Surface_mesh<Kernel_of_reconstruction::Point_3> Reconstructed_mesh;

// the kernel of radial functions that is asked for
template <typename NamedParameters>
using Radial_function_parameter = std::decay_t<decltype(parameters::choose_parameter(
    parameters::get_parameter(std::declval<const NamedParameters&>(), internal_np::radial_function), Polyharmonic_rbf()))>;

// Meshes the zero set of a function of points: finds all its components on which points are.
template <typename ConcurrencyTag, typename Function>
class Zero_set_mesher
{
  static constexpr std::size_t few = 20;               // seeds
  static constexpr double spread_of_seeds = 0.8;       // facet sizes
  static constexpr double size_of_first_triangle = .2; // facet sizes
  static constexpr int number_of_attempts = 3;

public:
  Zero_set_mesher(const Function& function, const Meshing_plan& plan, Interruption& interruption)
    : m_function(function),
      m_criteria(plan.criteria),
      m_interruption(interruption),
      m_limited(function, plan.largest_number_of_evaluations, interruption),
      m_centre(to_vector(function.bounding_sphere().center())),
      m_squared_radius(CGAL::to_double(function.bounding_sphere().squared_radius())),
      m_exactness((std::max)(1e-4 * (std::min)(m_criteria.size, m_criteria.distance), 1e-14 * std::sqrt(m_squared_radius)))
  {
  }

  // `starts` are near all parts of the surface. `ManifoldTag` is one of CGAL's surface mesher.
  template <typename ManifoldTag>
  Triangles mesh(const std::vector<Vector>& starts)
  {
    const Zero_set_in_ball<Function> zero_set(m_limited, m_centre, m_squared_radius, m_exactness);
    std::vector<Oriented_point> seeds = well_spread(on_zero_set(starts), spread_of_seeds * m_criteria.size);
    std::vector<Vector> initial_points;
    for (const Oriented_point& p : seeds)
      initial_points.push_back(p.point);
    double edge = size_of_first_triangle * m_criteria.size;
    if (seeds.size() < few)
      add_triangles(seeds, edge, initial_points);
    for (int attempt = 1;; ++attempt)
    {
      const Triangles result = mesh_zero_set<ManifoldTag>(zero_set, initial_points, m_criteria);
      seeds = missed_seeds(seeds, result);
      m_number_of_missed_seeds = seeds.size();
      if (seeds.empty() || attempt == number_of_attempts)
        return result;
      add_triangles(seeds, edge, initial_points);
      edge /= 4;
    }
  }

  std::size_t number_of_missed_seeds() const { return m_number_of_missed_seeds; }
  std::size_t number_of_evaluations() const { return m_limited.number_of_evaluations(); }

private:
  std::vector<Oriented_point> on_zero_set(const std::vector<Vector>& starts)
  {
    return points_on_zero_set<ConcurrencyTag>(m_function, starts, m_exactness, 2 * std::sqrt(m_squared_radius), m_interruption);
  }

  // The mesher grows a component from a facet on it, which needs three points that are near each other.
  void add_triangles(const std::vector<Oriented_point>& seeds, const double edge, std::vector<Vector>& initial_points)
  {
    std::vector<Vector> starts;
    for (const Oriented_point& p : seeds)
    {
      const Tangent_frame frame = tangent_frame(p.normal);
      for (const double side : {-0.5, 0.5})
        starts.push_back(p.point + edge * (std::sqrt(0.75) * frame.col(0) + side * frame.col(1)));
    }
    for (const Oriented_point& p : on_zero_set(starts))
      initial_points.push_back(p.point);
  }

  // A vertex of the component that a seed is on would be nearer than the size of a facet.
  std::vector<Oriented_point> missed_seeds(const std::vector<Oriented_point>& seeds, const Triangles& triangles) const
  {
    Spread_points vertices(m_criteria.size);
    for (const auto& p : triangles.points)
      vertices.add(Oriented_point{to_vector(p), Vector::Zero()});
    std::vector<Oriented_point> result;
    for (const Oriented_point& p : seeds)
      if (!vertices.has_near(p))
        result.push_back(p);
    return result;
  }

  const Function& m_function;
  const Facet_criteria m_criteria;
  Interruption& m_interruption;
  Limited_function<Function> m_limited;
  Vector m_centre;
  double m_squared_radius, m_exactness;
  std::size_t m_number_of_missed_seeds = 0;
};

// points of the range, one for each place of this size
template <typename PointRange, typename NamedParameters>
std::vector<Vector> spread_points_of(const PointRange& points, const NamedParameters& np, const double size)
{
  const auto point_map = point_map_of<PointRange>(np);
  const auto normal_map = normal_map_of<PointRange>(np);
  Cell_filter filter(size);
  std::vector<Vector> result;
  for_each_of_range(points,
                    [&](const auto& item)
                    {
                      const Oriented_point p{to_vector(value_of(point_map, item)), to_vector(value_of(normal_map, item))};
                      if (filter.accepts(p))
                        result.push_back(p.point);
                    });
  return result;
}

inline std::size_t count_components(const Triangles& triangles)
{
  Disjoint_sets sets(triangles.points.size());
  for (const std::array<std::size_t, 3>& t : triangles.triangles)
  {
    sets.union_set(t[0], t[1]);
    sets.union_set(t[0], t[2]);
  }
  std::size_t result = 0;
  for (std::size_t i = 0; i < triangles.points.size(); ++i)
    result += sets.find_set(i) == i ? 1 : 0;
  return result;
}

inline Reconstructed_mesh to_mesh(const Triangles& triangles)
{
  namespace PMP = Polygon_mesh_processing;
  if (triangles.triangles.empty())
    throw std::runtime_error("no surface was found: the function of the points has no zero near them, or facet_size is larger "
                             "than the surface");
  if (!PMP::is_polygon_soup_a_polygon_mesh(triangles.triangles))
    throw std::runtime_error("the surface of the points is not manifold: a smaller facet_size or facet_distance may help");
  Reconstructed_mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(triangles.points, triangles.triangles, mesh);
  return mesh;
}

inline std::runtime_error too_rough(const Meshing_plan& plan)
{
  return std::runtime_error(
      "the surface is too rough to be meshed with facet_size " + text_of_number(plan.criteria.size) + " and facet_distance " +
      text_of_number(plan.criteria.distance) + ": " + text_of_number(plan.largest_number_of_evaluations) +
      " evaluations of the function did not suffice. Are there outliers, see detect_outliers, or is there noise, see "
      "smoothing? Otherwise larger sizes help");
}

// whether the function is closed, so that its zero set has no boundary
template <typename NamedParameters>
bool closes_holes(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::close_holes), true);
}

template <typename ConcurrencyTag, typename PointRange, typename Function, typename NamedParameters>
Triangles mesh_function(const PointRange& points, const Function& function, const NamedParameters& np,
                        Interruption& interruption, const double end_of_share, Reconstruction_result& result)
{
  static constexpr std::size_t surplus = 10; // of the evaluations that are allowed over those that clean points take
  const double squared_radius = CGAL::to_double(function.bounding_sphere().squared_radius());
  const Meshing_plan plan = meshing_plan(np, function.diagnostics(), squared_radius);
  result.facet_size = plan.criteria.size;
  result.facet_distance = plan.criteria.distance;
  interruption.begin_parts(plan.largest_number_of_evaluations / surplus, end_of_share);
  Zero_set_mesher<ConcurrencyTag, Function> mesher(function, plan, interruption);
  const std::vector<Vector> starts = spread_points_of(points, np, plan.criteria.size);
  Triangles triangles;
  try
  {
    // the other mesher is compiled only for those who may need it
    constexpr bool may_be_open = is_given<NamedParameters, internal_np::close_holes_t>;
    if (!may_be_open || closes_holes(np))
      triangles = mesher.template mesh<Manifold_tag>(starts);
    else if constexpr (may_be_open)
      triangles = mesher.template mesh<Manifold_with_boundary_tag>(starts);
  }
  catch (const Too_many_evaluations&)
  {
    throw too_rough(plan);
  }
  result.number_of_components = count_components(triangles);
  result.number_of_missed_places = mesher.number_of_missed_seeds();
  result.number_of_evaluations = mesher.number_of_evaluations();
  return triangles;
}

inline void tell_of_function(const Rbf_diagnostics& diagnostics, Reconstruction_result& result)
{
  result.number_of_points = diagnostics.number_of_points;
  result.number_of_outliers = diagnostics.number_of_outliers;
  result.number_of_wrong_normals = diagnostics.number_of_wrong_normals;
  result.number_of_closed_holes = diagnostics.number_of_holes;
  result.noise = diagnostics.noise;
  result.spacing = diagnostics.median_spacing;
}

// throws what would be thrown after a long time otherwise
template <typename NamedParameters>
void check_parameters_of_reconstruction(const NamedParameters& np)
{
  given_facet_criteria(np);
  if constexpr (asks_for_remeshing<NamedParameters>)
    check_parameters(np);
}

// from points to a mesh of its own
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Reconstructed_mesh reconstruct(const PointRange& points, const NamedParameters& np, Reconstruction_result& result)
{
  static constexpr double share_of_function = 0.3, share_of_mesher = 0.7; // of the time
  check_parameters_of_reconstruction(np);
  Remeshing_visitor nobody;
  Visitor_parameter<NamedParameters> visitor = visitor_parameter(np, nobody);
  constexpr bool remeshes = asks_for_remeshing<NamedParameters>;
  Visitor_of_part of_function(Any_visitor(visitor), 0, share_of_function), of_rest(Any_visitor(visitor), share_of_mesher, 1);
  visitor.stage_started(Stage::IMPLICIT_FUNCTION);

  Real_timer timer;
  timer.start();
  const Rbf_implicit_function<Kernel_of_reconstruction, Radial_function_parameter<NamedParameters>, ConcurrencyTag> function(
      points, parameters::begin_with(np).visitor(std::ref(of_function)));
  result.function_seconds = timer.time();
  tell_of_function(function.diagnostics(), result);

  Interruption interruption([&visitor] { return visitor.go_further(); },
                            [&visitor](const double share) { visitor.progress(share); });
  const double end_of_mesher = remeshes ? share_of_mesher : 1;
  interruption.report(share_of_function);
  Reconstructed_mesh mesh;
  {
    const Duration duration(result.meshing_seconds);
    mesh = to_mesh(mesh_function<ConcurrencyTag>(points, function, np, interruption, end_of_mesher, result));
  }
  interruption.report(end_of_mesher);
  if constexpr (remeshes)
  {
    const Duration duration(result.remeshing_seconds);
    result.remeshing =
        remesh_on_surface<ConcurrencyTag>(Whole_mesh(), mesh, function, parameters::begin_with(np).visitor(std::ref(of_rest)));
    result.is_remeshed = true;
  }
  result.number_of_vertices = mesh.number_of_vertices();
  result.number_of_faces = mesh.number_of_faces();
  return mesh;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_RECONSTRUCT_H
