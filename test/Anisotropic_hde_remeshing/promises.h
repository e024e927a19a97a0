// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the package promises of every mesh and all parameters, as tests, benchmarks and fuzzers hold it.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PROMISES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PROMISES_H

#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_result.h>
#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace promises {

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

constexpr double largest_distance = 1e-8; // of a vertex that counts as on the zero set, of the diagonal

template <typename Mesh>
double diagonal(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v))
      box += mesh.point(v).bbox();
  const Hde::internal::Vector size(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  return size.stableNorm();
}

// in a unit of its own, in which the predicates of the kernel neither overflow nor vanish
template <typename Mesh>
Mesh in_unit(Mesh mesh, const double unit)
{
  for (const auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + (mesh.point(v) - CGAL::ORIGIN) / unit;
  return mesh;
}

template <typename Mesh>
std::size_t number_of_self_intersections(const Mesh& mesh)
{
  typedef typename Mesh::Face_index Face;
  std::vector<std::pair<Face, Face>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  return pairs.size();
}

template <typename Mesh>
bool has_finite_points(const Mesh& mesh)
{
  for (const auto v : mesh.vertices())
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(mesh.point(v)[i]))
        return false;
  return true;
}

// to first order; not if it is not a number
template <typename Function, typename Point>
bool is_within(const double distance, const Function& function, const Point& p)
{
  const auto gradient = function.gradient(p);
  return std::abs(function(p)) <= distance * Hde::internal::Vector(gradient.x(), gradient.y(), gradient.z()).stableNorm();
}

// How many vertices are off the surface, from one number to the other: at distances within one per cent of the largest one, sums in
// another order may tell otherwise.
struct Number_off_surface
{
  std::size_t least = 0, most = 0;
};

// of the vertices inside for which `is_free(v)`, from the zero set of `function_at(v)`; the diagonal is that of the input
template <typename Mesh, typename IsFree, typename FunctionAt>
Number_off_surface number_off_surface(const Mesh& mesh, const double diagonal, const IsFree& is_free,
                                      const FunctionAt& function_at)
{
  const double distance = largest_distance * diagonal;
  Number_off_surface result;
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v) && !mesh.is_border(v) && is_free(v))
    {
      result.least += is_within(1.01 * distance, function_at(v), mesh.point(v)) ? 0 : 1;
      result.most += is_within(0.99 * distance, function_at(v), mesh.point(v)) ? 0 : 1;
    }
  return result;
}

// The first promise that does not hold; empty if all do. `before` is a mesh that was not refused, `off_surface` the number of
// vertices of `after`, which are told in the result exactly.
template <typename Mesh>
std::string broken(const Mesh& before, const Mesh& after, const Number_off_surface& off_surface,
                   const Hde::Remeshing_result& result, const bool has_self_intersection_tests)
{
  std::ostringstream text;
  const auto grows = [&](const char* what, const std::size_t old_number, const std::size_t number)
  {
    if (number > old_number)
      text << number << ' ' << what << ", there were " << old_number;
    return number > old_number;
  };
  if (!CGAL::is_valid_polygon_mesh(after))
    return "the mesh is not valid";
  if (!CGAL::is_triangle_mesh(after))
    return "not all faces are triangles";
  const Hde::Topology_measures old_topology = Hde::measure_topology(before), topology = Hde::measure_topology(after);
  if (topology.number_of_components != old_topology.number_of_components)
    return "the number of components changed";
  if (topology.number_of_boundary_loops != old_topology.number_of_boundary_loops)
    return "the number of boundaries changed";
  if (topology.euler_characteristic != old_topology.euler_characteristic)
    return "the Euler characteristic changed";
  if (!has_finite_points(after))
    return "a coordinate is not finite";
  if (result.number_of_unprojected_vertices < off_surface.least || result.number_of_unprojected_vertices > off_surface.most)
  {
    text << off_surface.least << " vertices are off the surface, " << result.number_of_unprojected_vertices
         << " as the result tells";
    return text.str();
  }
  const double size = diagonal(before), unit = std::exp2(std::round(std::log2(size)));
  const Mesh scaled_before = in_unit(before, unit), scaled_after = in_unit(after, unit);
  const Hde::Shape_measures old_shape = Hde::measure_shape(scaled_before), shape = Hde::measure_shape(scaled_after);
  if (grows("degenerate faces", old_shape.number_of_degenerate_faces, shape.number_of_degenerate_faces) ||
      grows("folded edges", old_shape.number_of_folded_edges, shape.number_of_folded_edges) ||
      (has_self_intersection_tests && grows("pairs of faces that intersect", number_of_self_intersections(scaled_before),
                                            number_of_self_intersections(scaled_after))))
    return text.str();
  return "";
}

// the same on the zero set of one function, with no vertex inside that must stay where it is
template <typename Mesh, typename Function>
std::string broken(const Mesh& before, const Mesh& after, const Function& function, const Hde::Remeshing_result& result,
                   const bool has_self_intersection_tests)
{
  if (!has_finite_points(after))
    return "a coordinate is not finite";
  const Number_off_surface off_surface = number_off_surface(
      after, diagonal(before), [](typename Mesh::Vertex_index) { return true; },
      [&](typename Mesh::Vertex_index) -> const Function& { return function; });
  return broken(before, after, off_surface, result, has_self_intersection_tests);
}

enum class Kind
{
  VALID,
  REFUSED, // by a documented exception, with the mesh as it was
  BROKEN
};

struct Outcome
{
  Kind kind;
  std::string text; // the refusal, or what is broken
  double seconds = 0;
  std::size_t number_of_faces = 0; // of the result
};

// One call. Without a function the package builds it, which must refuse to.
template <typename ConcurrencyTag, typename Mesh, typename Function>
Outcome outcome(const Mesh& input, const std::optional<Function>& function, const double sigma,
                const std::size_t number_of_faces, const bool has_self_intersection_tests)
{
  Mesh mesh = input;
  const auto np =
      params::sigma(sigma).number_of_target_faces(number_of_faces).do_self_intersection_tests(has_self_intersection_tests);
  CGAL::Real_timer timer;
  timer.start();
  try
  {
    const Hde::Remeshing_result result = function ? CGAL::anisotropic_hde_remeshing<ConcurrencyTag>(mesh, *function, np)
                                                  : CGAL::anisotropic_hde_remeshing<ConcurrencyTag>(mesh, np);
    const double seconds = timer.time();
    const std::string text =
        function ? broken(input, mesh, *function, result, has_self_intersection_tests) : "it is not refused";
    return Outcome{text.empty() ? Kind::VALID : Kind::BROKEN, text, seconds, mesh.number_of_faces()};
  }
  catch (const std::invalid_argument& error)
  {
    if (remeshing_checks::digest(mesh) == remeshing_checks::digest(input))
      return Outcome{Kind::REFUSED, error.what()};
    return Outcome{Kind::BROKEN, std::string("the mesh was changed before the refusal: ") + error.what()};
  }
  catch (const std::exception& error)
  {
    return Outcome{Kind::BROKEN, error.what()};
  }
}

} // namespace promises

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PROMISES_H
