// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_MESH_ZERO_SET_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_MESH_ZERO_SET_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Surface_mesh_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Zero_set_in_ball.h>

// CGAL 6 calls its surface mesher deprecated, and still has it in 6.2. Users cannot change that, so they need no warning.
#ifndef CGAL_NO_DEPRECATION_WARNINGS
#  define CGAL_NO_DEPRECATION_WARNINGS
#  define CGAL_AHR_NO_DEPRECATION_WARNINGS
#endif
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>
#ifdef CGAL_AHR_NO_DEPRECATION_WARNINGS
#  undef CGAL_NO_DEPRECATION_WARNINGS
#  undef CGAL_AHR_NO_DEPRECATION_WARNINGS
#endif

#include <CGAL/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the criteria of CGAL's surface mesher
struct Facet_criteria
{
  double angle = 25;   // degrees, at least
  double size = 0;     // of the radius of the ball about a facet that has its centre on the surface, at most
  double distance = 0; // from the centre of this ball to that of the circumcircle of the facet, at most
};

struct Triangles
{
  std::vector<Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// The order in which CGAL has them depends on addresses. The mesh shall not.
inline Triangles sorted(const Triangles& given)
{
  std::vector<std::size_t> order(given.points.size()), place(given.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](const std::size_t i, const std::size_t j) { return given.points[i] < given.points[j]; });
  Triangles result;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    place[order[i]] = i;
    result.points.push_back(given.points[order[i]]);
  }
  for (const std::array<std::size_t, 3>& t : given.triangles)
  {
    std::array<std::size_t, 3> triangle{place[t[0]], place[t[1]], place[t[2]]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    result.triangles.push_back(triangle);
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

// the facets, seen from where the function is positive
template <typename Complex, typename Zero_set, typename Traits>
Triangles oriented_facets(const Complex& complex, const Zero_set& zero_set, const Traits&)
{
  typedef typename Complex::Triangulation Triangulation;
  const Triangulation& triangulation = complex.triangulation();
  Triangles result;
  std::unordered_map<const void*, std::size_t> indices;
  const auto index = [&](const typename Triangulation::Vertex_handle v)
  {
    const auto inserted = indices.emplace(&*v, result.points.size());
    if (inserted.second)
      result.points.push_back(v->point());
    return inserted.first->second;
  };
  for (auto facet = triangulation.finite_facets_begin(); facet != triangulation.finite_facets_end(); ++facet)
    if (facet->first->is_facet_on_surface(facet->second))
      if (const auto way = Traits::crossing_way(zero_set, triangulation.dual(*facet)))
      {
        std::array<typename Triangulation::Vertex_handle, 3> v;
        for (int i = 0; i < 3; ++i)
          v[std::size_t(i)] = facet->first->vertex((facet->second + 1 + i) & 3);
        const Vector p = to_vector(v[0]->point());
        const Vector normal = (to_vector(v[1]->point()) - p).cross(to_vector(v[2]->point()) - p);
        if (normal.dot(way->outward()) < 0)
          std::swap(v[1], v[2]);
        result.triangles.push_back({index(v[0]), index(v[1]), index(v[2])});
      }
  return sorted(result);
}

// Meshes the parts of the zero set on which the points are, by CGAL's surface mesher. `ManifoldTag` is one of CGAL's. There are no
// triangles if it finds no surface at all.
template <typename ManifoldTag, typename Function>
Triangles mesh_zero_set(const Zero_set_in_ball<Function>& zero_set, const std::vector<Vector>& points,
                        const Facet_criteria& criteria)
{
  typedef Surface_mesh_default_triangulation_3 Triangulation;
  typedef Surface_mesh_complex_2_in_triangulation_3<Triangulation> Complex;
  typedef Surface_mesh_traits<Function> Traits;
  std::vector<typename Triangulation::Point> initial_points;
  for (const Vector& p : points)
    initial_points.emplace_back(p.x(), p.y(), p.z());
  try
  {
    Triangulation triangulation;
    triangulation.insert(initial_points.begin(), initial_points.end());
    if (triangulation.dimension() < 3)
      return Triangles();
    Complex complex(triangulation);
    make_surface_mesh(complex, zero_set, Traits(),
                      Surface_mesh_default_criteria_3<Triangulation>(criteria.angle, criteria.size, criteria.distance),
                      ManifoldTag());
    return oriented_facets(complex, zero_set, Traits());
  }
  catch (const Failure_exception& failure)
  {
    throw std::runtime_error("CGAL's surface mesher has failed: " + std::string(failure.what()));
  }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_MESH_ZERO_SET_H
