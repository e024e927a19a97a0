// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_REFERENCE_SAMPLES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_REFERENCE_SAMPLES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A point of the reference surface with the area that it stands for.
struct Reference_sample
{
  Vector point;
  Eigen::Vector3f normal; // a unit vector
  float area;             // over the area of the surface
  float reach;            // how far its plane stands for the surface
  std::uint32_t start;    // a point of the surface nearby: an index of `points`
};

// Samples of facets. Each facet is cut at its longest edge until the parts are short and small enough. Each part has a sample in
// its centroid, each corner of the facets has one, too. On a facet that is not cut, the weights 3/4 and 1/12 integrate the square
// of a linear function exactly.
class Reference_samples
{
  static constexpr double weight_of_corner = 1. / 12;
  static constexpr int largest_depth = 16;      // of cuts of a facet
  static constexpr double share_of_reach = 0.7; // of the longest edge of its part
  static constexpr double longest_part = 3;     // over the root of its area
  // of the corners of a facet: a large facet beside a detail does not take the samples of all others
  static constexpr double largest_ratio_of_areas = 16;

  // of a facet
  struct Part
  {
    Vector normal;
    double area, largest_area;
    std::size_t point; // of the facet
  };

public:
  // `smallest_number` is how many samples there shall be at least, spread evenly over the area
  Reference_samples(const std::vector<Vector>& points, const std::vector<Facet>& facets, const double smallest_number)
    : Reference_samples(points, facets, std::vector<double>(points.size(), 1.), smallest_number)
  {
  }

  // The same, but near each point a sample stands for an area in proportion to that of the point.
  Reference_samples(const std::vector<Vector>& points, const std::vector<Facet>& facets, const std::vector<double>& areas,
                    const double smallest_number)
  {
    find_largest_parts(points, facets, areas, smallest_number);
    if (m_area > 0)
      add_samples(points, facets);
  }

  // Puts samples with near keys next to each other: samples that are used together are read together then.
  template <typename ConcurrencyTag, typename KeyOf>
  void sort_by(const KeyOf& key_of)
  {
    std::vector<std::pair<std::size_t, std::size_t>> order(m_samples.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = {std::size_t(key_of(m_samples[i])), i};
    parallel_sort<ConcurrencyTag>(order);
    std::vector<Reference_sample> sorted;
    sorted.reserve(m_samples.size());
    for (const auto& entry : order)
      sorted.push_back(m_samples[entry.second]);
    m_samples = std::move(sorted);
  }

  std::size_t size() const { return m_samples.size(); }
  double area_of_surface() const { return m_area; }
  const Reference_sample& operator[](const std::size_t i) const { return m_samples[i]; }

private:
  static Vector normal(const std::vector<Vector>& points, const Facet& facet)
  {
    return (points[facet[1]] - points[facet[0]]).cross(points[facet[2]] - points[facet[0]]);
  }

  static double longest_side(const std::vector<Vector>& points, const Facet& facet)
  {
    return (std::max)({(points[facet[1]] - points[facet[0]]).norm(), (points[facet[2]] - points[facet[1]]).norm(),
                       (points[facet[0]] - points[facet[2]]).norm()});
  }

  void find_largest_parts(const std::vector<Vector>& points, const std::vector<Facet>& facets, const std::vector<double>& areas,
                          const double smallest_number)
  {
    double number = 0;
    m_largest_areas.resize(facets.size());
    for (std::size_t i = 0; i < facets.size(); ++i)
    {
      const Facet& facet = facets[i];
      const auto [least, most] = std::minmax({areas[facet[0]], areas[facet[1]], areas[facet[2]]});
      m_largest_areas[i] = (std::max)(least, most / largest_ratio_of_areas);
      const double area = normal(points, facet).norm() / 2;
      m_area += area;
      number += area / m_largest_areas[i];
    }
    double number_of_lengths = 0;
    for (std::size_t i = 0; i < facets.size(); ++i)
    {
      m_largest_areas[i] *= number / smallest_number;
      number_of_lengths += longest_side(points, facets[i]) / (longest_part * std::sqrt(m_largest_areas[i]));
    }
    // of needles there are only so many parts as of all others
    m_longest_part = longest_part * (std::max)(1., number_of_lengths / smallest_number);
  }

  void add_samples(const std::vector<Vector>& points, const std::vector<Facet>& facets)
  {
    std::vector<Vector> normals(points.size(), Vector::Zero());
    std::vector<double> areas(points.size(), 0.);
    std::vector<float> reaches(points.size(), 0.f);
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      const Facet& facet = facets[f];
      const Vector n = normal(points, facet) / 2;
      const double area = n.norm();
      if (!(area > 0))
        continue;
      const std::size_t first = m_samples.size();
      const std::array<Vector, 3> corners{points[facet[0]], points[facet[1]], points[facet[2]]};
      cut(corners, Part{n / area, area, m_largest_areas[f], facet[0]}, 0);
      const double part = area / double(m_samples.size() - first);
      for (std::size_t i = first; i < m_samples.size(); ++i)
        m_samples[i].area = float((area - 3 * weight_of_corner * part) / double(m_samples.size() - first) / m_area);
      for (const std::size_t v : facet)
      {
        normals[v] += n;
        areas[v] += weight_of_corner * part;
        reaches[v] = (std::max)(reaches[v], m_samples[first].reach);
      }
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (areas[v] > 0 && normals[v].norm() > 0)
        m_samples.push_back(Reference_sample{points[v], normals[v].normalized().cast<float>(), float(areas[v] / m_area),
                                             reaches[v], std::uint32_t(v)});
  }

  void cut(const std::array<Vector, 3>& corners, const Part& part, const int depth)
  {
    std::size_t longest = 0;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if ((corners[(k + 1) % 3] - corners[k]).norm() > length)
      {
        length = (corners[(k + 1) % 3] - corners[k]).norm();
        longest = k;
      }
    if (depth < largest_depth && (part.area > part.largest_area || length > m_longest_part * std::sqrt(part.largest_area)))
    {
      const Vector middle = (corners[longest] + corners[(longest + 1) % 3]) / 2;
      const Part half{part.normal, part.area / 2, part.largest_area, part.point};
      std::array<Vector, 3> half_corners = corners;
      half_corners[(longest + 1) % 3] = middle;
      cut(half_corners, half, depth + 1);
      half_corners = corners;
      half_corners[longest] = middle;
      cut(half_corners, half, depth + 1);
      return;
    }
    const Vector p = (corners[0] + corners[1] + corners[2]) / 3;
    m_samples.push_back(
        Reference_sample{p, part.normal.cast<float>(), 0, float(share_of_reach * length), std::uint32_t(part.point)});
  }

  double m_area = 0;
  std::vector<double> m_largest_areas; // of the parts of each facet
  double m_longest_part = 0;           // over the root of that area
  std::vector<Reference_sample> m_samples;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_REFERENCE_SAMPLES_H
