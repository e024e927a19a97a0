// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "solids.h"
#include "sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

// The faces around an edge, by their angles.
class Faces_around
{
public:
  Faces_around(const Soup& soup, const std::vector<Side>& sides, const std::vector<std::size_t>& of_edge)
    : m_soup(soup),
      m_sides(sides),
      m_low(sides[of_edge.front()].ends().first),
      m_high(sides[of_edge.front()].ends().second),
      m_axis(soup.points[m_high] - soup.points[m_low])
  {
    const Vector_3 x = direction(of_edge.front()), y = CGAL::cross_product(m_axis, x) / std::sqrt(m_axis.squared_length());
    for (const std::size_t i : of_edge)
    {
      const Vector_3 d = direction(i);
      const double angle = std::atan2(d * y, d * x);
      m_around.push_back({angle < -same_angle ? angle + 2 * CGAL_PI : angle, sides[i].source == m_high, i});
    }
    std::sort(m_around.begin(), m_around.end());
    for (std::size_t k = 1; k < m_around.size(); ++k) // where two solids touch, one ends before the other begins
      if (m_around[k].angle - m_around[k - 1].angle < same_angle)
        m_around[k].angle = m_around[k - 1].angle;
    std::sort(m_around.begin(), m_around.end());
  }

  // The sides in pairs, each of the two faces of a solid; none if the faces are not so. Around the edge, from its lower to its
  // higher end, a solid begins at a side that runs back, and ends at the next one that runs forth.
  std::vector<std::pair<std::size_t, std::size_t>> pairs_of_solids() const
  {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for (std::size_t k = 0; k < m_around.size(); ++k)
    {
      const Around& next = m_around[(k + 1) % m_around.size()];
      if (m_around[k].runs_back == next.runs_back)
        return {};
      if (m_around[k].runs_back)
        result.emplace_back(m_around[k].side, next.side);
    }
    return result;
  }

private:
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

  // from the edge into the face
  Vector_3 direction(const std::size_t side) const
  {
    const std::vector<std::size_t>& face = m_soup.faces[m_sides[side].face];
    const auto place = std::find(face.begin(), face.end(), m_sides[side].target) - face.begin();
    const Vector_3 to_third = m_soup.points[face[std::size_t(place + 1) % face.size()]] - m_soup.points[m_low];
    return to_third - (to_third * m_axis / m_axis.squared_length()) * m_axis;
  }

  const Soup& m_soup;
  const std::vector<Side>& m_sides;
  std::size_t m_low, m_high;
  Vector_3 m_axis;
  std::vector<Around> m_around;
};

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
      pairs = Faces_around(soup, sides, of_edge).pairs_of_solids();
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
