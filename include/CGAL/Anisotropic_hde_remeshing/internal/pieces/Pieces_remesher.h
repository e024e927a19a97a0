// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECES_REMESHER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECES_REMESHER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bands.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Bytes.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Corners.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Input_partition.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_counts.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_of_input.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_store.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Region_remesher.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Task_team.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

struct Pieces_request
{
  double sigma = 0;                  // 0: the relative one
  double relative_sigma = 0.01;      // of the diagonal of the bounding box
  double target_edge_length = 0;     // 0: from the number of faces
  double number_of_target_faces = 0; // 0: as many as the input has
  std::uint64_t faces_of_piece = 500000, faces_of_cell = 40000;
  unsigned int number_of_rings = 6; // of a band, on each side of the interface
  double corner_radius = 8;         // in target lengths, so that where two bands lie side by side is inside
  std::size_t memory_of_functions = std::size_t(1) << 30; // for each process
};

struct Pieces_result
{
  double diagonal = 0, sigma = 0, target_edge_length = 0;
  std::size_t number_of_cells = 0, number_of_pieces = 0, number_of_bands = 0, number_of_corners = 0;
  Joint_topology before, after;
  Region_report of_pieces, of_bands, of_corners;
  std::vector<std::string> holders; // the keys of the faces of the result in the store
  std::vector<Piece_counts> counts; // of the holders
};

// Remeshes the input in three rounds: pieces between the seams that the input has there; bands along these seams, one for each two
// pieces; and regions about the vertices that are left, where several pieces met. In each round the seams stay, so all
// pieces, bands or regions can be remeshed at once, and the mesh is joined again after it. Everything follows from the
// input and the request: not from who does a task, nor from the threads.
template <typename ConcurrencyTag, typename NamedParameters, typename FunctionParameters>
class Pieces_remesher
{
  typedef Cell_functions<ConcurrencyTag, FunctionParameters> Functions;

public:
  // `np` are for the remeshing, without sigma and a target
  Pieces_remesher(const Input_shares& input, Task_team& team, Piece_store& store, const Pieces_request& request,
                  const NamedParameters& np, const FunctionParameters& np_of_function)
    : m_team(team),
      m_store(store),
      m_request(request),
      m_np(np),
      m_np_of_function(np_of_function),
      m_partition(input, team, store, request.faces_of_piece, request.faces_of_cell),
      m_input_of_cells(m_partition.input_of_cells(store)),
      m_functions(m_partition.tree(), m_input_of_cells, m_np_of_function, request.memory_of_functions)
  {
    if (!(m_request.sigma > 0))
      m_request.sigma = m_request.relative_sigma * m_partition.diagonal();
  }

  // puts the pieces of the result into the store
  Pieces_result operator()()
  {
    m_result.sigma = m_request.sigma;
    m_result.diagonal = m_partition.diagonal();
    const std::size_t pieces = m_partition.tree().number_of_pieces();
    m_result.number_of_pieces = pieces;
    m_result.number_of_cells = m_partition.tree().number_of_cells();
    prepare_pieces(pieces);
    const Region_remesher<ConcurrencyTag, Functions, NamedParameters> remesh(m_functions, m_np, m_request.sigma,
                                                                             m_result.target_edge_length);
    remesh_pieces(pieces, remesh);
    remesh_bands(pieces, remesh);
    remesh_corners(pieces, remesh);
    count_result();
    return std::move(m_result);
  }

private:
  typedef std::pair<std::uint32_t, std::uint32_t> Pair_of_pieces;

  static std::string key(const std::string& kind, const std::size_t i) { return kind + "/" + std::to_string(i); }
  static std::string key(const std::string& kind, const std::size_t i, const std::size_t j)
  {
    return key(kind, i) + "/" + std::to_string(j);
  }

  // cuts the pieces out of the input, and finds the target length from the areas of all
  void prepare_pieces(const std::size_t pieces)
  {
    const std::vector<Bytes> results = m_team.run("prepare", pieces,
                                                  [&](const std::size_t piece)
                                                  {
                                                    const auto cells = m_partition.tree().cells_of_piece(piece);
                                                    const Piece_of_input cut =
                                                        piece_of_input(m_input_of_cells(cells.first, cells.second),
                                                                       m_partition.tree(), piece, m_request.sigma);
                                                    m_store.put(key("piece", piece), bytes_of(cut.faces));
                                                    Byte_writer writer;
                                                    writer << cut.area_in_embedding << cut.lone_edges;
                                                    return writer.take();
                                                  });
    double area = 0;
    std::vector<std::vector<Lone_edge>> lone_edges(pieces);
    for (std::size_t piece = 0; piece < pieces; ++piece)
    {
      double area_of_piece = 0;
      Byte_reader reader(results[piece]);
      reader >> area_of_piece >> lone_edges[piece];
      area += area_of_piece;
    }
    m_missed_seams = missed_seams(lone_edges);
    const double number =
        m_request.number_of_target_faces > 0 ? m_request.number_of_target_faces : double(m_partition.number_of_faces());
    m_result.target_edge_length =
        m_request.target_edge_length > 0 ? m_request.target_edge_length : std::sqrt(area / (0.25 * std::sqrt(3.) * number));
  }

  // puts the parts of a piece near its seams, by the piece behind them, and the rest
  template <typename Remesh>
  Bytes remesh_piece(const std::size_t piece, const Remesh& remesh)
  {
    Piece_faces faces = from_bytes<Piece_faces>(m_store.get(key("piece", piece)));
    add_seams(faces, m_missed_seams[piece]);
    const Piece_counts counts = counts_of(faces);
    Region_report report;
    std::vector<char> is_thin;
    faces = remesh(faces, std::uint32_t(piece), report, is_thin);
    const std::vector<std::uint32_t> labels = band_labels(faces, m_request.number_of_rings);
    std::vector<std::uint32_t> others;
    Piece_faces rest;
    for (auto& part : split_by_label(faces, labels))
      if (part.first == Piece_faces::nobody)
        rest = std::move(part.second);
      else
      {
        others.push_back(part.first);
        m_store.put(key("band", piece, part.first), bytes_of(part.second));
      }
    m_store.put(key("rest", piece), bytes_of(rest));
    Byte_writer writer;
    writer << report << others << counts
           << vertices_of_faces(faces, [&](const std::size_t f) { return is_thin[f] && labels[f] == Piece_faces::nobody; });
    return writer.take();
  }

  template <typename Remesh>
  void remesh_pieces(const std::size_t pieces, const Remesh& remesh)
  {
    const std::vector<Bytes> results =
        m_team.run("pieces", pieces, [&](const std::size_t piece) { return remesh_piece(piece, remesh); });
    std::set<Pair_of_pieces> pairs;
    std::vector<Piece_counts> all_counts(pieces);
    for (std::size_t piece = 0; piece < pieces; ++piece)
    {
      Region_report report;
      std::vector<std::uint32_t> others;
      std::vector<Frozen_vertex> thin;
      Byte_reader reader(results[piece]);
      reader >> report >> others >> all_counts[piece] >> thin;
      m_frozen_vertices.insert(m_frozen_vertices.end(), thin.begin(), thin.end());
      m_result.of_pieces.add(report);
      for (const std::uint32_t other : others)
      {
        const Pair_of_pieces pair = std::minmax(std::uint32_t(piece), other);
        pairs.insert(pair);
        m_sides_of_band[pair].push_back(key("band", piece, other));
      }
    }
    m_bands.assign(pairs.begin(), pairs.end());
    m_result.number_of_bands = m_bands.size();
    m_result.before = joint_topology(all_counts);
  }

  template <typename Remesh>
  Bytes remesh_band(const std::size_t pieces, const std::size_t band, const Remesh& remesh)
  {
    Region_report report;
    std::vector<char> is_thin;
    const Piece_faces faces = remesh(merged(m_sides_of_band.at(m_bands[band])), std::uint32_t(pieces + band), report, is_thin);
    m_store.put(key("remeshed_band", band), bytes_of(faces));
    std::vector<Frozen_vertex> frozen = frozen_vertices(faces);
    for (const Frozen_vertex& thin : vertices_of_faces(faces, [&](const std::size_t f) { return is_thin[f] != 0; }))
      frozen.push_back(thin);
    Byte_writer writer;
    writer << report << frozen;
    return writer.take();
  }

  template <typename Remesh>
  void remesh_bands(const std::size_t pieces, const Remesh& remesh)
  {
    const std::vector<Bytes> results =
        m_team.run("bands", m_bands.size(), [&](const std::size_t band) { return remesh_band(pieces, band, remesh); });
    for (const Bytes& bytes : results)
    {
      Region_report report;
      std::vector<Frozen_vertex> frozen;
      Byte_reader reader(bytes);
      reader >> report >> frozen;
      m_result.of_bands.add(report);
      m_frozen_vertices.insert(m_frozen_vertices.end(), frozen.begin(), frozen.end());
    }
  }

  // the faces of the first two rounds, by holder
  std::string holder(const std::size_t pieces, const std::size_t i) const
  {
    return i < pieces ? key("rest", i) : key("remeshed_band", i - pieces);
  }

  template <typename Remesh>
  void remesh_corners(const std::size_t pieces, const Remesh& remesh)
  {
    const Corner_regions regions(m_frozen_vertices, m_request.corner_radius * m_result.target_edge_length);
    const std::size_t holders = pieces + m_bands.size();
    const std::vector<Bytes> parts = m_team.run("cut_corners", holders,
                                                [&](const std::size_t i)
                                                {
                                                  const Piece_faces faces =
                                                      from_bytes<Piece_faces>(m_store.get(holder(pieces, i)));
                                                  std::vector<std::uint32_t> touched;
                                                  Piece_faces rest;
                                                  for (auto& part : split_by_label(faces, regions.labels(faces)))
                                                    if (part.first == Piece_faces::nobody)
                                                      rest = std::move(part.second);
                                                    else
                                                    {
                                                      touched.push_back(part.first);
                                                      m_store.put(key("corner", part.first, i), bytes_of(part.second));
                                                    }
                                                  m_store.put(key("core", i), bytes_of(rest));
                                                  return bytes_of(touched);
                                                });
    std::vector<std::vector<std::string>> keys_of_region(regions.number_of_regions());
    for (std::size_t i = 0; i < holders; ++i)
    {
      for (const std::uint32_t region : from_bytes<std::vector<std::uint32_t>>(parts[i]))
        keys_of_region[region].push_back(key("corner", region, i));
      m_result.holders.push_back(key("core", i));
    }
    const std::vector<Bytes> results =
        m_team.run("corners", regions.number_of_regions(),
                   [&](const std::size_t region)
                   {
                     Region_report report;
                     std::vector<char> is_thin;
                     const Piece_faces faces =
                         remesh(merged(keys_of_region[region]), std::uint32_t(holders + region), report, is_thin);
                     report.number_of_thin_faces = std::uint64_t(std::count(is_thin.begin(), is_thin.end(), char(1)));
                     m_store.put(key("remeshed_corner", region), bytes_of(faces));
                     return bytes_of(report);
                   });
    for (std::size_t region = 0; region < results.size(); ++region)
    {
      m_result.of_corners.add(from_bytes<Region_report>(results[region]));
      m_result.holders.push_back(key("remeshed_corner", region));
    }
    m_result.number_of_corners = results.size();
  }

  void count_result()
  {
    const std::vector<Bytes> results = m_team.run(
        "count_result", m_result.holders.size(),
        [&](const std::size_t i) { return bytes_of(counts_of(from_bytes<Piece_faces>(m_store.get(m_result.holders[i])))); });
    for (const Bytes& bytes : results)
      m_result.counts.push_back(from_bytes<Piece_counts>(bytes));
    m_result.after = joint_topology(m_result.counts);
  }

  Piece_faces merged(const std::vector<std::string>& keys) const
  {
    Faces_merger merger;
    for (const std::string& k : keys)
      merger.add(from_bytes<Piece_faces>(m_store.get(k)));
    return merger.result();
  }

  Task_team& m_team;
  Piece_store& m_store;
  Pieces_request m_request;
  const NamedParameters m_np;
  const FunctionParameters m_np_of_function;
  const Input_partition m_partition;
  const Input_of_cells m_input_of_cells;
  Functions m_functions;
  std::vector<std::vector<Missed_seam>> m_missed_seams;
  std::vector<Pair_of_pieces> m_bands;
  std::map<Pair_of_pieces, std::vector<std::string>> m_sides_of_band;
  std::vector<Frozen_vertex> m_frozen_vertices;
  Pieces_result m_result;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_PIECES_REMESHER_H
