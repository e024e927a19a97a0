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

// whether many faces are long
template <typename FaceRange, typename TriangleMesh, typename VertexPointMap>
bool has_long_faces(const FaceRange& range, const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  static constexpr double longest_ratio = 8; // of the longest edge to the altitude over it
  double area = 0, area_of_long = 0;
  for_each_of_range(range,
                    [&](const auto f)
                    {
                      const auto [a, b, c] = corners_of_face(f, tmesh, vpm);
                      const double twice_the_area = (b - a).cross(c - a).norm(),
                                   longest = (std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
                      area += twice_the_area;
                      if (longest > longest_ratio * twice_the_area)
                        area_of_long += twice_the_area;
                    });
  return area_of_long > largest_share_of_long_facets * area;
}

// The facets of which a mesh is made: faces that lie in one plane belong to one facet.
template <typename TriangleMesh, typename VertexPointMap>
class Planar_facets
{
  // Turns between two facets, in radians. Less than the first is rounding. The second is that of 60 sides: less is a smooth surface.
  // The others are those of 30 and of 6 sides: facets of a cylinder of more sides are long already if it is as long as thick, and
  // steps of voxels turn by more.
  static constexpr double smallest_turn = 1e-3, turn_of_coarse = 0.1, least_turn_of_sides = 0.2, largest_turn_of_sides = 1.1;
  static constexpr double share_of_coarse = 0.95, share_of_sides = 0.5; // at least, of the length of the edges between facets
  static constexpr double longest_ratio = 4; // of the square of the length of a facet to its area; it is 2 for a square

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
  }

  // Whether facets turn by much wherever they turn, and many are long. So it is for a cylinder of few sides, however it is cut. On
  // scans, and where a surface is meant to be smooth, most edges turn by little, but not by nothing.
  template <typename FaceRange>
  bool are_coarse_and_long(const FaceRange& range)
  {
    Disjoint_sets sets(m_corners.size());
    Lengths lengths;
    for_each_of_range(range,
                      [&](const auto f)
                      {
                        const std::size_t i = get(m_index, f) - 1;
                        for (const auto h : halfedges_around_face(halfedge(f, m_tmesh), m_tmesh))
                        {
                          const auto o = opposite(h, m_tmesh);
                          const std::size_t j = is_border(o, m_tmesh) ? 0 : get(m_index, face(o, m_tmesh));
                          if (j <= i + 1)
                            continue; // there is none, or the edge has its turn from the other side
                          const double turn = angle_between(normal(i), normal(j - 1));
                          if (turn < smallest_turn)
                            sets.union_set(i, j - 1);
                          else
                            add_edge(i, j - 1, turn, lengths);
                        }
                      });
    return lengths.all > 0 && lengths.coarse >= share_of_coarse * lengths.all &&
           lengths.sides >= share_of_sides * lengths.all && are_long(sets);
  }

private:
  typedef typename boost::property_map<TriangleMesh, dynamic_face_property_t<std::size_t>>::const_type Index_map;

  // of the edges between facets: of all, and of those that turn by so much
  struct Lengths
  {
    double all = 0, coarse = 0, sides = 0;
  };

  Vector normal(const std::size_t i) const
  {
    return (m_corners[i][1] - m_corners[i][0]).cross(m_corners[i][2] - m_corners[i][0]);
  }

  // the edge that two faces have in common
  void add_edge(const std::size_t i, const std::size_t j, const double turn, Lengths& lengths) const
  {
    std::vector<Vector> shared;
    for (const Vector& p : m_corners[i])
      for (const Vector& q : m_corners[j])
        if (p == q)
          shared.push_back(p);
    if (shared.size() != 2)
      return;
    const double length = (shared[1] - shared[0]).norm();
    lengths.all += length;
    lengths.coarse += turn >= turn_of_coarse ? length : 0;
    lengths.sides += turn >= least_turn_of_sides && turn <= largest_turn_of_sides ? length : 0;
  }

  // The length of a facet is that between the corner that is farthest from any other and the one that is farthest from it.
  bool are_long(Disjoint_sets& sets) const
  {
    struct Facet
    {
      double area = 0, longest = 0;
      Vector begin, end;
      bool is_begun = false;
    };
    std::vector<Facet> facets(m_corners.size());
    const auto facet_of = [&](const std::size_t i) -> Facet& { return facets[sets.find_set(i)]; };
    for (const bool is_first : {true, false})
    {
      for (std::size_t i = 0; i < m_corners.size(); ++i)
      {
        Facet& f = facet_of(i);
        for (const Vector& p : m_corners[i])
        {
          if (!f.is_begun)
            f.begin = f.end = p;
          f.is_begun = true;
          const double square = (p - f.begin).squaredNorm();
          if (square > f.longest)
          {
            f.longest = square;
            f.end = p;
          }
        }
        f.area += is_first ? normal(i).norm() / 2 : 0;
      }
      for (Facet& f : facets)
        if (is_first)
          f.begin = f.end;
    }
    double area = 0, area_of_long = 0;
    for (const Facet& f : facets)
    {
      area += f.area;
      area_of_long += f.longest > longest_ratio * f.area ? f.area : 0;
    }
    return area_of_long > largest_share_of_long_facets * area;
  }

  const TriangleMesh& m_tmesh;
  Index_map m_index; // by face, from 1 on; 0 if it is not in the range
  std::vector<std::array<Vector, 3>> m_corners;
};

// Whether the faces are those of a CAD program: exact facets, as long as the part is, between which nothing is known of the surface.
// Then the facets themselves are the surface. So it is if long facets have a good part of the area; on scans hardly any has.
template <typename FaceRange, typename TriangleMesh, typename VertexPointMap>
bool has_long_facets(const FaceRange& range, const TriangleMesh& tmesh, const VertexPointMap vpm)
{
  return has_long_faces(range, tmesh, vpm) ||
         Planar_facets<TriangleMesh, VertexPointMap>(range, tmesh, vpm).are_coarse_and_long(range);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_HAS_LONG_FACETS_H
