// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SURFACE_SAMPLE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SURFACE_SAMPLE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The map from the coordinates of the caller to those in which the function is built. There the box about the points is centred
// at the origin, and its diagonal is in [1/2, 1). So neither a large nor a small unit nor a far origin harms. The scale is a
// power of two: it rounds nothing.
struct Normalization
{
  Vector centre = Vector::Zero();
  double scale = 1;

  Vector operator()(const Vector& p) const { return (p - centre) * scale; }
};

// normalises the points
inline Normalization normalize(std::vector<Vector>& points)
{
  Normalization result;
  if (points.empty())
    return result;
  Vector low = points.front(), high = low;
  for (const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  result.centre = low + 0.5 * (high - low);
  int exponent = 0;
  std::frexp((high - low).stableNorm(), &exponent);
  result.scale = std::ldexp(1., (std::min)(-exponent, 1020)); // finite for the smallest of boxes
  for (Vector& p : points)
    p = result(p);
  return result;
}

// what a point says of the surface
enum class Datum : char
{
  EXACT,       // the surface passes through it
  APPROXIMATE, // it passes near it
  NONE         // nothing: it is a vertex for which points on its facets stand
};

// What the implicit function is built from: points of the surface, normalised, their unit normals, and the distances to their
// neighbours. If they are the vertices of a mesh, there are also the facets between them, and points on facets may follow behind.
struct Surface_sample
{
  Normalization normalization;
  std::vector<Vector> points;
  std::vector<Vector> normals; // zero if unknown: the point has no off-surface points
  std::vector<double> spacings;
  std::vector<Datum> data;      // what the points say; empty: all are exact
  std::vector<char> is_on_edge; // whether it has no off-surface points, as its sides look in different directions; empty: none
  std::vector<Facet> facets;
  bool is_of_points = false; // it is that of points without facets
  std::size_t number_of_isolated_vertices = 0;
  std::size_t number_of_duplicate_points = 0;
  std::size_t number_of_outliers = 0;      // removed
  std::size_t number_of_wrong_normals = 0; // turned or dropped
  std::size_t number_of_points_on_facets = 0;
  std::vector<std::size_t> rim;       // points at holes
  std::vector<std::size_t> open_ends; // the same and points at edges where the surface might end, too
  std::size_t number_of_holes = 0, number_of_open_ends = 0;

  std::size_t size() const { return points.size(); }

  // behind all others; its spacing is not known yet
  void add_point_on_facet(const Vector& point, const Vector& normal, const bool lies_on_edge, const Datum datum = Datum::EXACT)
  {
    if (datum != Datum::EXACT)
      data.resize(points.size(), Datum::EXACT);
    points.push_back(point);
    normals.push_back(normal);
    spacings.push_back(0);
    if (!is_on_edge.empty())
      is_on_edge.push_back(lies_on_edge);
    if (!data.empty() || datum != Datum::EXACT)
      data.push_back(datum);
    ++number_of_points_on_facets;
  }

  Datum datum(const std::size_t i) const { return data.empty() ? Datum::EXACT : data[i]; }

  // The unit in which the influence of a point on its surroundings is measured. Approximate points are dense, and average over
  // those around them already: so they need less overlap.
  double reach(const std::size_t i) const { return datum(i) == Datum::APPROXIMATE ? 0.5 * spacings[i] : spacings[i]; }

  bool is_on_edge_of_surface(const std::size_t i) const { return !is_on_edge.empty() && is_on_edge[i] != 0; }

  // whether it has off-surface points
  bool has_side(const std::size_t i) const { return !normals[i].isZero(0) && !is_on_edge_of_surface(i); }
};

// that of the box; normalised points are centred
inline double half_diagonal(const Surface_sample& sample)
{
  Vector half_box = Vector::Zero();
  for (const Vector& p : sample.points)
    half_box = half_box.cwiseMax(p.cwiseAbs());
  return half_box.norm();
}

inline double median_spacing(const Surface_sample& sample)
{
  std::vector<double> spacings = sample.spacings;
  if (spacings.empty())
    return 0;
  const auto middle = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

// A point stands for about the square of its spacing. Outliers shall not count for much.
inline double area(const Surface_sample& sample)
{
  static constexpr double largest_spacing = 10; // medians
  const double largest = largest_spacing * median_spacing(sample);
  double result = 0;
  for (const double spacing : sample.spacings)
    result += std::pow((std::min)(spacing, largest), 2);
  return result;
}

inline std::size_t memory_bytes_of(const Surface_sample& sample)
{
  return sample.size() * (2 * sizeof(Vector) + sizeof(double)) + sample.facets.size() * sizeof(Facet) +
         sample.data.size() * sizeof(Datum);
}

// Equal points would make the system of their patch singular. The first of them stays, with the mean of their normals. Where
// the normals cancel, the mean is zero, and the point has no off-surface point.
inline void merge_duplicate_points(Surface_sample& sample)
{
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](const std::size_t i)
  { return std::make_tuple(sample.points[i][0], sample.points[i][1], sample.points[i][2]); };
  std::sort(order.begin(), order.end(),
            [&](const std::size_t i, const std::size_t j) { return std::make_pair(key(i), i) < std::make_pair(key(j), j); });
  std::vector<char> is_kept(sample.size(), 1);
  // by old index: the point that stands for it, and the new index of that point
  std::vector<std::size_t> kept(sample.size()), new_index(sample.size());
  std::iota(kept.begin(), kept.end(), std::size_t(0));
  for (std::size_t k = 0, first = 0; k < order.size(); ++k)
  {
    if (key(order[k]) != key(order[first]))
      first = k;
    if (k == first)
      continue;
    is_kept[order[k]] = 0;
    kept[order[k]] = order[first];
    sample.normals[order[first]] += sample.normals[order[k]];
    sample.spacings[order[first]] = (std::min)(sample.spacings[order[first]], sample.spacings[order[k]]);
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < is_kept.size(); ++i)
    if (is_kept[i])
    {
      new_index[i] = next;
      const double length = sample.normals[i].norm();
      sample.points[next] = sample.points[i];
      sample.normals[next] = length > 1e-6 ? Vector(sample.normals[i] / length) : Vector(Vector::Zero());
      sample.spacings[next++] = sample.spacings[i];
    }
  sample.number_of_duplicate_points = sample.size() - next;
  for (Facet& facet : sample.facets)
    for (std::size_t& i : facet)
      i = new_index[kept[i]];
  sample.points.resize(next);
  sample.normals.resize(next);
  sample.spacings.resize(next);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_SURFACE_SAMPLE_H
