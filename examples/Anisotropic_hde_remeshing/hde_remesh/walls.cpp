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

bool has_edges_of_many_faces(const Soup& soup)
{
  bool result = false;
  for_each_edge(sides_of(soup), [&](const std::vector<std::size_t>& of_edge) { result = result || of_edge.size() > 2; });
  return result;
}

} // namespace

std::size_t remove_double_walls(Soup& soup) { return has_edges_of_many_faces(soup) ? Double_walls(soup).remove() : 0; }

std::size_t remove_single_walls(Soup& soup) { return has_edges_of_many_faces(soup) ? Single_walls(soup).remove() : 0; }

} // namespace hde_remesh
