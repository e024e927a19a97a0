// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_VERTEX_SIZES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_VERTEX_SIZES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/projection/Input_surface.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Makes sizes grow by no more than `gradation` times the way along the edges of the facets. The smallest sizes come first, as in
// Dijkstra's algorithm. The result depends on no order.
inline void limit_gradation(std::vector<double>& sizes, const std::vector<Vector>& points, const std::vector<Facet>& facets,
                            const double gradation)
{
  std::vector<std::vector<std::size_t>> neighbors(points.size());
  for (const Facet& facet : facets)
    for (std::size_t k = 0; k < 3; ++k)
    {
      neighbors[facet[k]].push_back(facet[(k + 1) % 3]);
      neighbors[facet[(k + 1) % 3]].push_back(facet[k]);
    }
  typedef std::pair<double, std::size_t> Sized_vertex;
  std::priority_queue<Sized_vertex, std::vector<Sized_vertex>, std::greater<Sized_vertex>> queue;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    queue.emplace(sizes[i], i);
  while (!queue.empty())
  {
    const auto [size, i] = queue.top();
    queue.pop();
    if (size > sizes[i])
      continue; // it has become smaller meanwhile
    for (const std::size_t j : neighbors[i])
    {
      const double largest = size + gradation * (points[j] - points[i]).norm();
      if (largest < sizes[j])
      {
        sizes[j] = largest;
        queue.emplace(largest, j);
      }
    }
  }
}

// Sizes at the vertices of the input as a field in space: at a point, that at the closest point of the input. Keeps a reference to
// the input. May be called concurrently, and is cheap to copy. The unit is that of the input.
class Vertex_sizes
{
public:
  Vertex_sizes(const Input_surface& input, std::vector<double> sizes)
    : m_input(&input), m_sizes(std::make_shared<const std::vector<double>>(std::move(sizes)))
  {
  }

  double operator()(const Vector& p) const
  {
    if (m_input->empty())
      return *std::min_element(m_sizes->begin(), m_sizes->end());
    const Closest_facet::Answer closest = m_input->closest(p);
    double size = 0;
    for (int k = 0; k < 3; ++k)
      size += closest.barycentric[k] * (*m_sizes)[m_input->facets()[closest.facet][std::size_t(k)]];
    return size;
  }

private:
  const Input_surface* m_input;
  std::shared_ptr<const std::vector<double>> m_sizes;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_VERTEX_SIZES_H
