// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "walls.h"
#include "sides.h"

#include <cmath>
#include <limits>
#include <map>

namespace hde_remesh {

namespace {

constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

Vector_3 normal(const Soup& soup, const std::vector<std::size_t>& face) // of the length of twice the area
{
  Vector_3 sum(0, 0, 0);
  for (std::size_t k = 2; k < face.size(); ++k)
    sum =
        sum + CGAL::cross_product(soup.points[face[k - 1]] - soup.points[face[0]], soup.points[face[k]] - soup.points[face[0]]);
  return sum;
}

bool has_point_twice(std::vector<std::size_t> face)
{
  std::sort(face.begin(), face.end());
  return std::adjacent_find(face.begin(), face.end()) != face.end();
}

// from the least number on
std::vector<std::size_t> rotated(std::vector<std::size_t> face)
{
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

// For each face the one that has the same points the other way round, or `none`. Faces that are there more than twice have none.
std::vector<std::size_t> reverse_faces(const Soup& soup)
{
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
    if (!has_point_twice(soup.faces[f]))
      faces[rotated(soup.faces[f])].push_back(f);
  std::vector<std::size_t> result(soup.faces.size(), none);
  for (const auto& [face, numbers] : faces)
  {
    const auto other = faces.find(rotated(std::vector<std::size_t>(face.rbegin(), face.rend())));
    if (numbers.size() == 1 && other != faces.end() && other->second.size() == 1)
      result[numbers.front()] = other->second.front();
  }
  return result;
}

void remove_faces(Soup& soup, const std::vector<char>& is_removed)
{
  std::vector<std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
    if (!is_removed[f])
      faces.push_back(std::move(soup.faces[f]));
  soup.faces = std::move(faces);
}

// Double faces that hang together are a wall if two other faces follow each of its edges, one each way.
class Double_walls
{
public:
  explicit Double_walls(Soup& soup)
    : m_soup(soup),
      m_reverse(reverse_faces(soup)),
      m_sides(sides_of(soup)),
      m_walls(soup.faces.size()),
      m_is_no_wall(soup.faces.size(), 0),
      m_has_others(soup.faces.size(), 0)
  {
  }

  std::size_t remove()
  {
    for_each_edge(m_sides, [this](const std::vector<std::size_t>& of_edge) { join_double_faces(of_edge); });
    for_each_edge(m_sides, [this](const std::vector<std::size_t>& of_edge) { look_at_others(of_edge); });
    std::vector<char> is_removed(m_soup.faces.size(), 0);
    for (std::size_t f = 0; f < m_soup.faces.size(); ++f) // without others it is a solid of no thickness
      is_removed[f] = m_reverse[f] != none && !m_is_no_wall[m_walls.root(f)] && m_has_others[m_walls.root(f)];
    remove_faces(m_soup, is_removed);
    return static_cast<std::size_t>(std::count(is_removed.begin(), is_removed.end(), 1));
  }

private:
  bool is_double(const std::size_t side) const { return m_reverse[m_sides[side].face] != none; }

  void join_double_faces(const std::vector<std::size_t>& of_edge)
  {
    std::size_t first = none;
    for (const std::size_t i : of_edge)
      if (is_double(i))
      {
        first = (std::min)(first, i);
        m_walls.join(m_sides[first].face, m_sides[i].face);
      }
  }

  void look_at_others(const std::vector<std::size_t>& of_edge)
  {
    std::size_t forth = 0, back = 0;
    for (const std::size_t i : of_edge)
      if (!is_double(i))
        ++(m_sides[i].source < m_sides[i].target ? forth : back);
    const std::size_t number_of_double = of_edge.size() - forth - back;
    const bool is_inside = forth == 0 && back == 0 && number_of_double > 2, has_two_others = forth == 1 && back == 1;
    for (const std::size_t i : of_edge)
      if (is_double(i))
      {
        const std::size_t wall = m_walls.root(m_sides[i].face);
        m_is_no_wall[wall] = m_is_no_wall[wall] || !(is_inside || has_two_others);
        m_has_others[wall] = m_has_others[wall] || has_two_others;
      }
  }

  Soup& m_soup;
  std::vector<std::size_t> m_reverse;
  std::vector<Side> m_sides;
  Sets m_walls;
  std::vector<char> m_is_no_wall, m_has_others; // by the root of a wall
};

// Patches are faces that hang together over edges of two faces. A wall is the smallest of three that meet in its edges; without it
// the other two are one surface there.
class Single_walls
{
public:
  explicit Single_walls(Soup& soup) : m_soup(soup), m_sides(sides_of(soup)), m_patches(soup.faces.size()) {}

  std::size_t remove()
  {
    std::vector<std::vector<std::size_t>> edges_of_three;
    for_each_edge(m_sides,
                  [&](const std::vector<std::size_t>& of_edge)
                  {
                    if (of_edge.size() == 2)
                      m_patches.join(m_sides[of_edge[0]].face, m_sides[of_edge[1]].face);
                    else if (of_edge.size() == 3)
                      edges_of_three.push_back(of_edge);
                  });
    find_candidates();
    for (const std::vector<std::size_t>& edge : edges_of_three)
      compare(edge);
    std::vector<char> is_removed(m_soup.faces.size(), 0);
    for (std::size_t f = 0; f < m_soup.faces.size(); ++f)
      is_removed[f] = m_is_wall[m_patches.root(f)] == 2;
    remove_faces(m_soup, is_removed);
    return static_cast<std::size_t>(std::count(is_removed.begin(), is_removed.end(), 1));
  }

private:
  // all edges are those of two faces of the patch, or of three of different patches, of which there is one at least
  void find_candidates()
  {
    m_is_wall.assign(m_soup.faces.size(), 1);
    m_areas.assign(m_soup.faces.size(), 0.);
    for (std::size_t f = 0; f < m_soup.faces.size(); ++f)
      m_areas[m_patches.root(f)] += std::sqrt(normal(m_soup, m_soup.faces[f]).squared_length());
    for_each_edge(m_sides,
                  [&](const std::vector<std::size_t>& of_edge)
                  {
                    if (of_edge.size() != 2 && !is_of_three_patches(of_edge))
                      for (const std::size_t i : of_edge)
                        m_is_wall[patch(i)] = 0;
                  });
  }

  bool is_of_three_patches(const std::vector<std::size_t>& of_edge)
  {
    return of_edge.size() == 3 && patch(of_edge[0]) != patch(of_edge[1]) && patch(of_edge[1]) != patch(of_edge[2]) &&
           patch(of_edge[2]) != patch(of_edge[0]);
  }

  std::size_t patch(const std::size_t side) { return m_patches.root(m_sides[side].face); }

  // at an edge one of three patches may go
  void compare(const std::vector<std::size_t>& edge)
  {
    std::size_t least = none;
    for (const std::size_t i : edge)
      if (m_is_wall[patch(i)] && (least == none || m_areas[patch(i)] < m_areas[patch(least)]))
        least = i;
    for (const std::size_t i : edge)
      if (i != least)
        m_is_wall[patch(i)] = 0;
      else
        m_is_wall[patch(i)] = 2;
  }

  Soup& m_soup;
  std::vector<Side> m_sides;
  Sets m_patches;
  std::vector<char> m_is_wall; // by the root of a patch: 2 if it goes
  std::vector<double> m_areas; // twice
};

// The sides of an edge in pairs, each of the two faces of a solid; none if the faces are not so. Around the edge, seen against its
// direction from the lower to the higher end, a solid begins at a side that runs back, and ends at the next one that runs forth.
std::vector<std::pair<std::size_t, std::size_t>> pairs_of_solids(const Soup& soup, const std::vector<Side>& sides,
                                                                 const std::vector<std::size_t>& of_edge)
{
  static constexpr double same_angle = 1e-7;
  struct Around
  {
    double angle;
    bool runs_back;
    std::size_t side;
    bool operator<(const Around& other) const
    {
      return std::tie(angle, runs_back, side) < std::tie(other.angle, other.runs_back, other.side);
    }
  };
  const std::size_t low = sides[of_edge.front()].ends().first, high = sides[of_edge.front()].ends().second;
  const Vector_3 axis = soup.points[high] - soup.points[low];
  const auto direction = [&](const std::size_t i)
  {
    const std::vector<std::size_t>& face = soup.faces[sides[i].face];
    const auto place = std::find(face.begin(), face.end(), sides[i].target) - face.begin();
    const Vector_3 to_third = soup.points[face[std::size_t(place + 1) % face.size()]] - soup.points[low];
    return to_third - (to_third * axis / axis.squared_length()) * axis;
  };
  const Vector_3 x = direction(of_edge.front()), y = CGAL::cross_product(axis, x) / std::sqrt(axis.squared_length());
  std::vector<Around> around;
  for (const std::size_t i : of_edge)
  {
    const Vector_3 d = direction(i);
    double angle = std::atan2(d * y, d * x);
    if (angle < -same_angle)
      angle += 2 * CGAL_PI;
    around.push_back({angle, sides[i].source == high, i});
  }
  std::sort(around.begin(), around.end());
  for (std::size_t k = 1; k < around.size(); ++k) // where two solids touch, one ends before the other begins
    if (around[k].angle - around[k - 1].angle < same_angle)
      around[k].angle = around[k - 1].angle;
  std::sort(around.begin(), around.end());
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t k = 0; k < around.size(); ++k)
  {
    const Around& next = around[(k + 1) % around.size()];
    if (around[k].runs_back == next.runs_back)
      return {};
    if (around[k].runs_back)
      result.emplace_back(around[k].side, next.side);
  }
  return result;
}

bool has_edges_of_many_faces(const Soup& soup)
{
  bool result = false;
  for_each_edge(sides_of(soup), [&](const std::vector<std::size_t>& of_edge) { result = result || of_edge.size() > 2; });
  return result;
}

// Corners that are joined have one point, and no others have it. Returns how many points are new.
std::size_t give_points_to_fans(Soup& soup, const std::vector<Side>& sides, Sets& corners)
{
  const std::size_t number_of_points = soup.points.size();
  std::vector<std::size_t> of_fan(sides.size(), none); // by the root of its corners
  std::vector<char> is_taken(number_of_points, 0);
  for (std::vector<std::size_t>& face : soup.faces)
    face.clear();
  for (const Side& side : sides)
  {
    std::size_t& point = of_fan[corners.root(side.corner)];
    if (point == none && !is_taken[side.source])
    {
      point = side.source;
      is_taken[side.source] = 1;
    }
    else if (point == none)
    {
      point = soup.points.size();
      soup.points.push_back(Point_3(soup.points[side.source]));
    }
    soup.faces[side.face].push_back(point);
  }
  return soup.points.size() - number_of_points;
}

} // namespace

std::size_t remove_double_walls(Soup& soup) { return has_edges_of_many_faces(soup) ? Double_walls(soup).remove() : 0; }

std::size_t remove_single_walls(Soup& soup) { return has_edges_of_many_faces(soup) ? Single_walls(soup).remove() : 0; }

std::size_t separate_solids(Soup& soup)
{
  const std::vector<Side> sides = sides_of(soup);
  Sets corners(sides.size());
  bool has_solids = false;
  const auto join = [&](const Side& a, const Side& b)
  {
    const bool is_reversed = a.source == b.target;
    corners.join(a.corner, is_reversed ? b.next_corner : b.corner);
    corners.join(a.next_corner, is_reversed ? b.corner : b.next_corner);
  };
  const auto join_faces = [&](const std::vector<std::size_t>& of_edge)
  {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    if (of_edge.size() > 2)
      pairs = pairs_of_solids(soup, sides, of_edge);
    has_solids = has_solids || !pairs.empty();
    for (const auto& pair : pairs)
      join(sides[pair.first], sides[pair.second]);
    if (pairs.empty())
      for (const std::size_t i : of_edge)
        join(sides[of_edge.front()], sides[i]);
  };
  for_each_edge(sides, join_faces);
  return has_solids ? give_points_to_fans(soup, sides, corners) : 0;
}

} // namespace hde_remesh
