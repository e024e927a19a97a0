// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_FACES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_FACES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Names a vertex in all pieces. A vertex of the input has its number there. A new vertex has the number of the piece or region that
// made it, from 1 on, in the upper bits.
typedef std::uint64_t Vertex_name;
constexpr int bits_of_number = 40;
constexpr Vertex_name largest_number_of_input = (Vertex_name(1) << bits_of_number) - 1;

inline bool is_of_input(const Vertex_name name) { return name <= largest_number_of_input; }

// Some faces of a mesh whose other faces are elsewhere. They know the edges behind which the others are, the seams, so that these are
// told from the boundary of the whole mesh.
struct Piece_faces
{
  static constexpr std::uint32_t nobody = (std::numeric_limits<std::uint32_t>::max)();

  struct Seam
  {
    std::uint32_t face; // whose edge from its corner `corner` to the next one it is
    std::uint32_t corner;
    std::uint32_t other;        // the piece behind it, or nobody where that does not matter any more
    std::uint32_t padding;      // so that all bytes of the files are defined
    std::array<double, 3> apex; // the third point of the face behind it when the seam was made
  };

  std::vector<Vertex_name> names;
  std::vector<Vector> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<Seam> seams;

  Vertex_name name(const std::size_t face, const std::size_t corner) const { return names[faces[face][corner % 3]]; }
  const Vector& point(const std::size_t face, const std::size_t corner) const { return points[faces[face][corner % 3]]; }

  static Seam seam(const std::size_t face, const std::size_t corner, const std::uint32_t other, const Vector& apex)
  {
    return Seam{std::uint32_t(face), std::uint32_t(corner), other, 0, {{apex.x(), apex.y(), apex.z()}}};
  }
};

typedef std::pair<Vertex_name, Vertex_name> Directed_edge;

struct Hash_of_edge
{
  std::size_t operator()(const Directed_edge& e) const
  {
    std::uint64_t h = e.first * 0x9e3779b97f4a7c15ull ^ (e.second + 0x7f4a7c159e3779b9ull) * 0xbf58476d1ce4e5b9ull;
    h ^= h >> 29;
    return std::size_t(h * 0x94d049bb133111ebull);
  }
};

// Finds the face on an edge. It throws where two faces have an edge in the same direction: the mesh is no oriented manifold there.
class Edge_table
{
public:
  struct Place
  {
    std::uint32_t face, corner;
  };

  explicit Edge_table(const Piece_faces& faces)
  {
    m_places.reserve(3 * faces.faces.size());
    for (std::size_t f = 0; f < faces.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Directed_edge e(faces.name(f, k), faces.name(f, k + 1));
        if (!m_places.emplace(e, Place{std::uint32_t(f), std::uint32_t(k)}).second)
          throw std::invalid_argument("two faces have the edge from vertex " + std::to_string(e.first) + " to " +
                                      std::to_string(e.second) + " in the same direction: the mesh is no oriented manifold");
      }
  }

  // none if there is no such face
  const Place* find(const Vertex_name from, const Vertex_name to) const
  {
    const auto found = m_places.find(Directed_edge(from, to));
    return found == m_places.end() ? nullptr : &found->second;
  }

private:
  std::unordered_map<Directed_edge, Place, Hash_of_edge> m_places; // only looked up: its order is nowhere
};

// appends faces; vertices of the same name become one
class Faces_merger
{
public:
  void add(const Piece_faces& part)
  {
    std::vector<std::uint32_t> index(part.names.size());
    for (std::size_t i = 0; i < part.names.size(); ++i)
    {
      const auto added = m_index_of.emplace(part.names[i], std::uint32_t(m_result.names.size()));
      if (added.second)
      {
        m_result.names.push_back(part.names[i]);
        m_result.points.push_back(part.points[i]);
      }
      index[i] = added.first->second;
    }
    const std::uint32_t first_face = std::uint32_t(m_result.faces.size());
    for (const auto& face : part.faces)
      m_result.faces.push_back({{index[face[0]], index[face[1]], index[face[2]]}});
    for (Piece_faces::Seam seam : part.seams)
    {
      seam.face += first_face;
      m_result.seams.push_back(seam);
    }
  }

  // seams whose other side has been added are none any more
  Piece_faces result()
  {
    const Edge_table table(m_result);
    std::vector<Piece_faces::Seam> seams;
    for (const Piece_faces::Seam& seam : m_result.seams)
      if (table.find(m_result.name(seam.face, seam.corner + 1), m_result.name(seam.face, seam.corner)) == nullptr)
        seams.push_back(seam);
    m_result.seams.swap(seams);
    return std::move(m_result);
  }

private:
  std::unordered_map<Vertex_name, std::uint32_t> m_index_of; // only looked up
  Piece_faces m_result;
};

// Straightens the borders between labels: a face that has two neighbours of another label takes it, a few times over. Otherwise single
// faces stick out between two parts, and what is remeshed between such borders gets bad angles there.
inline void straighten_labels(const Piece_faces& faces, std::vector<std::uint32_t>& labels)
{
  static constexpr int number_of_rounds = 6; // nearly all is done in the first ones
  const Edge_table table(faces);
  std::vector<std::array<const Edge_table::Place*, 3>> across(faces.faces.size());
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      across[f][k] = table.find(faces.name(f, k + 1), faces.name(f, k));
  for (int round = 0; round < number_of_rounds; ++round)
  {
    const std::vector<std::uint32_t> before = labels;
    for (std::size_t f = 0; f < faces.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Edge_table::Place *one = across[f][k], *other = across[f][(k + 1) % 3];
        // of two faces that would exchange their labels, one does it in each round
        if (one != nullptr && other != nullptr && before[one->face] == before[other->face] && before[one->face] != before[f] &&
            (before[one->face] < before[f]) == (round % 2 == 0))
          labels[f] = before[one->face];
      }
  }
}

// Divides faces by labels, one for each face. The edges between two labels become seams of both parts.
inline std::map<std::uint32_t, Piece_faces> split_by_label(const Piece_faces& faces, const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, Piece_faces> parts;
  std::map<std::uint32_t, std::unordered_map<std::uint32_t, std::uint32_t>> index_of;
  std::vector<std::uint32_t> new_face(faces.faces.size());
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
  {
    Piece_faces& part = parts[labels[f]];
    auto& index_in_part = index_of[labels[f]];
    std::array<std::uint32_t, 3> face{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t v = faces.faces[f][k];
      const auto added = index_in_part.emplace(v, std::uint32_t(part.names.size()));
      if (added.second)
      {
        part.names.push_back(faces.names[v]);
        part.points.push_back(faces.points[v]);
      }
      face[k] = added.first->second;
    }
    new_face[f] = std::uint32_t(part.faces.size());
    part.faces.push_back(face);
  }
  for (const Piece_faces::Seam& seam : faces.seams)
  {
    Piece_faces::Seam moved = seam;
    moved.face = new_face[seam.face];
    parts[labels[seam.face]].seams.push_back(moved);
  }
  if (parts.size() < 2)
    return parts;
  const Edge_table table(faces);
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Edge_table::Place* across = table.find(faces.name(f, k + 1), faces.name(f, k));
      if (across != nullptr && labels[across->face] != labels[f])
        parts[labels[f]].seams.push_back(
            Piece_faces::seam(new_face[f], k, Piece_faces::nobody, faces.point(across->face, across->corner + 2)));
    }
  return parts;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_FACES_H
