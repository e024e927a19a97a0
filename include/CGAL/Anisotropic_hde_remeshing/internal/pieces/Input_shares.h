// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_INPUT_SHARES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_INPUT_SHARES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the faces of the input, a share of successive ones at a time
class Input_shares
{
public:
  virtual ~Input_shares() = default;
  virtual std::size_t number_of_shares() const = 0;
  // The number of the first face of a share; of the number of shares: that of all faces.
  virtual std::uint64_t first_face(std::size_t share) const = 0;
  // without seams; the name of a vertex is its number in the input
  virtual Piece_faces read(std::size_t share) const = 0;
};

// of points and triangles in memory
class Shares_of_soup : public Input_shares
{
public:
  typedef std::array<std::size_t, 3> Triangle;

  Shares_of_soup(std::vector<Vector> points, std::vector<Triangle> triangles, const std::size_t faces_of_share)
    : m_points(std::move(points)), m_triangles(std::move(triangles)), m_faces_of_share(faces_of_share)
  {
  }

  std::size_t number_of_shares() const override { return (m_triangles.size() + m_faces_of_share - 1) / m_faces_of_share; }

  std::uint64_t first_face(const std::size_t share) const override
  {
    return (std::min)(share * m_faces_of_share, m_triangles.size());
  }

  Piece_faces read(const std::size_t share) const override
  {
    Piece_faces result;
    std::unordered_map<std::size_t, std::uint32_t> index_of; // only looked up
    for (std::size_t f = first_face(share); f < first_face(share + 1); ++f)
    {
      std::array<std::uint32_t, 3> face{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t v = m_triangles[f][k];
        const auto added = index_of.emplace(v, std::uint32_t(result.names.size()));
        if (added.second)
        {
          result.names.push_back(v);
          result.points.push_back(m_points[v]);
        }
        face[k] = added.first->second;
      }
      result.faces.push_back(face);
    }
    return result;
  }

private:
  const std::vector<Vector> m_points;
  const std::vector<Triangle> m_triangles;
  const std::size_t m_faces_of_share;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_INPUT_SHARES_H
