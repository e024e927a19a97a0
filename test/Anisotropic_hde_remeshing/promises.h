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

constexpr double largest_distance = 1e-8; // to the zero set, of the diagonal

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

// vertices inside that are not on the zero set
template <typename Mesh, typename Function>
std::size_t number_off_surface(const Mesh& mesh, const Function& function, const double diagonal)
{
  std::size_t number = 0;
  for (const auto v : mesh.vertices())
    if (!mesh.is_border(v))
    {
      const auto gradient = function.gradient(mesh.point(v));
      const double slope = Hde::internal::Vector(gradient.x(), gradient.y(), gradient.z()).stableNorm();
      number += !(std::abs(function(mesh.point(v))) <= largest_distance * diagonal * slope) ? 1 : 0;
    }
  return number;
}

// the first promise that does not hold; empty if all do. `before` is a mesh that was not refused.
template <typename Mesh, typename Function>
std::string broken(const Mesh& before, const Mesh& after, const Function& function, const Hde::Remeshing_result& result,
                   const bool has_self_intersection_tests)
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
  const double size = diagonal(before), unit = std::exp2(std::round(std::log2(size)));
  const Mesh scaled_before = in_unit(before, unit), scaled_after = in_unit(after, unit);
  const Hde::Shape_measures old_shape = Hde::measure_shape(scaled_before), shape = Hde::measure_shape(scaled_after);
  if (grows("degenerate faces", old_shape.number_of_degenerate_faces, shape.number_of_degenerate_faces) ||
      grows("folded edges", old_shape.number_of_folded_edges, shape.number_of_folded_edges) ||
      grows("vertices off the surface, as the result tells",
            result.projections.closest_point + result.number_of_unprojected_vertices,
            number_off_surface(after, function, size)) ||
      (has_self_intersection_tests && number_of_self_intersections(scaled_before) == 0 &&
       grows("pairs of faces that intersect", 0, number_of_self_intersections(scaled_after))))
    return text.str();
  return "";
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
  const auto np = CGAL::parameters::sigma(sigma)
                      .number_of_target_faces(number_of_faces)
                      .do_self_intersection_tests(has_self_intersection_tests);
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
