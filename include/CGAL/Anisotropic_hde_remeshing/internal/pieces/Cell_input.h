// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_INPUT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_INPUT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bytes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_store.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

inline Vector centroid_of(const Piece_faces& faces, const std::size_t f)
{
  return (faces.point(f, 0) + faces.point(f, 1) + faces.point(f, 2)) / 3;
}

inline double longest_edge_of(const Piece_faces& faces, const std::size_t f)
{
  return (std::max)({(faces.point(f, 1) - faces.point(f, 0)).norm(), (faces.point(f, 2) - faces.point(f, 1)).norm(),
                     (faces.point(f, 0) - faces.point(f, 2)).norm()});
}

inline double mean_edge_of(const Piece_faces& faces, const std::size_t f)
{
  return ((faces.point(f, 1) - faces.point(f, 0)).norm() + (faces.point(f, 2) - faces.point(f, 1)).norm() +
          (faces.point(f, 0) - faces.point(f, 2)).norm()) /
         3;
}

// faces of the input with their numbers there and the cells in which their centroids are
struct Cell_input
{
  // How far a face may be from where a cell counts to be in the halo of the cell, in lengths of its own longest edge. On a scan,
  // functions differ by 5e-4 of the spacing from the one of the whole with 2, by 3.4e-4 with 4, and no less with 8.
  static constexpr double halo = 4;

  Piece_faces faces;
  std::vector<std::uint64_t> numbers;
  std::vector<std::uint32_t> homes;

  void add(const Cell_input& from, const std::vector<std::size_t>& selected)
  {
    std::map<std::uint32_t, std::uint32_t> index_of;
    for (const std::size_t f : selected)
    {
      std::array<std::uint32_t, 3> face{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t v = from.faces.faces[f][k];
        const auto added = index_of.emplace(v, std::uint32_t(faces.names.size()));
        if (added.second)
        {
          faces.names.push_back(from.faces.names[v]);
          faces.points.push_back(from.faces.points[v]);
        }
        face[k] = added.first->second;
      }
      faces.faces.push_back(face);
      numbers.push_back(from.numbers[f]);
      homes.push_back(from.homes[f]);
    }
  }
};

inline Byte_writer& operator<<(Byte_writer& writer, const Cell_input& input)
{
  return writer << input.faces << input.numbers << input.homes;
}
inline Byte_reader& operator>>(Byte_reader& reader, Cell_input& input)
{
  return reader >> input.faces >> input.numbers >> input.homes;
}

// Hands the faces of a share to the cells. Returns the cells that got some.
class Input_scatterer
{
public:
  Input_scatterer(const Cell_tree& tree, Piece_store& store) : m_tree(tree), m_store(store) {}

  std::vector<std::uint32_t> operator()(const std::size_t share, Piece_faces faces, const std::uint64_t first_face) const
  {
    Cell_input input;
    std::map<std::uint32_t, std::vector<std::size_t>> faces_of_cell;
    for (std::size_t f = 0; f < faces.faces.size(); ++f)
    {
      const Vector centroid = centroid_of(faces, f), reach = Vector::Constant(Cell_input::halo * longest_edge_of(faces, f));
      input.numbers.push_back(first_face + f);
      input.homes.push_back(std::uint32_t(m_tree.cell_at(centroid)));
      m_tree.visit_cells(Space_box{centroid - reach, centroid + reach},
                         [&](const std::size_t cell) { faces_of_cell[std::uint32_t(cell)].push_back(f); });
    }
    input.faces = std::move(faces);
    std::vector<std::uint32_t> cells;
    for (const auto& cell_and_faces : faces_of_cell)
    {
      Cell_input part;
      part.add(input, cell_and_faces.second);
      m_store.put(key(cell_and_faces.first, share), bytes_of(part));
      cells.push_back(cell_and_faces.first);
    }
    return cells;
  }

  static std::string key(const std::size_t cell, const std::size_t share)
  {
    return "input/" + std::to_string(cell) + "/" + std::to_string(share);
  }

private:
  const Cell_tree& m_tree;
  Piece_store& m_store;
};

// reads what the shares handed to the cells
class Input_of_cells
{
public:
  // `cells_of_shares` are those that each share returned
  Input_of_cells(const Piece_store& store, const std::size_t number_of_cells,
                 const std::vector<std::vector<std::uint32_t>>& cells_of_shares)
    : m_store(store), m_shares(number_of_cells)
  {
    for (std::size_t share = 0; share < cells_of_shares.size(); ++share)
      for (const std::uint32_t cell : cells_of_shares[share])
        m_shares[cell].push_back(share);
  }

  // the faces in the cells and in their halos, each once, in the order of the input
  Cell_input operator()(const std::size_t first_cell, const std::size_t end_of_cells) const
  {
    std::vector<Cell_input> parts;
    std::vector<std::pair<std::uint64_t, std::pair<std::size_t, std::size_t>>> order; // number, part, face
    for (std::size_t cell = first_cell; cell < end_of_cells; ++cell)
      for (const std::size_t share : m_shares[cell])
      {
        parts.push_back(from_bytes<Cell_input>(m_store.get(Input_scatterer::key(cell, share))));
        for (std::size_t f = 0; f < parts.back().numbers.size(); ++f)
          order.push_back({parts.back().numbers[f], {parts.size() - 1, f}});
      }
    std::sort(order.begin(), order.end());
    Cell_input result;
    std::unordered_map<Vertex_name, std::uint32_t> index_of; // only looked up
    for (std::size_t i = 0; i < order.size(); ++i)
      if (i == 0 || order[i].first != order[i - 1].first)
        append(parts[order[i].second.first], order[i].second.second, index_of, result);
    return result;
  }

private:
  static void append(const Cell_input& part, const std::size_t f, std::unordered_map<Vertex_name, std::uint32_t>& index_of,
                     Cell_input& result)
  {
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto added = index_of.emplace(part.faces.name(f, k), std::uint32_t(result.faces.names.size()));
      if (added.second)
      {
        result.faces.names.push_back(part.faces.name(f, k));
        result.faces.points.push_back(part.faces.point(f, k));
      }
      face[k] = added.first->second;
    }
    result.faces.faces.push_back(face);
    result.numbers.push_back(part.numbers[f]);
    result.homes.push_back(part.homes[f]);
  }

  const Piece_store& m_store;
  std::vector<std::vector<std::size_t>> m_shares; // that handed something to a cell
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_INPUT_H
