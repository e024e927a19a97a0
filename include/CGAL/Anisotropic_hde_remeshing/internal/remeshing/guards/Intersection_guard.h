// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INTERSECTION_GUARD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INTERSECTION_GUARD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Indexed_triangle.h>

#include <boost/geometry/algorithms/covered_by.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The faces of a mesh in an R-tree. It tells whether other faces would intersect them, by the predicates of `Kernel`. Faces
// that intersect each other already may go on to do so.
template <typename Kernel>
class Intersection_guard
{
  typedef boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian> Corner;
  typedef boost::geometry::model::box<Corner> Box;
  typedef std::pair<Box, std::size_t> Entry;
  struct Is_same
  {
    bool operator()(const Entry& a, const Entry& b) const { return a.second == b.second; }
  };
  typedef boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>, boost::geometry::index::indexable<Entry>,
                                        Is_same>
      Tree;

public:
  typedef std::pair<std::size_t, std::size_t> Pair;

  // stores all faces anew; the number f is that of a face if `is_used[f]`
  void assign(std::vector<Indexed_triangle> triangles, std::vector<char> is_used)
  {
    m_triangles = std::move(triangles);
    m_is_used = std::move(is_used);
    std::vector<Entry> entries;
    entries.reserve(m_triangles.size());
    for (std::size_t f = 0; f < m_triangles.size(); ++f)
      if (m_is_used[f])
        entries.emplace_back(box(m_triangles[f]), f);
    m_tree = Tree(entries); // packed
  }

  void remove(const std::size_t f)
  {
    if (f >= m_is_used.size() || !m_is_used[f])
      return;
    m_tree.remove(Entry(box(m_triangles[f]), f));
    m_is_used[f] = 0;
  }

  void replace(const std::size_t f, const Indexed_triangle& triangle)
  {
    remove(f);
    if (f >= m_is_used.size())
    {
      m_triangles.resize(f + 1);
      m_is_used.resize(f + 1, 0);
    }
    m_triangles[f] = triangle;
    m_is_used[f] = 1;
    m_tree.insert(Entry(box(triangle), f));
  }

  // whether the new faces intersect only what the old ones did; they take the place of the old ones
  template <typename Faces, typename Triangles>
  bool accepts(const Faces& old_faces, const Triangles& new_triangles) const
  {
    for (std::size_t i = 0; i < new_triangles.size(); ++i)
    {
      for (std::size_t k = 0; k < i; ++k)
        if (do_triangles_intersect<Kernel>(new_triangles[i], new_triangles[k]) && !do_intersect_each_other(old_faces))
          return false;
      bool is_accepted = true;
      for_each_near(new_triangles[i],
                    [&](const std::size_t f)
                    {
                      if (is_accepted && std::find(old_faces.begin(), old_faces.end(), f) == old_faces.end() &&
                          do_triangles_intersect<Kernel>(new_triangles[i], m_triangles[f]))
                        is_accepted = do_intersect_one_of(old_faces, f);
                    });
      if (!is_accepted)
        return false;
    }
    return true;
  }

  // the faces among those asked for that intersect face f, in the order of their numbers
  template <typename IsAskedFor>
  std::vector<std::size_t> intersecting(const std::size_t f, const IsAskedFor& is_asked_for) const
  {
    std::vector<std::size_t> result;
    for_each_near(m_triangles[f],
                  [&](const std::size_t g)
                  {
                    if (f != g && is_asked_for(g) && do_triangles_intersect<Kernel>(m_triangles[f], m_triangles[g]))
                      result.push_back(g);
                  });
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  static Box box(const Indexed_triangle& t)
  {
    const Vector low = t.points[0].cwiseMin(t.points[1]).cwiseMin(t.points[2]),
                 high = t.points[0].cwiseMax(t.points[1]).cwiseMax(t.points[2]);
    return Box(Corner(low[0], low[1], low[2]), Corner(high[0], high[1], high[2]));
  }

  // visits the faces whose bounding boxes meet that of the triangle
  template <typename Visit>
  void for_each_near(const Indexed_triangle& triangle, const Visit& visit) const
  {
    m_tree.query(boost::geometry::index::intersects(box(triangle)),
                 boost::make_function_output_iterator([&](const Entry& entry) { visit(entry.second); }));
  }

  template <typename Faces>
  bool do_intersect_one_of(const Faces& faces, const std::size_t f) const
  {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const std::size_t g) { return do_triangles_intersect<Kernel>(m_triangles[f], m_triangles[g]); });
  }

  template <typename Faces>
  bool do_intersect_each_other(const Faces& faces) const
  {
    for (auto f = faces.begin(); f != faces.end(); ++f)
      for (auto g = faces.begin(); g != f; ++g)
        if (do_triangles_intersect<Kernel>(m_triangles[*f], m_triangles[*g]))
          return true;
    return false;
  }

  std::vector<Indexed_triangle> m_triangles; // by the numbers of the faces
  std::vector<char> m_is_used;
  Tree m_tree;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INTERSECTION_GUARD_H
