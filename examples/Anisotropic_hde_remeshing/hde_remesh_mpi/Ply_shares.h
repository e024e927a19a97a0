// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MPI_PLY_SHARES_H
#define HDE_REMESH_MPI_PLY_SHARES_H

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Input_shares.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace hde_remesh {

// The triangles of a binary PLY file, read in shares: no process has the whole file in memory. A file that is sorted in space, as scans
// usually are, is read fastest: the vertices of a share are then close together in the file.
class Ply_shares : public CGAL::Anisotropic_hde_remeshing::internal::Input_shares
{
  typedef CGAL::Anisotropic_hde_remeshing::internal::Piece_faces Piece_faces;

public:
  // reads the header. Throws Failure.
  Ply_shares(const std::string& file_name, std::uint64_t faces_of_share);

  std::size_t number_of_shares() const override;
  std::uint64_t first_face(std::size_t share) const override;
  Piece_faces read(std::size_t share) const override;

  std::uint64_t number_of_vertices() const { return m_number_of_vertices; }
  std::uint64_t number_of_faces() const { return m_number_of_faces; }

private:
  [[noreturn]] void fail(const std::string& problem) const;
  std::string bytes(std::ifstream& file, std::uint64_t from, std::uint64_t size) const;
  std::array<std::uint64_t, 3> triangle(const std::string& record, std::size_t position, std::uint64_t number) const;
  void read_points(std::ifstream& file, Piece_faces& faces) const;

  const std::string m_file_name;
  const std::uint64_t m_faces_of_share;
  std::uint64_t m_number_of_vertices = 0, m_number_of_faces = 0;
  std::uint64_t m_first_byte_of_vertices = 0, m_first_byte_of_faces = 0;
  std::size_t m_size_of_vertex = 0, m_size_of_face = 0; // with a list of three
  std::array<std::size_t, 3> m_coordinates{};           // where they begin in a vertex
  std::size_t m_list = 0, m_size_of_size = 0;           // where the list begins in a face, and how large its size is
  bool m_has_floats = false;
};

} // namespace hde_remesh

#endif // HDE_REMESH_MPI_PLY_SHARES_H
