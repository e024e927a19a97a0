// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_SURFACE_MESH_TRAITS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_SURFACE_MESH_TRAITS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/reconstruction/Zero_set_in_ball.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Object.h>

#include <optional>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What CGAL's surface mesher asks of a surface, a model of its SurfaceMeshTraits_3. CGAL's own for implicit functions asks for
// signs only: it bisects, and evaluates the centre of a cell anew for each of its facets.
template <typename Function>
class Surface_mesh_traits
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;

public:
  typedef Zero_set_in_ball<Function> Surface_3;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Segment_3 Segment_3;
  typedef Kernel::Ray_3 Ray_3;
  typedef Kernel::Line_3 Line_3;
  typedef Point_3 Intersection_point;

  static std::optional<Crossing_way> crossing_way(const Surface_3& surface, const Segment_3& segment)
  {
    return surface.on_segment(to_vector(segment.source()), to_vector(segment.target()));
  }
  static std::optional<Crossing_way> crossing_way(const Surface_3& surface, const Ray_3& ray)
  {
    return surface.on_ray(to_vector(ray.source()), to_vector(ray.to_vector()));
  }
  static std::optional<Crossing_way> crossing_way(const Surface_3& surface, const Line_3& line)
  {
    return surface.on_line(to_vector(line.point(0)), to_vector(line.to_vector()));
  }

  // of whatever the dual of a facet is
  static std::optional<Crossing_way> crossing_way(const Surface_3& surface, const Object& dual)
  {
    if (const Segment_3* const segment = object_cast<Segment_3>(&dual))
      return crossing_way(surface, *segment);
    if (const Ray_3* const ray = object_cast<Ray_3>(&dual))
      return crossing_way(surface, *ray);
    if (const Line_3* const line = object_cast<Line_3>(&dual))
      return crossing_way(surface, *line);
    return std::nullopt;
  }

  struct Intersect_3
  {
    template <typename Dual>
    Object operator()(const Surface_3& surface, const Dual& dual) const
    {
      const std::optional<Crossing_way> way = crossing_way(surface, dual);
      if (!way)
        return Object();
      const Vector zero = surface.zero_on(*way);
      return make_object(Point_3(zero.x(), zero.y(), zero.z()));
    }
  };

  // none: they are in the triangulation already
  struct Construct_initial_points
  {
    template <typename OutputIterator>
    OutputIterator operator()(const Surface_3&, const OutputIterator out, int) const
    {
      return out;
    }
  };

  Intersect_3 intersect_3_object() const { return Intersect_3(); }
  Construct_initial_points construct_initial_points_object() const { return Construct_initial_points(); }
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_RECONSTRUCTION_SURFACE_MESH_TRAITS_H
