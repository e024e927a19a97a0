// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "repair.h"

#include "Mesh.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// whether the face runs through its points the other way round
bool is_turned(const Soup& before, const Soup& after, const std::size_t face)
{
  const std::vector<std::size_t>&f = before.faces[face], &g = after.faces[face];
  const auto is_first = [&](const std::size_t v) { return after.points[v] == before.points[f[0]]; };
  const std::size_t first = static_cast<std::size_t>(std::find_if(g.begin(), g.end(), is_first) - g.begin());
  return first == g.size() || after.points[g[(first + 1) % g.size()]] != before.points[f[1]];
}

void clean(Soup& soup, Repair& repair)
{
  repair.merged_points = PMP::merge_duplicate_points_in_polygon_soup(soup.points, soup.faces);
  const std::size_t number_of_points = soup.points.size(), number_of_faces = soup.faces.size();
  PMP::repair_polygon_soup(soup.points, soup.faces);
  repair.removed_points = number_of_points - (std::min)(number_of_points, soup.points.size());
  repair.removed_faces = number_of_faces - (std::min)(number_of_faces, soup.faces.size());
}

void orient(Soup& soup, Repair& repair)
{
  const Soup before = soup;
  PMP::orient_polygon_soup(soup.points, soup.faces);
  repair.doubled_points = soup.points.size() - before.points.size();
  for (std::size_t i = 0; i < soup.faces.size(); ++i)
    repair.turned_faces += is_turned(before, soup, i) ? 1 : 0;
}

} // namespace

std::string Repair::text() const
{
  std::string text;
  const auto add = [&text](const std::size_t count, const char* what)
  {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  add(merged_points, "equal points merged");
  add(removed_points, "points without a face removed");
  add(removed_faces, "faces removed that were there twice or were none");
  add(turned_faces, "faces turned over");
  add(doubled_points, "points doubled where sheets touch");
  add(divided_faces, "faces divided into triangles");
  add(stitched_edges, "edges stitched");
  return text.empty() ? "nothing to repair" : text;
}

Soup repaired(Soup soup, Repair& repair)
{
  clean(soup, repair);
  orient(soup, repair);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  repair.stitched_edges = static_cast<std::size_t>(PMP::stitch_borders(mesh));
  repair.doubled_points += PMP::duplicate_non_manifold_vertices(mesh);
  for (const Mesh::Face_index f : mesh.faces())
    repair.divided_faces += mesh.degree(f) > 3 ? 1 : 0;
  PMP::triangulate_faces(mesh);
  // which side is out is anybody's guess where the input did not say
  if (repair.turned_faces > 0 && CGAL::is_closed(mesh))
    PMP::orient(mesh);
  mesh.collect_garbage();
  return soup_of_mesh(mesh);
}

} // namespace hde_remesh
