// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "repair.h"

#include "Mesh.h"
#include "cracks.h"
#include "in_short.h"
#include "solids.h"
#include "walls.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <map>
#include <string>
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

void clean(Soup& soup, Repair& repair, const std::function<void()>& step_is_done)
{
  repair.merged_points = PMP::merge_duplicate_points_in_polygon_soup(soup.points, soup.faces);
  step_is_done();
  repair.near_points = close_cracks(soup, repair.tolerance, Orientation::ANY);
  step_is_done();
  repair.wall_faces = remove_double_walls(soup);
  step_is_done();
  const std::size_t number_of_points = soup.points.size(), number_of_faces = soup.faces.size();
  PMP::repair_polygon_soup(soup.points, soup.faces);
  repair.removed_points = number_of_points - (std::min)(number_of_points, soup.points.size());
  repair.removed_faces = number_of_faces - (std::min)(number_of_faces, soup.faces.size());
  step_is_done();
  repair.wall_faces += remove_single_walls(soup);
  step_is_done();
}

void orient(Soup& soup, Repair& repair)
{
  repair.doubled_points = separate_solids(soup);
  const Soup before = soup;
  PMP::orient_polygon_soup(soup.points, soup.faces);
  repair.doubled_points += soup.points.size() - before.points.size();
  for (std::size_t i = 0; i < soup.faces.size(); ++i)
    repair.turned_faces += is_turned(before, soup, i) ? 1 : 0;
}

typedef std::map<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>, int> Numbers_of_edges;

std::pair<Mesh::Vertex_index, Mesh::Vertex_index> ends(const Mesh::Vertex_index a, const Mesh::Vertex_index b)
{
  return std::minmax({a, b});
}

// the ends of the edge that a flip would make
std::pair<Mesh::Vertex_index, Mesh::Vertex_index> other_diagonal(const Mesh& mesh, const Mesh::Halfedge_index h)
{
  return ends(mesh.target(mesh.next(h)), mesh.target(mesh.next(mesh.opposite(h))));
}

// whether both triangles of a flipped edge look to the side to which both look now
bool can_be_flipped(const Mesh& mesh, const Mesh::Halfedge_index h)
{
  const Mesh::Halfedge_index g = mesh.opposite(h);
  const Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h))),
                &d = mesh.point(mesh.target(mesh.next(g)));
  const Vector_3 sum = CGAL::cross_product(b - a, c - a) + CGAL::cross_product(d - a, b - a);
  return CGAL::cross_product(d - c, a - c) * sum < 0 && CGAL::cross_product(b - c, d - c) * sum < 0;
}

// A diagonal between two vertices that have an edge already gives way to the other one, or gets a vertex in its middle.
void avoid_double_edges(Mesh& mesh, const std::vector<Mesh::Edge_index>& diagonals, Repair& repair)
{
  namespace Euler = CGAL::Euler;
  Numbers_of_edges numbers;
  for (const Mesh::Edge_index e : mesh.edges())
    ++numbers[ends(mesh.vertex(e, 0), mesh.vertex(e, 1))];
  for (const Mesh::Edge_index e : diagonals)
  {
    int& number = numbers[ends(mesh.vertex(e, 0), mesh.vertex(e, 1))];
    if (number < 2)
      continue;
    --number;
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    const auto other = other_diagonal(mesh, h);
    if (other.first != other.second && numbers[other] == 0 && can_be_flipped(mesh, h))
    {
      Euler::flip_edge(h, mesh);
      ++numbers[other];
      continue;
    }
    const Point_3 middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    const Mesh::Halfedge_index before = Euler::split_edge(h, mesh); // to the new vertex, from which h goes on
    mesh.point(mesh.target(before)) = middle;
    for (const Mesh::Halfedge_index to_middle : {before, mesh.opposite(h)})
      Euler::split_face(to_middle, mesh.next(mesh.next(to_middle)), mesh);
    ++repair.added_points;
  }
}

void divide(Mesh& mesh, Repair& repair)
{
  for (const Mesh::Face_index f : mesh.faces())
    repair.divided_faces += mesh.degree(f) > 3 ? 1 : 0;
  if (repair.divided_faces == 0)
    return;
  mesh.collect_garbage(); // so that new edges come last
  const std::size_t number_of_edges = mesh.number_of_edges();
  PMP::triangulate_faces(mesh);
  std::vector<Mesh::Edge_index> diagonals;
  for (const Mesh::Edge_index e : mesh.edges())
    if (std::size_t(e) >= number_of_edges)
      diagonals.push_back(e);
  avoid_double_edges(mesh, diagonals, repair);
}

} // namespace

std::string Repair::text() const
{
  std::string text;
  const auto add = [&text](const std::size_t count, const std::string& what)
  {
    if (count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  add(merged_points, "equal points merged");
  add(near_points, "points merged that are within " + in_short(tolerance) + " of others, which closes cracks");
  add(wall_faces, "faces of walls inside removed");
  add(removed_points, "points without a face removed");
  add(removed_faces, "faces removed that were there twice or were none");
  add(turned_faces, "faces turned over");
  add(doubled_points, "points doubled where sheets touch");
  add(divided_faces, "faces divided into triangles");
  add(added_points, "points added on diagonals, without which edges would be double");
  add(stitched_edges, "edges stitched");
  return text.empty() ? "nothing to repair" : text;
}

Soup repaired(Soup soup, const double tolerance, Repair& repair, const std::function<void()>& step_is_done)
{
  repair.tolerance = tolerance;
  clean(soup, repair, step_is_done);
  orient(soup, repair);
  step_is_done();
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  repair.stitched_edges = static_cast<std::size_t>(PMP::stitch_borders(mesh));
  repair.doubled_points += PMP::duplicate_non_manifold_vertices(mesh);
  step_is_done();
  divide(mesh, repair);
  // which side is out is anybody's guess where the input did not say
  if (repair.turned_faces > 0 && CGAL::is_closed(mesh))
    PMP::orient(mesh);
  mesh.collect_garbage();
  Soup result = soup_of_mesh(mesh);
  result.rounding = soup.rounding;
  step_is_done();
  return result;
}

} // namespace hde_remesh
