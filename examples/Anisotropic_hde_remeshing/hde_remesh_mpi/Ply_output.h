// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MPI_PLY_OUTPUT_H
#define HDE_REMESH_MPI_PLY_OUTPUT_H

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Joined_numbers.h>

#include <cstdint>
#include <string>

namespace hde_remesh {

// One binary PLY file that many processes write. It has another name until it is whole.
class Ply_output
{
public:
  // Throws Failure if the file cannot be written or has too many vertices for its indices.
  Ply_output(const std::string& file_name, std::uint64_t number_of_vertices, std::uint64_t number_of_faces);

  // makes the file in its full size, with its header; by one process
  void begin() const;
  // the vertices and faces of one holder, at their places
  void write(const CGAL::Anisotropic_hde_remeshing::internal::Joined_numbers::Part& part) const;
  // gives the file its name; by one process, when all is written
  void finish() const;
  // removes what is there of a file that will not be finished
  void abandon() const noexcept;

  // fails if a file of this name cannot be written
  static void check(const std::string& file_name);

private:
  std::string m_name, m_part_name, m_header;
  std::uint64_t m_number_of_vertices, m_number_of_faces;
};

} // namespace hde_remesh

#endif // HDE_REMESH_MPI_PLY_OUTPUT_H
