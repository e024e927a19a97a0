// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#include "options.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <sstream>

namespace hde_remesh {

namespace {

const char* const description =
    "Remeshes a triangle mesh in pieces, on one or many machines: mpirun -n 4 hde_remesh_mpi IN OUT --faces N.\n\n"
    "IN and OUT are binary PLY files. The surface is the smooth one through the vertices of IN, and edges are measured in six\n"
    "dimensions, as by hde_remesh with --sigma. Each rank works on one piece at a time, so memory is bounded by the piece,\n"
    "whatever the mesh is. The result depends on the sizes of the pieces and cells, but not on the number of ranks or "
    "threads.\n\n"
    "Files of the pieces are kept in a folder that all ranks must see. With --folder it stays, and a run that was killed is\n"
    "resumed by the same command.";

} // namespace

int parse(int argc, char** argv, const bool speaks, Options& options)
{
  CLI::App app(description, "hde_remesh_mpi");
  app.add_option("IN", options.input, "the mesh, a binary PLY file of triangles")->required();
  app.add_option("OUT", options.output, "the result, a binary PLY file")->required();
  auto* faces = app.add_option("--faces", options.number_of_faces, "how many triangles (default: as many as IN)");
  app.add_option("--length", options.length, "the 6D length of the edges, in the unit of IN")
      ->check(CLI::PositiveNumber)
      ->excludes(faces);
  faces->check(CLI::Range(1., 4e9));
  auto* sigma = app.add_option("--sigma", options.sigma, "the weight of the normals, a fraction of the diagonal")
                    ->check(CLI::PositiveNumber)
                    ->capture_default_str();
  app.add_option("--absolute-sigma", options.absolute_sigma, "the same in the unit of IN")
      ->check(CLI::PositiveNumber)
      ->excludes(sigma);
  app.add_option("--piece", options.faces_of_piece, "the largest number of triangles of IN in a piece")
      ->check(CLI::Range(1000., 1e8))
      ->capture_default_str();
  app.add_option("--cell", options.faces_of_cell, "the largest number of triangles of IN that one function is built of")
      ->check(CLI::Range(1000., 1e8))
      ->capture_default_str();
  app.add_option("--memory", options.memory, "of a rank, such as 4G; half of it is for functions that may be of use again")
      ->transform(CLI::AsSizeValue(false))
      ->capture_default_str();
  app.add_option("--folder", options.folder, "for the files of the pieces; it stays, and a killed run is resumed from it");
  app.add_option("--threads", options.threads, "of a rank (default: all of the machine)")->check(CLI::PositiveNumber);
  app.add_flag("--quiet", options.is_quiet, "print nothing but errors");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    std::ostringstream out, messages;
    const int status = app.exit(error, out, messages) == 0 ? 0 : 2;
    if (speaks)
    {
      std::cout << out.str() << std::flush;
      std::cerr << messages.str() << std::flush;
    }
    return status;
  }
  return -1;
}

std::string description_of(const Options& options)
{
  std::ostringstream text;
  text.precision(17);
  text << std::filesystem::absolute(options.input).string() << " of " << std::filesystem::file_size(options.input)
       << " bytes, --faces " << options.number_of_faces << " --length " << options.length << " --sigma " << options.sigma
       << " --absolute-sigma " << options.absolute_sigma << " --piece " << options.faces_of_piece << " --cell "
       << options.faces_of_cell;
  return text.str();
}

} // namespace hde_remesh
