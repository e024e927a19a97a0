// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes CGAL's bunny, resampled to many faces, as a whole and in pieces, and compares the results: their angles and lengths in the
// embedding, their distances, and the faces at old seams with the others; and the processor time of both.
//   benchmark_pieces MESH FACES_OF_INPUT NUMBER_OF_PIECES [RESAMPLED.ply]
// The result has half of the faces. The resampled mesh is written for hde_remesh_mpi.

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include "Table.h"
#include "pieces.h"
#include "seconds_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace internal = pieces::internal;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, pieces::Concurrency_tag> Function;

struct Angles
{
  double least = 180, sum = 0;
  std::size_t number = 0;
};

// of the faces of a range of holders
Angles angles_of(const pieces::Remeshed& remeshed, const std::size_t first, const std::size_t end, const Function& function,
                 const double sigma)
{
  Angles angles;
  std::size_t face = 0;
  for (std::size_t holder = 0; holder < end; ++holder)
    for (std::size_t k = 0; k < remeshed.result.counts[holder].number_of_faces; ++k, ++face)
    {
      if (holder < first)
        continue;
      std::array<internal::Vector, 3> p, n;
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] = remeshed.points[remeshed.faces[face][c]];
        n[c] = internal::gradient_of(function, p[c]).normalized();
      }
      std::array<double, 3> l{};
      for (std::size_t c = 0; c < 3; ++c)
        l[c] = (p[c] - p[(c + 1) % 3]).squaredNorm() + sigma * sigma * (n[c] - n[(c + 1) % 3]).squaredNorm();
      const double angle = std::acos(internal::Embedded_triangle::largest_cosine(l[0], l[1], l[2])) * 180 / CGAL_PI;
      angles.least = (std::min)(angles.least, angle);
      angles.sum += angle;
      ++angles.number;
    }
  return angles;
}

void add_measures(Table& table, const std::string& name, const Mesh& mesh, const Function& function, const double sigma,
                  const double processor_seconds)
{
  const auto e = Hde::measure_embedding<pieces::Concurrency_tag>(mesh, function, params::sigma(sigma));
  const auto z = Hde::measure_distance_to_zero_set<pieces::Concurrency_tag>(mesh, function);
  table.add(name, mesh.number_of_faces(), e.minimum_angle_mean, e.minimum_angle_least, e.share_within_sqrt_2, z.face_rms,
            z.face_max, processor_seconds);
}

void add_angles(Table& table, const std::string& name, const Angles& angles)
{
  table.add(name, angles.number, angles.sum / double(angles.number), angles.least);
}

void compare(const Mesh& input, const std::size_t number_of_pieces)
{
  internal::Pieces_request request;
  request.sigma = 0.02 * internal::diagonal_of(CGAL::Polygon_mesh_processing::bbox(input));
  request.number_of_target_faces = double(input.number_of_faces() / 2);
  request.faces_of_piece = std::uint64_t(1.05 * double(input.number_of_faces()) / double(number_of_pieces));
  request.faces_of_cell = (std::min)(request.faces_of_cell, request.faces_of_piece);

  const auto shares = pieces::shares_of(input, 1000000);
  pieces::Remeshed remeshed;
  const double seconds_in_pieces = processor_seconds_of([&] { remeshed = pieces::remesh(shares, request); });
  std::unique_ptr<const Function> function;
  Mesh serial = input;
  const double seconds_serial = processor_seconds_of(
      [&]
      {
        function = std::make_unique<const Function>(input, params::close_holes(false));
        CGAL::anisotropic_hde_remeshing<pieces::Concurrency_tag>(
            serial, *function, params::sigma(request.sigma).number_of_target_faces(input.number_of_faces() / 2));
      });
  const internal::Pieces_result& result = remeshed.result;
  Table table(std::to_string(input.number_of_faces()) + " faces, " + std::to_string(result.number_of_pieces) + " pieces, " +
              std::to_string(result.number_of_cells) + " cells, " + std::to_string(result.number_of_bands) + " bands, " +
              std::to_string(result.number_of_corners) + " corners");
  table.add("", "faces", "mean angle", "least", "good lengths", "rms", "max", "processor s");
  add_measures(table, "serial", serial, *function, request.sigma, seconds_serial);
  add_measures(table, "in pieces", remeshed.mesh<Mesh>(), *function, request.sigma, seconds_in_pieces);
  add_angles(table, "  at old seams",
             angles_of(remeshed, result.number_of_pieces, result.holders.size(), *function, request.sigma));
  add_angles(table, "  elsewhere", angles_of(remeshed, 0, result.number_of_pieces, *function, request.sigma));
  table.print();
  std::cout << "work over that of the serial run: " << seconds_in_pieces / seconds_serial << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::cerr << "usage: " << argv[0] << " MESH FACES_OF_INPUT NUMBER_OF_PIECES [RESAMPLED.ply]" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    Mesh input;
    if (!CGAL::IO::read_polygon_mesh(argv[1], input))
      throw std::runtime_error(std::string("cannot read ") + argv[1]);
    CGAL::anisotropic_hde_remeshing<pieces::Concurrency_tag>(
        input, params::number_of_target_faces(std::stoul(argv[2])).sigma(0).number_of_iterations(3));
    if (argc > 4 && !CGAL::IO::write_polygon_mesh(argv[4], input, CGAL::parameters::use_binary_mode(true)))
      throw std::runtime_error(std::string("cannot write ") + argv[4]);
    compare(input, std::stoul(argv[3]));
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
