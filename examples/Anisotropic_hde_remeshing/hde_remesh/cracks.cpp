// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "cracks.h"
#include "rounding.h"
#include "sides.h"

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hde_remesh {

namespace {

// two boundary edges that would be one
struct Match
{
  double distance; // of their ends
  std::size_t first, second;
  bool is_reversed;

  bool operator<(const Match& other) const
  {
    return std::tie(distance, first, second) < std::tie(other.distance, other.first, other.second);
  }
};

class Crack_closer
{
public:
  Crack_closer(const Soup& soup, const double tolerance, const Orientation orientation)
    : m_soup(soup),
      m_tolerance((std::max)(tolerance, rounding_of_doubles(soup.points))), // cells have numbers
      m_orientation(orientation),
      m_sides(sides_of(soup)),
      m_sets(soup.points.size())
  {
    find_boundary();
    find_matches();
    join_ends();
    while (drop_what_is_worse())
      join_ends();
  }

  std::size_t number_of_boundary_sides() const { return m_boundary.size(); }
  std::size_t number_of_closed_sides() const { return 2 * m_matches.size(); }

  double width() const
  {
    double result = 0;
    for (const Match& match : m_matches)
      result = (std::max)(result, match.distance);
    return result;
  }

  // into `soup`, the one that was given
  std::size_t apply(Soup& soup)
  {
    std::vector<std::size_t> numbers(soup.points.size());
    std::vector<Point_3> points;
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      if (m_sets.root(v) == v)
      {
        numbers[v] = points.size();
        points.push_back(soup.points[v]);
      }
    for (std::vector<std::size_t>& face : soup.faces)
      for (std::size_t& v : face)
        v = numbers[m_sets.root(v)];
    const std::size_t number = soup.points.size() - points.size();
    soup.points = std::move(points);
    return number;
  }

private:
  typedef std::array<std::int64_t, 3> Cell;

  void find_boundary()
  {
    for_each_edge(m_sides,
                  [this](const std::vector<std::size_t>& sides)
                  {
                    if (sides.size() == 1)
                      m_boundary.push_back(sides.front());
                  });
    std::sort(m_boundary.begin(), m_boundary.end());
  }

  double distance(const std::size_t a, const std::size_t b) const
  {
    return std::sqrt(CGAL::squared_distance(m_soup.points[a], m_soup.points[b]));
  }

  // of the middle of a side, on a grid whose cells are as wide as the tolerance
  Cell cell(const Side& side) const
  {
    const Point_3 middle = CGAL::midpoint(m_soup.points[side.source], m_soup.points[side.target]);
    Cell result;
    for (int i = 0; i < 3; ++i)
    {
      const double place = std::floor(middle[i] / m_tolerance);
      result[std::size_t(i)] = std::abs(place) < 4e18 ? static_cast<std::int64_t>(place) : 0;
    }
    return result;
  }

  // The middles of sides that match are no further apart than their ends. Each side takes the nearest that is left.
  void find_matches()
  {
    std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> cells;
    std::vector<Match> candidates;
    for (const std::size_t i : m_boundary)
    {
      if (!(m_tolerance > 0) || distance(m_sides[i].source, m_sides[i].target) <= m_tolerance)
        continue; // all of it would be one point
      const Cell middle = cell(m_sides[i]);
      for (std::int64_t x = -1; x <= 1; ++x)
        for (std::int64_t y = -1; y <= 1; ++y)
          for (std::int64_t z = -1; z <= 1; ++z)
          {
            const auto found = cells.find({middle[0] + x, middle[1] + y, middle[2] + z});
            if (found != cells.end())
              for (const std::size_t j : found->second)
                add_candidates(j, i, candidates);
          }
      cells[middle].push_back(i);
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<char> is_matched(m_sides.size(), 0);
    for (const Match& match : candidates)
      if (!is_matched[match.first] && !is_matched[match.second])
      {
        is_matched[match.first] = is_matched[match.second] = 1;
        m_matches.push_back(match);
      }
  }

  void add_candidates(const std::size_t i, const std::size_t j, std::vector<Match>& candidates) const
  {
    const Side &a = m_sides[i], &b = m_sides[j];
    if (a.face == b.face)
      return;
    const double reversed = (std::max)(distance(a.source, b.target), distance(a.target, b.source));
    if (reversed <= m_tolerance)
      candidates.push_back({reversed, i, j, true});
    const double alike = (std::max)(distance(a.source, b.source), distance(a.target, b.target));
    if (m_orientation == Orientation::ANY && alike <= m_tolerance)
      candidates.push_back({alike, i, j, false});
  }

  void join_ends()
  {
    m_sets = Sets(m_soup.points.size());
    for (const Match& match : m_matches)
    {
      const Side &a = m_sides[match.first], &b = m_sides[match.second];
      m_sets.join(a.source, match.is_reversed ? b.target : b.source);
      m_sets.join(a.target, match.is_reversed ? b.source : b.target);
    }
  }

  // Drops the matches at points that must not be joined. Whether there are such.
  bool drop_what_is_worse()
  {
    m_is_bad.assign(m_soup.points.size(), 0);
    find_lost_corners();
    find_edges_of_many_faces();
    find_touching_sheets();
    const auto is_bad = [this](const Match& match)
    {
      const Side& a = m_sides[match.first];
      return m_is_bad[m_sets.root(a.source)] || m_is_bad[m_sets.root(a.target)];
    };
    const auto end = std::remove_if(m_matches.begin(), m_matches.end(), is_bad);
    const bool has_some = end != m_matches.end();
    m_matches.erase(end, m_matches.end());
    return has_some;
  }

  // faces with a corner twice that were none before
  void find_lost_corners()
  {
    for (const Side& side : m_sides)
      if (side.source != side.target && m_sets.root(side.source) == m_sets.root(side.target))
        m_is_bad[m_sets.root(side.source)] = 1;
  }

  // edges with more than two faces, or with two that are not oriented alike, of sides that were not one edge before
  void find_edges_of_many_faces()
  {
    const auto ends = [this](const Side& side) {
      return std::pair<std::size_t, std::size_t>(std::minmax({m_sets.root(side.source), m_sets.root(side.target)}));
    };
    const auto look = [&](const std::vector<std::size_t>& sides)
    {
      const Side& first = m_sides[sides.front()];
      const bool was_one =
          std::all_of(sides.begin(), sides.end(), [&](const std::size_t i) { return m_sides[i].ends() == first.ends(); });
      const bool has_same_direction = sides.size() == 2 && m_orientation == Orientation::OPPOSITE &&
                                      m_sets.root(first.source) == m_sets.root(m_sides[sides.back()].source);
      if (!was_one && (sides.size() > 2 || has_same_direction))
        m_is_bad[ends(first).first] = m_is_bad[ends(first).second] = 1;
    };
    for_each_edge(m_sides, ends, look);
  }

  // The number of fans of faces around each point, by sets of corners. After joining it is that of the root.
  std::vector<std::size_t> numbers_of_fans(Sets& points)
  {
    Sets corners(m_sides.size());
    const auto at = [](const Side& side, Sets& sets, const std::size_t point)
    { return sets.root(side.source) == point ? side.corner : side.next_corner; };
    const auto ends = [&points](const Side& side) {
      return std::pair<std::size_t, std::size_t>(std::minmax({points.root(side.source), points.root(side.target)}));
    };
    for_each_edge(m_sides, ends,
                  [&](const std::vector<std::size_t>& sides)
                  {
                    const auto [low, high] = ends(m_sides[sides.front()]);
                    for (const std::size_t i : sides)
                      for (const std::size_t point : {low, high})
                        corners.join(at(m_sides[i], points, point), at(m_sides[sides.front()], points, point));
                  });
    std::vector<std::size_t> result(m_soup.points.size(), 0);
    for (const Side& side : m_sides) // each corner begins one
      result[points.root(side.source)] += corners.root(side.corner) == side.corner ? 1 : 0;
    return result;
  }

  // points with more fans of faces than any of those that they are made of
  void find_touching_sheets()
  {
    Sets single(m_soup.points.size());
    const std::vector<std::size_t> before = numbers_of_fans(single), after = numbers_of_fans(m_sets);
    std::vector<std::size_t> most(before.size(), 1);
    for (std::size_t v = 0; v < before.size(); ++v)
      most[m_sets.root(v)] = (std::max)(most[m_sets.root(v)], before[v]);
    for (std::size_t v = 0; v < before.size(); ++v)
      if (after[v] > most[v])
        m_is_bad[v] = 1;
  }

  const Soup& m_soup;
  double m_tolerance;
  Orientation m_orientation;
  std::vector<Side> m_sides;
  std::vector<std::size_t> m_boundary; // sides without another one
  std::vector<Match> m_matches;
  Sets m_sets; // of points that are one
  std::vector<char> m_is_bad;
};

} // namespace

std::size_t close_cracks(Soup& soup, const double tolerance, const Orientation orientation)
{
  Crack_closer closer(soup, tolerance, orientation);
  return closer.number_of_closed_sides() > 0 ? closer.apply(soup) : 0;
}

std::optional<double> width_of_cracks(const Soup& soup, const double tolerance)
{
  const Crack_closer closer(soup, tolerance, Orientation::OPPOSITE);
  if (closer.number_of_closed_sides() == 0 || closer.number_of_closed_sides() < closer.number_of_boundary_sides())
    return std::nullopt;
  return closer.width();
}

} // namespace hde_remesh
