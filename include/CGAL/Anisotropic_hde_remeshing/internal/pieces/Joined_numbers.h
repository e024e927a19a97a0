// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_JOINED_NUMBERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_JOINED_NUMBERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_counts.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The numbers of vertices and faces in the joined mesh. They follow the order of the holders of the faces, and so the order of the
// pieces in space. A vertex that several holders share belongs to the first of them.
class Joined_numbers
{
public:
  // what a holder contributes to the joined mesh
  struct Part
  {
    std::uint64_t first_vertex = 0, first_face = 0;
    std::vector<Vector> points; // from the first vertex on
    std::vector<std::array<std::uint64_t, 3>> faces;
  };

  explicit Joined_numbers(const std::vector<Piece_counts>& counts)
  {
    for (const Piece_counts& c : counts)
    {
      m_first_vertex.push_back(m_number_of_vertices);
      m_first_face.push_back(m_number_of_faces);
      for (const Vertex_name name : c.shared)
        if (m_number_of_shared.emplace(name, m_number_of_vertices).second)
          ++m_number_of_vertices;
      m_number_of_vertices += c.number_of_own_vertices;
      m_number_of_faces += c.number_of_faces;
    }
  }

  std::uint64_t number_of_vertices() const { return m_number_of_vertices; }
  std::uint64_t number_of_faces() const { return m_number_of_faces; }

  Part part(const std::size_t holder, const Piece_faces& faces) const
  {
    Part result;
    result.first_vertex = m_first_vertex[holder];
    result.first_face = m_first_face[holder];
    // those of the shared vertices that are this holder's own come first
    std::vector<std::uint64_t> number(faces.names.size());
    std::vector<char> is_shared(faces.names.size(), 0);
    std::uint64_t next = result.first_vertex;
    for (std::size_t v = 0; v < faces.names.size(); ++v)
    {
      const auto found = m_number_of_shared.find(faces.names[v]);
      if (found == m_number_of_shared.end())
        continue;
      is_shared[v] = 1;
      number[v] = found->second;
      if (number[v] >= result.first_vertex)
        next = (std::max)(next, number[v] + 1);
    }
    result.points.resize(next - result.first_vertex);
    for (std::size_t v = 0; v < faces.names.size(); ++v)
      if (!is_shared[v])
      {
        number[v] = next++;
        result.points.push_back(faces.points[v]);
      }
      else if (number[v] >= result.first_vertex)
        result.points[number[v] - result.first_vertex] = faces.points[v];
    for (const auto& face : faces.faces)
      result.faces.push_back({{number[face[0]], number[face[1]], number[face[2]]}});
    return result;
  }

private:
  std::uint64_t m_number_of_vertices = 0, m_number_of_faces = 0;
  std::vector<std::uint64_t> m_first_vertex, m_first_face;
  std::unordered_map<Vertex_name, std::uint64_t> m_number_of_shared; // only looked up
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_JOINED_NUMBERS_H
