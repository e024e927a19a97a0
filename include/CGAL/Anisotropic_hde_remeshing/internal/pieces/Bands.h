// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_BANDS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_BANDS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Labels the faces of a piece within some rings of its seams by the piece behind the nearest seam, and all others by nobody. Rings are
// counted inside the piece: a path that leaves it crosses a seam, which is nearer. So both sides of an interface agree without a word.
// Vertices where several pieces meet begin no ring.
inline std::vector<std::uint32_t> band_labels(const Piece_faces& faces, const unsigned int number_of_rings)
{
  typedef std::pair<unsigned int, std::uint32_t> Rank; // ring, then piece
  const Rank unreached(number_of_rings, Piece_faces::nobody);
  std::vector<Rank> ranks(faces.points.size(), unreached);
  std::vector<char> is_corner(faces.points.size(), 0);
  for (const Piece_faces::Seam& seam : faces.seams)
    for (const std::uint32_t v : {faces.faces[seam.face][seam.corner], faces.faces[seam.face][(seam.corner + 1) % 3]})
    {
      is_corner[v] = is_corner[v] || (ranks[v] != unreached && ranks[v].second != seam.other);
      ranks[v] = (std::min)(ranks[v], Rank(0, seam.other));
    }
  for (std::size_t v = 0; v < ranks.size(); ++v)
    if (is_corner[v])
      ranks[v] = unreached;
  const auto nearest_of = [&](const std::vector<Rank>& from, const std::array<std::uint32_t, 3>& face) {
    return (std::min)({from[face[0]], from[face[1]], from[face[2]]});
  };
  for (unsigned int ring = 1; ring < number_of_rings; ++ring)
  {
    const std::vector<Rank> before = ranks;
    for (const auto& face : faces.faces)
    {
      const Rank nearest = nearest_of(before, face);
      if (nearest.first + 1 == ring)
        for (const std::uint32_t v : face)
          ranks[v] = (std::min)(ranks[v], Rank(ring, nearest.second));
    }
  }
  std::vector<std::uint32_t> labels;
  for (const auto& face : faces.faces)
    labels.push_back(nearest_of(ranks, face).second);
  straighten_labels(faces, labels);
  return labels;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_BANDS_H
