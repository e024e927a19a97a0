// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the public measures do not tell of a mesh.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MESH_QUALITY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MESH_QUALITY_H

#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/distance_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// the root mean square over `mesh` of the angle between its faces and the nearest faces of `input`, in degrees
inline double normal_deviation_from(const shapes::Mesh& input, const shapes::Mesh& mesh)
{
  using namespace CGAL::Anisotropic_hde_remeshing::internal;
  const Measured_mesh reference = read_measured_mesh(input, CGAL::parameters::default_values()),
                      result = read_measured_mesh(mesh, CGAL::parameters::default_values());
  const Closest_facet closest(reference.points, reference.faces);
  const Area_sampler sampler(result, 200000);
  const auto angle = [&](const std::size_t i)
  {
    const Vector n = result.normal(sampler.face(i)).stableNormalized(),
                 m = reference.normal(closest(sampler(i)).facet).stableNormalized();
    return std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / shapes::pi;
  };
  return rms_and_max<CGAL::Parallel_if_available_tag>(sampler.size(), angle).rms;
}

// pairs of faces
inline std::size_t number_of_self_intersections(const shapes::Mesh& mesh)
{
  std::vector<std::pair<shapes::Mesh::Face_index, shapes::Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  return pairs.size();
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_MESH_QUALITY_H
