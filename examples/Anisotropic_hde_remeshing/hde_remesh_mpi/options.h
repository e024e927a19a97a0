// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_MPI_OPTIONS_H
#define HDE_REMESH_MPI_OPTIONS_H

#include <cstdint>
#include <string>

namespace hde_remesh {

struct Options
{
  std::string input, output, folder;
  double number_of_faces = 0, length = 0; // 0: not given
  double sigma = 0.01;                    // of the diagonal
  double absolute_sigma = 0;              // 0: not given
  std::uint64_t faces_of_piece = 500000, faces_of_cell = 40000;
  std::uint64_t memory = std::uint64_t(2) << 30; // of a rank, in bytes, that functions may keep half of
  int threads = 0;                               // 0: all of the machine
  bool is_quiet = false;
};

// Returns -1 if the program is to go on, and else the exit status: it was asked for help, or the command line makes no sense. Only one
// rank `speaks`.
int parse(int argc, char** argv, bool speaks, Options& options);

// what the result depends on, to tell runs apart
std::string description_of(const Options& options);

} // namespace hde_remesh

#endif // HDE_REMESH_MPI_OPTIONS_H
