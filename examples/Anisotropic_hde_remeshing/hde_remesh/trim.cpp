// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "trim.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

enum class Side
{
  INSIDE,
  ON_LINE,
  OUTSIDE
};

class Trimmer
{
  typedef std::vector<std::size_t> Face;
  typedef std::pair<std::size_t, std::size_t> Edge; // from a vertex inside to one outside

  struct Crossing
  {
    double share; // of the edge
    Point_3 point;
  };

  static constexpr double near_share = 0.15; // of an edge: a vertex so near to the line is moved onto it

public:
  Trimmer(const Soup& mesh, const Nearest_points& data, const double distance)
    : m_data(data), m_distance(distance), m_points(mesh.points)
  {
    for (const Point_3& p : m_points)
      m_sides.push_back(is_inside(p) ? Side::INSIDE : Side::OUTSIDE);
    for (const Face& face : mesh.faces)
      for (std::size_t k = 0; k < 3; ++k)
        find_crossing(face[k], face[(k + 1) % 3]);
    move_near_vertices();
    for (const Face& face : mesh.faces)
      cut(face);
  }

  Soup result()
  {
    Soup soup;
    soup.points = std::move(m_points);
    soup.faces = std::move(m_faces);
    PMP::orient_polygon_soup(soup.points, soup.faces); // which doubles points where parts touch, and turns no face
    PMP::remove_isolated_points_in_polygon_soup(soup.points, soup.faces);
    return soup;
  }

private:
  bool is_inside(const Point_3& p) const { return m_data.distance(p) <= m_distance; }

  void find_crossing(std::size_t in, std::size_t out)
  {
    static constexpr int number_of_halvings = 20;
    if (m_sides[in] == m_sides[out])
      return;
    if (m_sides[in] == Side::OUTSIDE)
      std::swap(in, out);
    const auto inserted = m_crossings.emplace(Edge(in, out), Crossing{0, m_points[in]});
    if (!inserted.second)
      return;
    const Point_3 origin = m_points[in];
    const Vector_3 way = m_points[out] - origin;
    double low = 0, high = 1;
    for (int i = 0; i < number_of_halvings; ++i)
    {
      const double middle = (low + high) / 2;
      (is_inside(origin + middle * way) ? low : high) = middle;
    }
    inserted.first->second = Crossing{low, origin + low * way};
  }

  // each to the nearest crossing of its edges
  void move_near_vertices()
  {
    std::map<std::size_t, Crossing> nearest; // the share from the vertex
    const auto offer = [&](const std::size_t v, const double share, const Point_3& p)
    {
      if (share > near_share)
        return;
      const auto inserted = nearest.emplace(v, Crossing{share, p});
      if (share < inserted.first->second.share)
        inserted.first->second = Crossing{share, p};
    };
    for (const auto& [edge, crossing] : m_crossings)
    {
      offer(edge.first, crossing.share, crossing.point);
      offer(edge.second, 1 - crossing.share, crossing.point);
    }
    for (const auto& [v, crossing] : nearest)
    {
      m_points[v] = crossing.point;
      m_sides[v] = Side::ON_LINE;
    }
  }

  bool has(const Face& face, const Side side) const
  {
    return std::any_of(face.begin(), face.end(), [&](const std::size_t v) { return m_sides[v] == side; });
  }

  void cut(const Face& face)
  {
    if (!has(face, Side::OUTSIDE))
    {
      if (has(face, Side::INSIDE) || is_inside(CGAL::centroid(m_points[face[0]], m_points[face[1]], m_points[face[2]])))
        m_faces.push_back(face);
      return;
    }
    if (!has(face, Side::INSIDE))
      return;
    Face part;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t v = face[k], next = face[(k + 1) % 3];
      if (m_sides[v] != Side::OUTSIDE)
        part.push_back(v);
      if ((m_sides[v] == Side::INSIDE && m_sides[next] == Side::OUTSIDE) ||
          (m_sides[v] == Side::OUTSIDE && m_sides[next] == Side::INSIDE))
        part.push_back(vertex_on(v, next));
    }
    add(part);
  }

  std::size_t vertex_on(std::size_t in, std::size_t out)
  {
    if (m_sides[in] == Side::OUTSIDE)
      std::swap(in, out);
    const auto inserted = m_vertices.emplace(Edge(in, out), m_points.size());
    if (inserted.second)
      m_points.push_back(m_crossings.at(Edge(in, out)).point);
    return inserted.first->second;
  }

  // a triangle, or a quadrangle, which is divided along its shorter diagonal
  void add(const Face& part)
  {
    if (part.size() == 3)
    {
      m_faces.push_back(part);
      return;
    }
    const auto squared_length = [&](const std::size_t a, const std::size_t b)
    { return CGAL::squared_distance(m_points[part[a]], m_points[part[b]]); };
    const std::size_t k = squared_length(0, 2) <= squared_length(1, 3) ? 0 : 1;
    m_faces.push_back({part[k], part[k + 1], part[k + 2]});
    m_faces.push_back({part[k], part[k + 2], part[(k + 3) % 4]});
  }

  const Nearest_points& m_data;
  const double m_distance;
  std::vector<Point_3> m_points;
  std::vector<Side> m_sides; // of the vertices of the mesh
  std::map<Edge, Crossing> m_crossings;
  std::map<Edge, std::size_t> m_vertices; // at the crossings
  std::vector<Face> m_faces;
};

} // namespace

Soup trimmed(const Soup& mesh, const Nearest_points& points, const double distance)
{
  return Trimmer(mesh, points, distance).result();
}

} // namespace hde_remesh
