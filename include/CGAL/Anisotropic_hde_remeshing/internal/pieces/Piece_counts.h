// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_COUNTS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_COUNTS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bytes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What a piece contributes to the topology of the whole: sums, and how its components and boundaries hang together at the vertices that
// it shares with others.
struct Piece_counts
{
  std::uint64_t number_of_faces = 0, number_of_boundary_edges = 0, number_of_own_vertices = 0; // own: not on seams
  std::uint64_t number_of_components = 0, number_of_chains = 0;                                // chains of boundary edges
  std::uint64_t balance =
      0; // over all pieces it is zero if each seam fits to that of one other piece, with all bits of its points
  std::vector<Vertex_name> shared;             // on seams, sorted
  std::vector<std::uint32_t> component, chain; // of each of them; nobody if it is not on the boundary
};

inline Byte_writer& operator<<(Byte_writer& w, const Piece_counts& c)
{
  return w << c.number_of_faces << c.number_of_boundary_edges << c.number_of_own_vertices << c.number_of_components
           << c.number_of_chains << c.balance << c.shared << c.component << c.chain;
}
inline Byte_reader& operator>>(Byte_reader& r, Piece_counts& c)
{
  return r >> c.number_of_faces >> c.number_of_boundary_edges >> c.number_of_own_vertices >> c.number_of_components >>
         c.number_of_chains >> c.balance >> c.shared >> c.component >> c.chain;
}

// numbers the sets that have members, in the order of these
inline std::vector<std::uint32_t> numbers_of_sets(Disjoint_sets& sets, const std::vector<char>& is_member,
                                                  std::uint64_t& number)
{
  std::vector<std::uint32_t> number_of_set(is_member.size(), Piece_faces::nobody),
      result(is_member.size(), Piece_faces::nobody);
  number = 0;
  for (std::size_t i = 0; i < is_member.size(); ++i)
    if (is_member[i])
    {
      std::uint32_t& n = number_of_set[sets.find_set(i)];
      if (n == Piece_faces::nobody)
        n = std::uint32_t(number++);
      result[i] = n;
    }
  return result;
}

inline std::uint64_t hash_of_edge_and_points(const Piece_faces& faces, const std::uint32_t from, const std::uint32_t to)
{
  std::uint64_t h = 0;
  for (const std::uint32_t v : {from, to})
  {
    h = (h ^ faces.names[v]) * 0x9e3779b97f4a7c15ull;
    for (int axis = 0; axis < 3; ++axis)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &faces.points[v][axis], sizeof bits);
      h = ((h ^ (h >> 31)) ^ bits) * 0xbf58476d1ce4e5b9ull;
    }
  }
  return h ^ (h >> 29);
}

inline Piece_counts counts_of(const Piece_faces& faces)
{
  Piece_counts result;
  result.number_of_faces = faces.faces.size();
  // a vertex may be there several times, as a copy for each fan
  std::vector<Vertex_name> names = faces.names;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const auto index_of = [&](const std::uint32_t v)
  { return std::size_t(std::lower_bound(names.begin(), names.end(), faces.names[v]) - names.begin()); };
  std::vector<char> is_shared(names.size(), 0), is_used(names.size(), 0), is_on_boundary(names.size(), 0);
  std::vector<char> is_seam(3 * faces.faces.size(), 0);
  for (const Piece_faces::Seam& seam : faces.seams)
  {
    const auto& face = faces.faces[seam.face];
    const std::uint32_t from = face[seam.corner], to = face[(seam.corner + 1) % 3];
    is_seam[3 * seam.face + seam.corner] = 1;
    is_shared[index_of(from)] = is_shared[index_of(to)] = 1;
    result.balance += hash_of_edge_and_points(faces, from, to) - hash_of_edge_and_points(faces, to, from);
  }
  Disjoint_sets components(names.size()), chains(names.size());
  const Edge_table table(faces);
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t from = index_of(faces.faces[f][k]), to = index_of(faces.faces[f][(k + 1) % 3]);
      is_used[from] = 1;
      components.union_set(from, to);
      if (is_seam[3 * f + k] || table.find(names[to], names[from]) != nullptr)
        continue;
      ++result.number_of_boundary_edges;
      is_on_boundary[from] = is_on_boundary[to] = 1;
      chains.union_set(from, to);
    }
  const auto component = numbers_of_sets(components, is_used, result.number_of_components);
  const auto chain = numbers_of_sets(chains, is_on_boundary, result.number_of_chains);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (is_shared[i])
    {
      result.shared.push_back(names[i]);
      result.component.push_back(component[i]);
      result.chain.push_back(chain[i]);
    }
    else
      ++result.number_of_own_vertices;
  return result;
}

// the topology of the whole
struct Joint_topology
{
  std::uint64_t number_of_vertices = 0, number_of_faces = 0, number_of_boundary_edges = 0;
  std::uint64_t number_of_components = 0, number_of_boundary_loops = 0;
  std::int64_t euler_characteristic = 0;
  bool is_joined = false; // whether all seams fit
};

inline Joint_topology joint_topology(const std::vector<Piece_counts>& pieces)
{
  Joint_topology result;
  std::uint64_t balance = 0;
  std::vector<std::size_t> first_component, first_chain;
  std::size_t number_of_components = 0, number_of_chains = 0;
  for (const Piece_counts& piece : pieces)
  {
    result.number_of_faces += piece.number_of_faces;
    result.number_of_boundary_edges += piece.number_of_boundary_edges;
    result.number_of_vertices += piece.number_of_own_vertices;
    balance += piece.balance;
    first_component.push_back(number_of_components);
    first_chain.push_back(number_of_chains);
    number_of_components += piece.number_of_components;
    number_of_chains += piece.number_of_chains;
  }
  Disjoint_sets components(number_of_components), chains(number_of_chains);
  std::uint64_t joints_of_components = 0, joints_of_chains = 0;
  const auto join = [](Disjoint_sets& sets, const std::size_t a, const std::size_t b, std::uint64_t& joints)
  {
    if (sets.find_set(a) != sets.find_set(b))
      ++joints;
    sets.union_set(a, b);
  };
  struct First
  {
    std::size_t component, chain;
  };
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::unordered_map<Vertex_name, First> first_of; // only looked up
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < pieces[i].shared.size(); ++k)
    {
      const std::size_t component = first_component[i] + pieces[i].component[k];
      const std::size_t chain = pieces[i].chain[k] == Piece_faces::nobody ? none : first_chain[i] + pieces[i].chain[k];
      First& first = first_of.emplace(pieces[i].shared[k], First{component, none}).first->second;
      join(components, first.component, component, joints_of_components);
      if (chain == none)
        continue;
      if (first.chain == none)
        first.chain = chain;
      join(chains, first.chain, chain, joints_of_chains);
    }
  result.number_of_vertices += first_of.size();
  result.number_of_components = number_of_components - joints_of_components;
  result.number_of_boundary_loops = number_of_chains - joints_of_chains;
  result.euler_characteristic = std::int64_t(result.number_of_vertices + result.number_of_faces) -
                                std::int64_t((3 * result.number_of_faces + result.number_of_boundary_edges) / 2);
  result.is_joined = balance == 0;
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECE_COUNTS_H
