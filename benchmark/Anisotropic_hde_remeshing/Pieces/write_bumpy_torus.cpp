// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Writes a torus with bumps as a binary PLY file, row by row: of any size, in next to no memory.
//   write_bumpy_torus NUMBER_OF_FACES OUT

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

constexpr double pi = 3.14159265358979323846;

template <typename T>
void write(std::ofstream& file, const T value)
{
  file.write(reinterpret_cast<const char*>(&value), sizeof value);
}

// at the angles around the axis and around the tube
void write_point(std::ofstream& file, const double u, const double v)
{
  const double bumps = 0.02 * std::sin(23 * u) * std::sin(9 * v) + 0.004 * std::sin(97 * u + 5 * v) * std::cos(41 * v);
  const double tube = 0.4 * (1 + bumps), radius = 1 + tube * std::cos(v);
  write(file, radius * std::cos(u));
  write(file, radius * std::sin(u));
  write(file, tube * std::sin(v));
}

} // namespace

int main(int argc, char* argv[])
{
  const double faces = argc == 3 ? std::atof(argv[1]) : 0;
  if (!(faces >= 18 && faces < 4e9))
  {
    std::cerr << "usage: " << argv[0] << " NUMBER_OF_FACES OUT" << std::endl;
    return EXIT_FAILURE;
  }
  // rows of nearly square cells, two triangles each
  const std::int64_t across = (std::max)(std::int64_t(std::lround(std::sqrt(faces / 2 * 0.4))), std::int64_t(3));
  const std::int64_t around = (std::max)(std::int64_t(std::lround(faces / 2 / double(across))), std::int64_t(3));
  std::ofstream file(argv[2], std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << around * across
       << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << 2 * around * across
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::int64_t i = 0; i < around; ++i)
    for (std::int64_t j = 0; j < across; ++j)
      write_point(file, 2 * pi * double(i) / double(around), 2 * pi * double(j) / double(across));
  for (std::int64_t i = 0; i < around; ++i)
    for (std::int64_t j = 0; j < across; ++j)
    {
      const std::int64_t next_i = (i + 1) % around, next_j = (j + 1) % across;
      const std::int32_t a = std::int32_t(i * across + j), b = std::int32_t(next_i * across + j),
                         c = std::int32_t(next_i * across + next_j), d = std::int32_t(i * across + next_j);
      for (const std::int32_t third : {b, d})
      {
        file.put(3);
        write(file, a);
        write(file, third == b ? b : c);
        write(file, third == b ? c : d);
      }
    }
  file.close();
  if (!file)
  {
    std::cerr << "cannot write " << argv[2] << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << 2 * around * across << " faces" << std::endl;
  return EXIT_SUCCESS;
}
