// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_SEGMENT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_SEGMENT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_segment_primitive_3.h>
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_segment_primitive.h>
#  include <CGAL/AABB_traits.h>
#endif

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The closest of a set of segments. Those of no length are left out. Thread-safe.
class Closest_segment
{
  typedef Simple_cartesian<double> Kernel;
  typedef std::vector<Kernel::Segment_3> Segments;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef AABB_segment_primitive_3<Kernel, Segments::const_iterator> Primitive;
  typedef AABB_tree<AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef AABB_segment_primitive<Kernel, Segments::const_iterator> Primitive;
  typedef AABB_tree<AABB_traits<Kernel, Primitive>> Tree;
#endif

public:
  explicit Closest_segment(const std::vector<std::array<Vector, 2>>& segments)
  {
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (segments[i][0] != segments[i][1])
      {
        m_segments.emplace_back(to_point(segments[i][0]), to_point(segments[i][1]));
        m_indices.push_back(i);
      }
    m_tree.insert(m_segments.cbegin(), m_segments.cend());
    m_tree.build();
    if (!empty())
      m_tree.accelerate_distance_queries(); // now, not when a thread asks first
  }
  Closest_segment(const Closest_segment&) = delete;
  Closest_segment& operator=(const Closest_segment&) = delete;

  bool empty() const { return m_segments.empty(); }

  // its index; requires that there is one
  std::size_t operator()(const Vector& p) const
  {
    const auto found = m_tree.closest_point_and_primitive(to_point(p));
    return m_indices[std::size_t(found.second - m_segments.cbegin())];
  }

private:
  static Kernel::Point_3 to_point(const Vector& p) { return Kernel::Point_3(p[0], p[1], p[2]); }

  Segments m_segments;
  std::vector<std::size_t> m_indices; // of the given segments
  Tree m_tree;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_SEGMENT_H
