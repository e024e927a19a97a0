// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_OF_INPUT_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_OF_INPUT_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bytes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_input.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_tree.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/embedded_triangle.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// an edge of a piece behind which no face is known: a boundary edge, unless another piece has one in the other direction
struct Lone_edge
{
  Vertex_name from, to;
  std::array<double, 3> apex; // the third point of its face
};

// the faces of the input whose centroids are in a piece, with their seams
struct Piece_of_input
{
  Piece_faces faces;
  std::vector<Lone_edge> lone_edges;
  double area_in_embedding = 0;
};

// the normals at the vertices, from all faces that are known, weighted by their angles
inline std::vector<Vector> normals_of(const Piece_faces& faces)
{
  std::vector<Vector> normals(faces.points.size(), Vector::Zero());
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vector along = faces.point(f, k + 1) - faces.point(f, k), back = faces.point(f, k + 2) - faces.point(f, k);
      const Vector area = along.cross(back);
      if (area.norm() > 0)
        normals[faces.faces[f][k]] += area.normalized() * std::atan2(area.norm(), along.dot(back));
    }
  for (Vector& normal : normals)
    if (normal.norm() > 0)
      normal.normalize();
  return normals;
}

// `input` are the faces in the cells of the piece and in their halos
inline Piece_of_input piece_of_input(const Cell_input& input, const Cell_tree& tree, const std::size_t piece,
                                     const double sigma)
{
  Piece_of_input result;
  const Edge_table table(input.faces);
  const std::vector<Vector> normals = normals_of(input.faces);
  const auto piece_of = [&](const std::size_t f) { return tree.piece_of_cell(input.homes[f]); };
  std::vector<std::uint32_t> index(input.faces.names.size(), Piece_faces::nobody);
  for (std::size_t f = 0; f < input.faces.faces.size(); ++f)
  {
    if (piece_of(f) != piece)
      continue;
    std::array<std::uint32_t, 3> face{};
    std::array<double, 3> squared_lengths{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t v = input.faces.faces[f][k], w = input.faces.faces[f][(k + 1) % 3];
      if (index[v] == Piece_faces::nobody)
      {
        index[v] = std::uint32_t(result.faces.names.size());
        result.faces.names.push_back(input.faces.names[v]);
        result.faces.points.push_back(input.faces.points[v]);
      }
      face[k] = index[v];
      squared_lengths[k] = (input.faces.points[w] - input.faces.points[v]).squaredNorm() +
                           sigma * sigma * (normals[w] - normals[v]).squaredNorm();
      const std::uint32_t number = std::uint32_t(result.faces.faces.size());
      if (const Edge_table::Place* across = table.find(input.faces.names[w], input.faces.names[v]))
      {
        if (piece_of(across->face) != piece)
          result.faces.seams.push_back(Piece_faces::seam(number, k, std::uint32_t(piece_of(across->face)),
                                                         input.faces.point(across->face, across->corner + 2)));
      }
      else
      {
        const Vector& apex = input.faces.point(f, k + 2);
        result.lone_edges.push_back(Lone_edge{input.faces.names[v], input.faces.names[w], {{apex.x(), apex.y(), apex.z()}}});
      }
    }
    result.faces.faces.push_back(face);
    result.area_in_embedding += Embedded_triangle::area(squared_lengths[0], squared_lengths[1], squared_lengths[2]);
  }
  return result;
}

// Faces of very different sizes may be neighbours though they are not in each other's halos. So the pieces compare their lone edges.
// Returns the seams that were missed, for each piece.
struct Missed_seam
{
  Vertex_name from, to;
  std::uint32_t other;
  std::array<double, 3> apex;
};

inline std::vector<std::vector<Missed_seam>> missed_seams(const std::vector<std::vector<Lone_edge>>& lone_edges)
{
  struct Place
  {
    std::uint32_t piece;
    const Lone_edge* edge;
  };
  std::unordered_map<Directed_edge, Place, Hash_of_edge> places; // only looked up
  for (std::size_t piece = 0; piece < lone_edges.size(); ++piece)
    for (const Lone_edge& e : lone_edges[piece])
      places.emplace(Directed_edge(e.from, e.to), Place{std::uint32_t(piece), &e});
  std::vector<std::vector<Missed_seam>> result(lone_edges.size());
  for (std::size_t piece = 0; piece < lone_edges.size(); ++piece)
    for (const Lone_edge& e : lone_edges[piece])
    {
      const auto across = places.find(Directed_edge(e.to, e.from));
      if (across != places.end())
        result[piece].push_back(Missed_seam{e.from, e.to, across->second.piece, across->second.edge->apex});
    }
  return result;
}

inline void add_seams(Piece_faces& faces, const std::vector<Missed_seam>& missed)
{
  if (missed.empty())
    return;
  const Edge_table table(faces);
  for (const Missed_seam& seam : missed)
  {
    const Edge_table::Place& place = *table.find(seam.from, seam.to);
    faces.seams.push_back(Piece_faces::Seam{place.face, place.corner, seam.other, 0, seam.apex});
  }
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_OF_INPUT_H
