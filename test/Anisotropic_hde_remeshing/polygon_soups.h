// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Soups of polygons, and the meshes that they are, perhaps after CGAL's repair.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_POLYGON_SOUPS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_POLYGON_SOUPS_H

#include "shapes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace polygon_soups {

namespace PMP = CGAL::Polygon_mesh_processing;

struct Polygon_soup
{
  std::vector<shapes::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

inline Polygon_soup to_polygons(const shapes::Soup& triangles)
{
  Polygon_soup soup;
  soup.points = triangles.points;
  for (const auto& t : triangles.triangles)
    soup.polygons.push_back({t[0], t[1], t[2]});
  return soup;
}

inline bool has_finite_points(const Polygon_soup& soup)
{
  for (const shapes::Point_3& p : soup.points)
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      return false;
  return true;
}

inline bool has_valid_indices(const Polygon_soup& soup)
{
  for (const auto& polygon : soup.polygons)
    for (const std::size_t i : polygon)
      if (i >= soup.points.size())
        return false;
  return true;
}

// of triangles; none if the soup is no manifold. Requires valid indices.
inline std::optional<shapes::Mesh> mesh_of(const Polygon_soup& soup)
{
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    return std::nullopt;
  shapes::Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  PMP::triangulate_faces(mesh);
  mesh.collect_garbage();
  return mesh;
}

// requires that it is finite
inline Polygon_soup repaired(Polygon_soup soup)
{
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  PMP::orient_polygon_soup(soup.points, soup.polygons);
  return soup;
}

} // namespace polygon_soups

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_POLYGON_SOUPS_H
