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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

public:
  // `smallest_number` is how many samples there shall be at least, spread evenly over the area
  Reference_samples(const std::vector<Vector>& points, const std::vector<Facet>& facets, const double smallest_number)
  {
    double area = 0;
    for (const Facet& facet : facets)
      area += normal(points, facet).norm() / 2;
    if (!(area > 0))
      return;
    m_area = area;
    m_largest_area = area / smallest_number;
    m_largest_length = 3 * std::sqrt(m_largest_area);
    // of needles there are only so many parts as of all others
    double number_of_lengths = 0;
    for (const Facet& facet : facets)
      number_of_lengths += longest_side(points, facet) / m_largest_length;
    m_largest_length *= (std::max)(1., number_of_lengths / smallest_number);
    std::vector<Vector> normals(points.size(), Vector::Zero());
    std::vector<double> areas(points.size(), 0.);
    std::vector<float> reaches(points.size(), 0.f);
    for (const Facet& facet : facets)
    {
      const Vector n = normal(points, facet) / 2;
      const double facet_area = n.norm();
      if (!(facet_area > 0))
        continue;
      const std::size_t first = m_samples.size();
      const std::array<Vector, 3> corners{points[facet[0]], points[facet[1]], points[facet[2]]};
      cut(corners, facet, n / facet_area, facet_area, 0);
      const double part = facet_area / double(m_samples.size() - first);
      for (std::size_t i = first; i < m_samples.size(); ++i)
        m_samples[i].area = float((facet_area - 3 * weight_of_corner * part) / double(m_samples.size() - first) / area);
      for (const std::size_t v : facet)
      {
        normals[v] += n;
        areas[v] += weight_of_corner * part;
        reaches[v] = (std::max)(reaches[v], m_samples[first].reach);
      }
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (areas[v] > 0 && normals[v].norm() > 0)
        m_samples.push_back(Reference_sample{points[v], normals[v].normalized().cast<float>(), float(areas[v] / area),
                                             reaches[v], std::uint32_t(v)});
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

  void cut(const std::array<Vector, 3>& corners, const Facet& facet, const Vector& normal, const double area, const int depth)
  {
    std::size_t longest = 0;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if ((corners[(k + 1) % 3] - corners[k]).norm() > length)
      {
        length = (corners[(k + 1) % 3] - corners[k]).norm();
        longest = k;
      }
    if (depth < largest_depth && (area > m_largest_area || length > m_largest_length))
    {
      const Vector middle = (corners[longest] + corners[(longest + 1) % 3]) / 2;
      std::array<Vector, 3> part = corners;
      part[(longest + 1) % 3] = middle;
      cut(part, facet, normal, area / 2, depth + 1);
      part = corners;
      part[longest] = middle;
      cut(part, facet, normal, area / 2, depth + 1);
      return;
    }
    const Vector p = (corners[0] + corners[1] + corners[2]) / 3;
    m_samples.push_back(Reference_sample{p, normal.cast<float>(), 0, float(share_of_reach * length), std::uint32_t(facet[0])});
  }

  double m_area = 0;
  double m_largest_area = 0, m_largest_length = 0;
  std::vector<Reference_sample> m_samples;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_SAMPLES_REFERENCE_SAMPLES_H
