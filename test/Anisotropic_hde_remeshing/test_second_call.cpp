// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// A second call with the same function: the mesh that it is given is coarse, and far from the surface. The result is on the surface
// all the same, but for a few vertices whose number is told exactly.

#include "remeshing_checks.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

struct Off_surface
{
  std::size_t number = 0; // of the vertices further from the zero set than is counted in the result
  std::size_t number_of_far = 0;
};

// the distance to first order
template <typename Function>
Off_surface off_surface(const Mesh& mesh, const Function& function, const double diagonal)
{
  Off_surface result;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const double value = std::abs(function(mesh.point(v))),
                 slope = std::sqrt(function.gradient(mesh.point(v)).squared_length());
    result.number += value <= 1e-8 * diagonal * slope ? 0 : 1;
    result.number_of_far += value <= 1e-3 * diagonal ? 0 : 1;
  }
  return result;
}

template <typename Function>
void check_second_call(const std::string& name, const Mesh& input, const Function& function, const std::size_t coarse,
                       const std::size_t fine)
{
  Mesh mesh = input;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::number_of_target_faces(coarse));
  const Mesh given = mesh;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, params::number_of_target_faces(fine));
  const Off_surface off = off_surface(mesh, function, bounding_box_diagonal(given));
  std::cout << name << ": " << given.number_of_faces() << " -> " << mesh.number_of_faces() << " faces, " << off.number
            << " vertices off the surface, " << off.number_of_far << " by more than 1e-3 D; by descent "
            << result.projections.descent << ", on the input " << result.projections.closest_point << std::endl;
  check_same_topology(input, mesh);
  CHECK(result.number_of_unprojected_vertices == off.number);
  CHECK(500 * off.number <= mesh.number_of_vertices());
  CHECK(off.number_of_far <= 1);
}

void test_scan()
{
  Mesh elephant;
  CHECK(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/elephant.off"), elephant));
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(elephant);
  check_second_call("elephant", elephant, function, 1500, 16000);
  check_second_call("elephant", elephant, function, 500, 16000);
}

// a torus of 60 faces, far from its surface
void test_coarse_torus() { check_second_call("torus", torus(24, 8), Torus_function(), 60, 6000); }

int main()
{
  test_scan();
  test_coarse_torus();
  return check_summary();
}
