// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_INPUT_PARTITION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_INPUT_PARTITION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_input.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Grid_counts.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Input_shares.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Task_team.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Divides the input into cells and pieces: three times over its shares, for the box, the counts, and to hand the faces to the cells.
class Input_partition
{
public:
  Input_partition(const Input_shares& input, Task_team& team, Piece_store& store, const std::uint64_t faces_of_piece,
                  const std::uint64_t faces_of_cell)
    : m_input(input), m_team(team)
  {
    const Space_box box = find_box();
    if (box.is_empty())
      throw std::invalid_argument("the input has no faces");
    m_diagonal = (box.high - box.low).stableNorm();
    if (!(m_diagonal > 0))
      throw std::invalid_argument("all points of the input are equal");
    Grid_counts counts(box);
    count(counts);
    m_tree = Cell_tree(counts, faces_of_piece, faces_of_cell);
    scatter(store);
  }

  const Cell_tree& tree() const { return m_tree; }
  double diagonal() const { return m_diagonal; }
  std::uint64_t number_of_faces() const { return m_input.first_face(m_input.number_of_shares()); }

  Input_of_cells input_of_cells(const Piece_store& store) const
  {
    return Input_of_cells(store, m_tree.number_of_cells(), m_cells_of_shares);
  }

private:
  Space_box find_box() const
  {
    const std::vector<Bytes> boxes = m_team.run("box", m_input.number_of_shares(),
                                                [&](const std::size_t share)
                                                {
                                                  Space_box box;
                                                  const Piece_faces faces = m_input.read(share);
                                                  for (std::size_t i = 0; i < faces.points.size(); ++i)
                                                  {
                                                    finite_vector(faces.points[i], "point", faces.names[i]);
                                                    box.add(faces.points[i]);
                                                  }
                                                  return bytes_of(std::vector<Vector>{box.low, box.high});
                                                });
    Space_box result;
    for (const Bytes& bytes : boxes)
    {
      const auto corners = from_bytes<std::vector<Vector>>(bytes);
      result.add(Space_box{corners[0], corners[1]});
    }
    return result;
  }

  void count(Grid_counts& counts) const
  {
    const Grid_counts empty = counts;
    const std::vector<Bytes> results = m_team.run("count", m_input.number_of_shares(),
                                                  [&](const std::size_t share)
                                                  {
                                                    Grid_counts counts_of_share = empty;
                                                    const Piece_faces faces = m_input.read(share);
                                                    for (std::size_t f = 0; f < faces.faces.size(); ++f)
                                                      counts_of_share.add(centroid_of(faces, f), mean_edge_of(faces, f));
                                                    counts_of_share.unite();
                                                    return bytes_of(counts_of_share.voxels());
                                                  });
    for (const Bytes& bytes : results)
      counts.add(from_bytes<std::vector<Grid_counts::Voxel>>(bytes));
    counts.unite();
  }

  void scatter(Piece_store& store)
  {
    const Input_scatterer scatterer(m_tree, store);
    const std::vector<Bytes> results = m_team.run(
        "scatter", m_input.number_of_shares(),
        [&](const std::size_t share) { return bytes_of(scatterer(share, m_input.read(share), m_input.first_face(share))); });
    for (const Bytes& bytes : results)
      m_cells_of_shares.push_back(from_bytes<std::vector<std::uint32_t>>(bytes));
  }

  const Input_shares& m_input;
  Task_team& m_team;
  double m_diagonal = 0;
  Cell_tree m_tree;
  std::vector<std::vector<std::uint32_t>> m_cells_of_shares;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_INPUT_PARTITION_H
