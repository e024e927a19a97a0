// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CORNERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CORNERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// a vertex about which the third round remeshes: one that no round could move so far, or one of a thin face
struct Frozen_vertex
{
  Vertex_name name;
  std::array<double, 3> point;
};

// the first vertices of the faces for which the condition holds
template <typename Is_selected>
std::vector<Frozen_vertex> vertices_of_faces(const Piece_faces& faces, const Is_selected& is_selected)
{
  std::vector<Frozen_vertex> result;
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
    if (is_selected(f))
    {
      const Vector& p = faces.point(f, 0);
      result.push_back(Frozen_vertex{faces.name(f, 0), {{p.x(), p.y(), p.z()}}});
    }
  return result;
}

// the vertices of the input on the seams of a band that has been remeshed: where the band ended at corners of pieces
inline std::vector<Frozen_vertex> frozen_vertices(const Piece_faces& faces)
{
  std::map<Vertex_name, Frozen_vertex> result;
  for (const Piece_faces::Seam& seam : faces.seams)
    for (const std::size_t k : {seam.corner, seam.corner + 1})
      if (is_of_input(faces.name(seam.face, k)))
      {
        const Vector& p = faces.point(seam.face, k);
        result[faces.name(seam.face, k)] = Frozen_vertex{faces.name(seam.face, k), {{p.x(), p.y(), p.z()}}};
      }
  std::vector<Frozen_vertex> list;
  for (const auto& vertex : result)
    list.push_back(vertex.second);
  return list;
}

// The balls about frozen vertices, joined to regions where they overlap. All processes know them: there are few for each piece.
class Corner_regions
{
  typedef std::array<std::int64_t, 3> Voxel;

public:
  // the vertices may be there several times
  Corner_regions(std::vector<Frozen_vertex> vertices, const double radius) : m_radius(radius)
  {
    std::sort(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    for (const Frozen_vertex& v : vertices)
      if (m_names.empty() || m_names.back() != v.name)
      {
        m_names.push_back(v.name);
        m_points.emplace_back(v.point[0], v.point[1], v.point[2]);
      }
    for (std::size_t i = 0; i < m_points.size(); ++i)
      m_voxels[voxel_of(m_points[i])].push_back(i);
    Disjoint_sets sets(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
      visit_near(m_points[i], 2 * m_radius, [&](const std::size_t j) { sets.union_set(i, j); });
    std::map<std::size_t, std::uint32_t> number_of_set;
    for (std::size_t i = 0; i < m_points.size(); ++i)
    {
      const auto added = number_of_set.emplace(sets.find_set(i), std::uint32_t(m_number_of_regions));
      m_number_of_regions += added.second ? 1 : 0;
      m_region.push_back(added.first->second);
    }
  }

  std::size_t number_of_regions() const { return m_number_of_regions; }

  // the region of each face with a corner in one of the balls, and nobody for the others
  std::vector<std::uint32_t> labels(const Piece_faces& faces) const
  {
    std::vector<std::uint32_t> of_vertices;
    for (const Vector& p : faces.points)
    {
      std::uint32_t region = Piece_faces::nobody;
      visit_near(p, m_radius, [&](const std::size_t i) { region = (std::min)(region, m_region[i]); });
      of_vertices.push_back(region);
    }
    std::vector<std::uint32_t> result;
    for (const auto& face : faces.faces)
      result.push_back((std::min)({of_vertices[face[0]], of_vertices[face[1]], of_vertices[face[2]]}));
    straighten_labels(faces, result);
    return result;
  }

private:
  Voxel voxel_of(const Vector& p) const
  {
    const double side = 2 * m_radius;
    return {{std::int64_t(std::floor(p.x() / side)), std::int64_t(std::floor(p.y() / side)),
             std::int64_t(std::floor(p.z() / side))}};
  }

  // the frozen vertices within a distance of at most twice the radius
  template <typename Visitor>
  void visit_near(const Vector& p, const double distance, const Visitor& visit) const
  {
    if (m_points.empty())
      return;
    const Voxel centre = voxel_of(p);
    for (std::int64_t x = centre[0] - 1; x <= centre[0] + 1; ++x)
      for (std::int64_t y = centre[1] - 1; y <= centre[1] + 1; ++y)
        for (std::int64_t z = centre[2] - 1; z <= centre[2] + 1; ++z)
        {
          const auto found = m_voxels.find(Voxel{{x, y, z}});
          if (found != m_voxels.end())
            for (const std::size_t i : found->second)
              if ((m_points[i] - p).norm() <= distance)
                visit(i);
        }
  }

  const double m_radius;
  std::vector<Vertex_name> m_names;
  std::vector<Vector> m_points;
  std::map<Voxel, std::vector<std::size_t>> m_voxels;
  std::vector<std::uint32_t> m_region;
  std::size_t m_number_of_regions = 0;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CORNERS_H
