// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// From the bytes of a file to its mesh and its remeshing, as hde_remesh reads them: a valid result or a refusal. The first three
// bytes are the format and the parameters. For libFuzzer.

#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/Failure.h"
#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/Mesh.h"
#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/cracks.h"
#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/flat_faces.h"
#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/mesh_file.h"
#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/repair.h"
#include "../../../examples/Anisotropic_hde_remeshing/hde_remesh/sides.h"
#include "../promises.h"

#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

namespace {

typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, CGAL::Parallel_if_available_tag> Function;

constexpr std::size_t largest_number_of_faces = 200;

struct Parameters
{
  bool is_repaired, has_tests;
  double sigma, factor;
};

[[noreturn]] void fail(const std::string& broken)
{
  std::cerr << broken << std::endl;
  std::abort();
}

// edges with one face, and with more than two
std::array<std::size_t, 2> numbers_of_edges(const hde_remesh::Soup& soup)
{
  std::array<std::size_t, 2> numbers = {0, 0};
  hde_remesh::for_each_edge(hde_remesh::sides_of(soup),
                            [&](const std::vector<std::size_t>& sides)
                            {
                              numbers[0] += sides.size() == 1 ? 1 : 0;
                              numbers[1] += sides.size() > 2 ? 1 : 0;
                            });
  return numbers;
}

// fewer boundary edges if points are gone, and no more edges of many faces
void close_cracks(hde_remesh::Soup& soup)
{
  const double tolerance = 4 * soup.rounding;
  const auto before = numbers_of_edges(soup);
  const std::size_t number = hde_remesh::close_cracks(soup, tolerance, hde_remesh::Orientation::OPPOSITE);
  const auto after = numbers_of_edges(soup);
  if (after[1] > before[1] || (number > 0 && after[0] >= before[0]))
    fail("closing cracks has made it worse");
}

void remesh(const std::string& file_name, const Parameters& parameters)
{
  hde_remesh::Soup soup = hde_remesh::read_soup(file_name);
  if (soup.faces.size() > largest_number_of_faces || soup.points.size() > 3 * largest_number_of_faces)
    return;
  hde_remesh::check_points(soup, file_name);
  if (!parameters.is_repaired)
    close_cracks(soup);
  else
  {
    hde_remesh::Repair repair;
    soup = hde_remesh::repaired(soup, 4 * soup.rounding, repair);
  }
  hde_remesh::Mesh input = hde_remesh::mesh_of_soup(soup, file_name).mesh;
  hde_remesh::remove_flat_faces(input, 4 * soup.rounding);
  hde_remesh::Mesh mesh = input;
  const Function function(mesh);
  const auto np = params::relative_sigma(parameters.sigma)
                      .number_of_target_faces(1 + std::size_t(parameters.factor * double(mesh.number_of_faces())))
                      .number_of_iterations(3)
                      .do_self_intersection_tests(parameters.has_tests);
  const auto result = CGAL::anisotropic_hde_remeshing(mesh, function, np);
  const std::string broken = promises::broken(input, mesh, function, result, parameters.has_tests);
  if (!broken.empty())
    fail(broken);
}

// in the memory if there is such a folder; removed at the end
const std::filesystem::path& folder()
{
  struct Folder
  {
    std::filesystem::path path;

    Folder()
    {
      const std::filesystem::path memory = "/dev/shm";
      path = (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
             ("hde_remesh_fuzzing_" + std::to_string(getpid()));
      std::filesystem::create_directory(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
  };
  static const Folder result;
  return result.path;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  if (size < 3)
    return 0;
  static const char* const formats[] = {"off", "obj", "ply", "stl"};
  const std::string file_name = (folder() / "input.").string() + formats[data[0] % 4];
  std::ofstream(file_name, std::ios::binary).write(reinterpret_cast<const char*>(data + 3), std::streamsize(size - 3));
  try
  {
    remesh(file_name, Parameters{data[1] % 2 == 1, data[1] % 4 > 1, 0.002 * data[1], 0.02 * data[2]});
  }
  catch (const hde_remesh::Failure&)
  {
  }
  catch (const std::invalid_argument&)
  {
  }
  return 0;
}
