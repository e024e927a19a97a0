// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_HOLE_RIMS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_HOLE_RIMS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Tangent_frame.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_search.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the direction in the tangent plane in the middle of the widest sector without a neighbour; zero if it is narrower than
// `least_gap`
inline Vector direction_of_gap(const Vector& normal, const std::vector<Vector>& ways, const double least_gap)
{
  const Tangent_frame frame = tangent_frame(normal);
  std::vector<double> angles;
  for (const Vector& way : ways)
    angles.push_back(std::atan2(frame.col(1).dot(way), frame.col(0).dot(way)));
  if (angles.empty())
    return Vector::Zero();
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2 * CGAL_PI - angles.back(), middle = angles.back() + widest / 2;
  for (std::size_t k = 1; k < angles.size(); ++k)
    if (angles[k] - angles[k - 1] > widest)
    {
      widest = angles[k] - angles[k - 1];
      middle = angles[k - 1] + widest / 2;
    }
  return widest < least_gap ? Vector(Vector::Zero())
                            : Vector(std::cos(middle) * frame.col(0) + std::sin(middle) * frame.col(1));
}

// Finds where the data of a sample end. A point is on the rim of a hole if a ball beside it, about a place in its tangent
// plane, is empty, and so are the balls that are tilted up and down from there: at a sharp edge one of these meets the other
// side. Nor is there a point nearby that looks the other way, as at the edge of a blade. A hole is a group of such points that
// is wider than a few spacings, or than a quarter of the sample. So gaps between points that are a few spacings wide are none.
class Hole_rims
{
  static constexpr double distance_of_ball = 3.5, radius_of_ball = 2.5; // in units of the spacing
  static constexpr std::array<double, 5> tilts = {0, CGAL_PI / 6, -CGAL_PI / 6, CGAL_PI / 3, -CGAL_PI / 3};
  static constexpr double reach_of_balls = 2 * distance_of_ball, reach_of_points = 2, least_width = 4; // in the same units
  static constexpr double least_share = 0.25;            // of the diagonal of the box
  static constexpr unsigned int number_of_neighbors = 8; // on the rim

public:
  // a point, where its neighbours are missing, and the spacing there
  struct Candidate
  {
    std::size_t point;
    Vector out;
    double spacing;
  };

  // the widest empty sector of the six nearest neighbours, where a ball fits in
  static constexpr double least_gap = 140 * CGAL_PI / 180;

  // `clearance` is the distance from a place to the data, `is_at_blade` tells whether a point has neighbours that look the
  // other way. Writes the rims to the sample.
  template <typename ConcurrencyTag, typename Clearance, typename Is_at_blade>
  static void find(const ConcurrencyTag, Surface_sample& sample, const std::vector<Candidate>& candidates,
                   const Clearance& clearance, const Is_at_blade& is_at_blade, Interruption& interruption)
  {
    std::vector<char> is_flat(candidates.size(), 0), is_tilted(candidates.size(), 0);
    parallel_for<ConcurrencyTag>(
        candidates.size(),
        [&](const std::size_t k)
        {
          const auto is_empty = [&](const double tilt) { return is_ball_empty(sample, candidates[k], tilt, clearance); };
          is_flat[k] = is_empty(tilts[0]);
          is_tilted[k] =
              is_flat[k] && std::all_of(tilts.begin() + 1, tilts.end(), is_empty) && !is_at_blade(candidates[k].point);
        },
        256, interruption);
    interruption.check();
    sample.number_of_holes = add_wide_groups(sample, chosen(candidates, is_tilted), sample.rim);
    sample.number_of_open_ends = add_wide_groups(sample, chosen(candidates, is_flat), sample.open_ends);
  }

private:
  template <typename Clearance>
  static bool is_ball_empty(const Surface_sample& sample, const Candidate& candidate, const double tilt,
                            const Clearance& clearance)
  {
    const Vector direction = std::cos(tilt) * candidate.out + std::sin(tilt) * sample.normals[candidate.point];
    return clearance(sample.points[candidate.point] + distance_of_ball * candidate.spacing * direction) >
           radius_of_ball * candidate.spacing;
  }

  static Vector centre_of_ball(const Surface_sample& sample, const Candidate& candidate)
  {
    return sample.points[candidate.point] + distance_of_ball * candidate.spacing * candidate.out;
  }

  static std::vector<Candidate> chosen(const std::vector<Candidate>& candidates, const std::vector<char>& is_chosen)
  {
    std::vector<Candidate> result;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (is_chosen[k])
        result.push_back(candidates[k]);
    return result;
  }

  // Adds the points of groups that are not small, and returns the number of these groups. Two points are of one if their balls
  // overlap, or if they are next to each other, as at a corner.
  static std::size_t add_wide_groups(const Surface_sample& sample, const std::vector<Candidate>& rim,
                                     std::vector<std::size_t>& points)
  {
    struct Group
    {
      Vector low, high;
      double spacings = 0, number = 0;
    };
    if (rim.empty())
      return 0;
    std::vector<Vector> places, centres;
    for (const Candidate& candidate : rim)
    {
      places.push_back(sample.points[candidate.point]);
      centres.push_back(centre_of_ball(sample, candidate));
    }
    Disjoint_sets sets(rim.size());
    const auto unite = [&](const std::vector<Vector>& neighbors, const double reach)
    {
      const Point_search search(neighbors);
      for (std::size_t k = 0; k < rim.size(); ++k)
        for (const auto& [squared_distance, l] : search.nearest(neighbors[k], number_of_neighbors))
          if (std::sqrt(squared_distance) <= reach * (std::max)(rim[k].spacing, rim[l].spacing))
            sets.union_set(k, l);
    };
    unite(centres, reach_of_balls);
    unite(places, reach_of_points);
    std::map<std::size_t, Group> groups;
    for (std::size_t k = 0; k < rim.size(); ++k)
    {
      const Vector& p = places[k];
      Group& group = groups.emplace(sets.find_set(k), Group{p, p}).first->second;
      group.low = group.low.cwiseMin(p);
      group.high = group.high.cwiseMax(p);
      group.spacings += rim[k].spacing;
      ++group.number;
    }
    const double share = least_share * 2 * half_diagonal(sample);
    const auto is_wide = [&](const Group& group)
    {
      const double width = (group.high - group.low).norm();
      return width > least_width * group.spacings / group.number || width > share;
    };
    for (std::size_t k = 0; k < rim.size(); ++k)
      if (is_wide(groups.at(sets.find_set(k))))
        points.push_back(rim[k].point);
    return std::size_t(std::count_if(groups.begin(), groups.end(), [&](const auto& group) { return is_wide(group.second); }));
  }
};

// of a range of points, whose neighbours are known to be on one side by `directions`, zero for most of them
template <typename ConcurrencyTag>
void find_rims_of_points(Surface_sample& sample, const std::vector<Vector>& directions, const Point_search& search,
                         Interruption& interruption)
{
  static constexpr unsigned int number_of_neighbors = 24; // three spacings
  static constexpr double share_of_mean = 0.9;            // of the spacings around
  std::vector<Hole_rims::Candidate> candidates;
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (!directions[i].isZero(0))
      candidates.push_back({i, directions[i], sample.spacings[i]});
  // Random points come in clusters, and what is wide for the spacing in a cluster is no hole among the points around it. Those are
  // partly at the rim themselves, where spacings are larger, as neighbours are on one side only.
  parallel_for<ConcurrencyTag>(
      candidates.size(),
      [&](const std::size_t k)
      {
        double sum = 0;
        const auto neighbors = search.nearest(sample.points[candidates[k].point], number_of_neighbors);
        for (const auto& neighbor : neighbors)
          sum += sample.spacings[neighbor.second];
        candidates[k].spacing = (std::max)(candidates[k].spacing, share_of_mean * sum / double(neighbors.size()));
      },
      256, interruption);
  interruption.check();
  const auto is_at_blade = [&](const std::size_t i)
  {
    const auto neighbors = search.nearest(sample.points[i], number_of_neighbors);
    return std::any_of(neighbors.begin(), neighbors.end(),
                       [&](const auto& neighbor) { return sample.normals[neighbor.second].dot(sample.normals[i]) < -0.2; });
  };
  Hole_rims::find(
      ConcurrencyTag(), sample, candidates, [&](const Vector& p) { return std::sqrt(search.nearest(p, 1).front().first); },
      is_at_blade, interruption);
}

// of a mesh: the ends of edges at one facet only
template <typename ConcurrencyTag>
void find_rims_of_mesh(Surface_sample& sample, Interruption& interruption)
{
  typedef std::pair<std::pair<std::size_t, std::size_t>, std::size_t>
      Side; // an edge, and three times the facet plus its number there
  std::vector<Side> sides;
  sides.reserve(3 * sample.facets.size());
  for (std::size_t f = 0; f < sample.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      sides.emplace_back(std::minmax(sample.facets[f][k], sample.facets[f][(k + 1) % 3]), 3 * f + k);
  parallel_sort<ConcurrencyTag>(sides);
  std::map<std::size_t, Vector> directions;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    if ((s > 0 && sides[s - 1].first == sides[s].first) || (s + 1 < sides.size() && sides[s + 1].first == sides[s].first))
      continue;
    const Facet& facet = sample.facets[sides[s].second / 3];
    const std::size_t k = sides[s].second % 3;
    const Vector &p = sample.points[facet[k]], along = sample.points[facet[(k + 1) % 3]] - p,
                 out = along.cross(along.cross(sample.points[facet[(k + 2) % 3]] - p));
    for (const std::size_t i : {sides[s].first.first, sides[s].first.second})
      directions.emplace(i, Vector::Zero()).first->second += out.norm() > 0 ? Vector(out.normalized()) : Vector(Vector::Zero());
  }
  std::vector<Hole_rims::Candidate> candidates;
  for (const auto& [i, direction] : directions)
    if (direction.norm() > 0)
      candidates.push_back({i, direction.normalized(), sample.spacings[i]});
  if (candidates.empty())
    return;
  const Closest_facet closest(sample.points, sample.facets);
  if (closest.empty())
    return;
  Hole_rims::find(
      ConcurrencyTag(), sample, candidates, [&](const Vector& p) { return (closest(p).point - p).norm(); },
      [](std::size_t) { return false; }, interruption);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_HOLE_RIMS_H
