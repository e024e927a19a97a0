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

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Indexed_triangle.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Triangle_grids.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Faces by their numbers. It tells whether other faces would intersect them. Faces that intersect others already may go on to do
// so, but no more often.
class Intersection_guard
{
  typedef Triangle_grids::Box Box;

public:
  typedef std::pair<std::size_t, Indexed_triangle> Numbered_triangle;

  // stores these faces alone; no two have the same number
  void assign(const std::vector<Numbered_triangle>& triangles)
  {
    static constexpr double size_of_cells = 2; // over the mean size of faces: an operation looks into about eight cells
    double sum = 0;
    for (const Numbered_triangle& t : triangles)
      sum += Triangle_grids::box_of(t.second).sizes().maxCoeff();
    m_faces.clear(size_of_cells * sum / double((std::max)(triangles.size(), std::size_t(1))));
    for (const Numbered_triangle& t : triangles)
      m_faces.insert(t.first, t.second);
  }

  // Whether faces with a common vertex are looked at, too. Most of them are side by side in one sheet, and fold before they intersect.
  void look_at_neighbors(const bool looks) { m_looks_at_neighbors = looks; }

  void remove(const std::size_t f)
  {
    if (m_faces.has(f))
      m_faces.remove(f);
  }

  void replace(const std::size_t f, const Indexed_triangle& triangle)
  {
    remove(f);
    m_faces.insert(f, triangle);
  }

  // whether no more pairs intersect if the new faces take the place of the old ones
  template <typename Faces, typename Triangles>
  bool accepts(const Faces& old_faces, const Triangles& new_triangles) const
  {
    const std::size_t number = number_of_pairs(new_triangles, old_faces);
    if (number == 0)
      return true;
    boost::container::small_vector<Indexed_triangle, 16> old_triangles;
    for (const std::size_t f : old_faces)
      if (m_faces.has(f))
        old_triangles.push_back(m_faces[f]);
    return number <= number_of_pairs(old_triangles, old_faces);
  }

  // the faces among those asked for that intersect face f, in the order of their numbers
  template <typename IsAskedFor>
  std::vector<std::size_t> intersecting(const std::size_t f, const IsAskedFor& is_asked_for) const
  {
    std::vector<std::size_t> result;
    m_faces.for_each_near(Triangle_grids::box_of(m_faces[f]),
                          [&](const std::size_t g, const Indexed_triangle& t, const Box&)
                          {
                            if (f != g && is_asked_for(g) && do_intersect(m_faces[f], t))
                              result.push_back(g);
                          });
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  bool do_intersect(const Indexed_triangle& s, const Indexed_triangle& t) const
  {
    return (m_looks_at_neighbors || !have_common_vertex(s, t)) && do_triangles_intersect(s, t);
  }

  // of triangles that intersect each other or faces, without some of the faces
  template <typename Triangles, typename Faces>
  std::size_t number_of_pairs(const Triangles& triangles, const Faces& without) const
  {
    boost::container::small_vector<Box, 16> boxes;
    Box all;
    for (const Indexed_triangle& t : triangles)
    {
      boxes.push_back(Triangle_grids::box_of(t));
      all.extend(boxes.back());
    }
    std::size_t number = number_of_pairs(triangles);
    m_faces.for_each_near(all,
                          [&](const std::size_t f, const Indexed_triangle& t, const Box& box)
                          {
                            if (std::find(without.begin(), without.end(), f) != without.end())
                              return;
                            for (std::size_t i = 0; i < triangles.size(); ++i)
                              number += boxes[i].intersects(box) && do_intersect(triangles[i], t) ? 1 : 0;
                          });
    return number;
  }

  // Of triangles that intersect each other. They are those around a vertex or an edge: none do if all look the same way.
  template <typename Triangles>
  static std::size_t number_of_pairs(const Triangles& triangles)
  {
    Vector sum = Vector::Zero();
    for (const Indexed_triangle& t : triangles)
      sum += t.normal();
    if (std::all_of(triangles.begin(), triangles.end(), [&](const Indexed_triangle& t) { return t.normal().dot(sum) > 0; }))
      return 0;
    std::size_t number = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        number += do_triangles_intersect(triangles[i], triangles[k]) ? 1 : 0;
    return number;
  }

  Triangle_grids m_faces;
  bool m_looks_at_neighbors = true;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_GUARDS_INTERSECTION_GUARD_H
