// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_HAS_LONG_FACETS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_HAS_LONG_FACETS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

constexpr double largest_share_of_long_facets = 0.25; // of the area; with more, a mesh counts as one of long facets

template <typename Descriptor, typename TriangleMesh, typename VertexPointMap>
std::array<Vector, 3> corners_of_face(const Descriptor f, const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  const auto h = halfedge(f, tmesh);
  const auto point = [&](const auto v) { return to_vector(value_of(vpm, v)); };
  return {point(source(h, tmesh)), point(target(h, tmesh)), point(target(next(h, tmesh), tmesh))};
}

// the square of the longest edge
inline double longest_square(const std::array<Vector, 3>& corners)
{
  const auto& [a, b, c] = corners;
  return (std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

// whether many faces are long
template <typename FaceRange, typename TriangleMesh, typename VertexPointMap>
bool has_long_faces(const FaceRange& range, const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  static constexpr double longest_ratio = 8; // of the longest edge to the altitude over it
  double area = 0, area_of_long = 0;
  for_each_of_range(range,
                    [&](const auto f)
                    {
                      const std::array<Vector, 3> corners = corners_of_face(f, tmesh, vpm);
                      const double twice_the_area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
                      area += twice_the_area;
                      if (longest_square(corners) > longest_ratio * twice_the_area)
                        area_of_long += twice_the_area;
                    });
  return area_of_long > largest_share_of_long_facets * area;
}

// The facets of which a mesh is made: faces that lie in one plane belong to one facet.
template <typename TriangleMesh, typename VertexPointMap>
class Planar_facets
{
  // Turns between two facets, in radians. Less than the first is rounding; with less than the second, that of 60 sides, a surface is
  // meant to be smooth. The sides of an arc turn by as much as those of 6 to 30 sides: steps of voxels turn by more, and finer arcs
  // with short faces are samples of a smooth surface. Where the faces are longer, too, it is up to 120 sides.
  static constexpr double smallest_turn = 1e-3, turn_of_coarse = 0.1;
  static constexpr double largest_turn_of_sides = 1.1, least_turn_of_sides = 0.2, least_turn_of_longer_faces = 0.05;
  static constexpr double ratio_of_longer_faces = 3;                    // of the longest edge to the altitude over it
  static constexpr double share_of_coarse = 0.95, share_of_sides = 0.5; // at least, of the length of the edges between facets
  static constexpr double longest_ratio = 4; // of the square of the length of a facet to its area; it is 2 for a square
  static constexpr double least_share_of_large = 0.05; // of the area: so large are facets of a block, and no steps of voxels
  static constexpr double least_share_of_polyhedron = 0.5; // of the area, in long and large facets

  // of the edges around facets: of all, of those that turn by so much, and of those that turn as the sides of an arc, in both ways
  struct Lengths
  {
    double all = 0, coarse = 0, sides = 0, sides_of_longer_faces = 0;
  };

  // The length of a facet is that between the corner that is farthest from any other and the one that is farthest from it.
  struct Facet
  {
    std::size_t number_of_faces = 0;
    double area = 0, area_of_longer_faces = 0, longest = 0;
    Vector begin, end;
    Lengths around;
  };

public:
  template <typename FaceRange>
  Planar_facets(const FaceRange& range, const TriangleMesh& tmesh, const VertexPointMap vpm)
    : m_tmesh(tmesh), m_index(get(dynamic_face_property_t<std::size_t>(), tmesh))
  {
    for (const auto f : faces(tmesh))
      put(m_index, f, 0);
    for_each_of_range(range,
                      [&](const auto f)
                      {
                        m_corners.push_back(corners_of_face(f, tmesh, vpm));
                        put(m_index, f, m_corners.size());
                      });
    m_facets.resize(m_corners.size());
    Disjoint_sets sets(m_corners.size());
    for_each_edge(range,
                  [&](const std::size_t i, const std::size_t j, const double turn, double)
                  {
                    if (turn < smallest_turn)
                      sets.union_set(i, j);
                  });
    for_each_edge(range,
                  [&](const std::size_t i, const std::size_t j, const double turn, const double length)
                  {
                    const std::size_t a = sets.find_set(i), b = sets.find_set(j);
                    if (a == b)
                      return;
                    for (Lengths* lengths : {&m_lengths, &m_facets[a].around, &m_facets[b].around})
                      add(turn, length, *lengths);
                  });
    measure(sets);
  }

  // Whether many facets are long, and turn where they are long as the sides of a coarse arc do: so it is for a cylinder of few sides,
  // however it is cut. Or there are hardly any but coarse turns, and most of the area is in large facets, as of a block or a plate.
  // On scans, and where a surface is meant to be smooth, hardly two faces lie in one plane.
  bool are_exact() const
  {
    const bool is_polyhedron = m_lengths.all > 0 && m_lengths.coarse >= share_of_coarse * m_lengths.all;
    double area = 0, area_of_long = 0, area_of_polyhedron = 0;
    for (const Facet& f : m_facets)
      area += f.area;
    for (const Facet& f : m_facets)
    {
      const bool is_large = f.number_of_faces > 1 && f.area >= least_share_of_large * area;
      const bool is_long = (f.number_of_faces > 1 || is_polyhedron) && is_long_side(f);
      area_of_long += is_long ? f.area : 0;
      area_of_polyhedron += is_polyhedron && (is_long || is_large) ? f.area : 0;
    }
    return area_of_long > largest_share_of_long_facets * area || area_of_polyhedron > least_share_of_polyhedron * area;
  }

private:
  typedef typename boost::property_map<TriangleMesh, dynamic_face_property_t<std::size_t>>::const_type Index_map;

  static bool is_long_side(const Facet& f)
  {
    const double sides = 2 * f.area_of_longer_faces > f.area ? f.around.sides_of_longer_faces : f.around.sides;
    return f.longest > longest_ratio * f.area && sides > 0 && sides >= share_of_sides * f.around.all;
  }

  // calls `visit` with the faces at each edge between two of them, how much it turns, and its length
  template <typename FaceRange, typename Visit>
  void for_each_edge(const FaceRange& range, const Visit& visit) const
  {
    for_each_of_range(range,
                      [&](const auto f)
                      {
                        const std::size_t i = get(m_index, f) - 1;
                        std::size_t k = 0; // the corner from which the edge comes
                        for (const auto h : halfedges_around_face(halfedge(f, m_tmesh), m_tmesh))
                        {
                          const Vector &from = m_corners[i][k], &to = m_corners[i][(k + 1) % 3];
                          ++k;
                          const auto o = opposite(h, m_tmesh);
                          const std::size_t j = is_border(o, m_tmesh) ? 0 : get(m_index, face(o, m_tmesh));
                          if (j > i + 1) // else there is none, or the edge has its turn from the other side
                            visit(i, j - 1, angle_between(normal(i), normal(j - 1)), (from - to).norm());
                        }
                      });
  }

  Vector normal(const std::size_t i) const
  {
    return (m_corners[i][1] - m_corners[i][0]).cross(m_corners[i][2] - m_corners[i][0]);
  }

  static void add(const double turn, const double length, Lengths& lengths)
  {
    lengths.all += length;
    lengths.coarse += turn >= turn_of_coarse ? length : 0;
    if (turn > largest_turn_of_sides)
      return;
    lengths.sides += turn >= least_turn_of_sides ? length : 0;
    lengths.sides_of_longer_faces += turn >= least_turn_of_longer_faces ? length : 0;
  }

  // the areas and the lengths of the facets
  void measure(Disjoint_sets& sets)
  {
    for (std::size_t i = 0; i < m_corners.size(); ++i)
    {
      const double twice_the_area = normal(i).norm();
      Facet& f = m_facets[sets.find_set(i)];
      if (f.number_of_faces++ == 0)
        f.begin = f.end = m_corners[i][0];
      f.area += twice_the_area / 2;
      if (longest_square(m_corners[i]) > ratio_of_longer_faces * twice_the_area)
        f.area_of_longer_faces += twice_the_area / 2;
      add_corners(i, f);
    }
    for (Facet& f : m_facets)
      f.begin = f.end;
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      add_corners(i, m_facets[sets.find_set(i)]);
  }

  // makes its end the one that is farthest from its beginning
  void add_corners(const std::size_t i, Facet& f) const
  {
    for (const Vector& p : m_corners[i])
    {
      const double square = (p - f.begin).squaredNorm();
      if (square > f.longest)
      {
        f.longest = square;
        f.end = p;
      }
    }
  }

  const TriangleMesh& m_tmesh;
  Index_map m_index; // by face, from 1 on; 0 if it is not in the range
  std::vector<std::array<Vector, 3>> m_corners;
  std::vector<Facet> m_facets; // at one face of each
  Lengths m_lengths;
};

// Whether the faces are those of a CAD program: exact facets, as long as the part is, between which nothing is known of the surface.
// Then the facets themselves are the surface. So it is if long facets have a good part of the area, or large facets that meet in edges
// alone; on scans hardly any has.
template <typename FaceRange, typename TriangleMesh, typename VertexPointMap>
bool has_long_facets(const FaceRange& range, const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  return has_long_faces(range, tmesh, vpm) || Planar_facets<TriangleMesh, VertexPointMap>(range, tmesh, vpm).are_exact();
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_HAS_LONG_FACETS_H
