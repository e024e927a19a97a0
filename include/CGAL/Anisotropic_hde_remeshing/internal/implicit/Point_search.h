// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINT_SEARCH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINT_SEARCH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the nearest of a set of points, by their indices; thread-safe
class Point_search
{
  typedef Simple_cartesian<double> Kernel;
  typedef std::pair<Kernel::Point_3, std::size_t> Indexed_point;
  typedef Search_traits_adapter<Indexed_point, First_of_pair_property_map<Indexed_point>, Search_traits_3<Kernel>> Traits;
  typedef Orthogonal_k_neighbor_search<Traits> Neighbor_search;

public:
  explicit Point_search(const std::vector<Vector>& points)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_tree.insert(Indexed_point(Kernel::Point_3(points[i][0], points[i][1], points[i][2]), i));
    m_tree.build();
  }

  // the squared distances and the indices of the `k` nearest, or of all if there are fewer, in no order
  std::vector<std::pair<double, std::size_t>> nearest(const Vector& p, const unsigned int k) const
  {
    Neighbor_search search(m_tree, Kernel::Point_3(p[0], p[1], p[2]), k);
    std::vector<std::pair<double, std::size_t>> result;
    for (const auto& neighbor : search)
      result.emplace_back(neighbor.second, neighbor.first.second);
    return result;
  }

private:
  typename Neighbor_search::Tree m_tree;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_POINT_SEARCH_H
