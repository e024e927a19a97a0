// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_FACET_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_FACET_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

typedef std::array<std::size_t, 3> Facet; // the indices of its vertices

// The closest point of a set of facets. The search tree is built at the first query, as many runs never make one. Degenerate
// facets are left out. Thread-safe.
class Closest_facet
{
  typedef Simple_cartesian<double> Kernel;
  typedef std::vector<Kernel::Triangle_3> Triangles;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 0, 0)
  typedef AABB_triangle_primitive_3<Kernel, Triangles::const_iterator> Primitive;
  typedef AABB_tree<AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef AABB_triangle_primitive<Kernel, Triangles::const_iterator> Primitive;
  typedef AABB_tree<AABB_traits<Kernel, Primitive>> Tree;
#endif

public:
  struct Answer
  {
    std::size_t facet;
    Vector point;
    Vector barycentric; // its coordinates in the facet, of sum 1 and not negative
  };

  // keeps references: both must outlive this object
  Closest_facet(const std::vector<Vector>& points, const std::vector<Facet>& facets) : m_points(points), m_facets(facets) {}

  // whether there is a facet that is not degenerate
  bool empty() const
  {
    std::call_once(m_is_built, [this] { build(); });
    return m_triangles.empty();
  }

  // requires that it is not empty
  Answer operator()(const Vector& p) const
  {
    std::call_once(m_is_built, [this] { build(); });
    const auto found = m_tree->closest_point_and_primitive(Kernel::Point_3(p[0], p[1], p[2]));
    Answer answer;
    answer.facet = m_indices[std::size_t(found.second - m_triangles.cbegin())];
    answer.point = Vector(found.first.x(), found.first.y(), found.first.z());
    const Facet& facet = m_facets[answer.facet];
    const Vector &a = m_points[facet[0]], &b = m_points[facet[1]], &c = m_points[facet[2]];
    const Vector normal = (b - a).cross(c - a);
    answer.barycentric =
        Vector((b - answer.point).cross(c - answer.point).dot(normal), (c - answer.point).cross(a - answer.point).dot(normal),
               (a - answer.point).cross(b - answer.point).dot(normal))
            .cwiseMax(0.);
    const double sum = answer.barycentric.sum();
    answer.barycentric = sum > 0 ? Vector(answer.barycentric / sum) : Vector(Vector::Constant(1. / 3));
    return answer;
  }

private:
  void build() const
  {
    for (std::size_t k = 0; k < m_facets.size(); ++k)
    {
      const Vector &a = m_points[m_facets[k][0]], &b = m_points[m_facets[k][1]], &c = m_points[m_facets[k][2]];
      if (!((b - a).cross(c - a).norm() > 0))
        continue;
      m_triangles.emplace_back(to_point(a), to_point(b), to_point(c));
      m_indices.push_back(k);
    }
    if (m_triangles.empty())
      return;
    m_tree = std::make_unique<Tree>(m_triangles.cbegin(), m_triangles.cend());
    m_tree->build();
    accelerate();
  }

  // A query starts from the nearest of some points of the facets. One of eight facets is enough: all of them would take more
  // memory than the tree.
  void accelerate() const
  {
    static constexpr std::ptrdiff_t step = 8;
    std::vector<typename Tree::Point_and_primitive_id> hints;
    for (auto triangle = m_triangles.cbegin();; triangle += step)
    {
      hints.emplace_back(triangle->vertex(0), triangle);
      if (m_triangles.cend() - triangle <= step)
        break;
    }
    m_tree->accelerate_distance_queries(hints.cbegin(), hints.cend());
  }

  static Kernel::Point_3 to_point(const Vector& p) { return Kernel::Point_3(p[0], p[1], p[2]); }

  const std::vector<Vector>& m_points;
  const std::vector<Facet>& m_facets;
  mutable std::once_flag m_is_built;
  mutable Triangles m_triangles;
  mutable std::vector<std::size_t> m_indices; // of the facets of the triangles
  mutable std::unique_ptr<Tree> m_tree;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_GEOMETRY_CLOSEST_FACET_H
