// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the package promises, on meshes that no surface reconstruction would make: a valid result or a refusal.

// Where the function leads nowhere, vertices end on the input, and are counted: exactly those that are not on the zero set.

#include "check.h"
#include "remeshing_checks.h"
#include "shapes.h"

#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>

using namespace shapes;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

// the unit sphere without a cap, where its function is not a number
struct Sphere_without_cap
{
  typedef Kernel::FT FT;
  typedef shapes::Point_3 Point;
  typedef shapes::Point_3 Point_3;
  typedef shapes::Vector_3 Vector_3;

  static constexpr double height = 0.7;

  FT operator()(const Point_3& p) const
  {
    return p.z() > height ? std::numeric_limits<double>::quiet_NaN() : Sphere_function()(p);
  }
  Vector_3 gradient(const Point_3& p) const { return Sphere_function().gradient(p); }
};

struct Remeshing
{
  Mesh mesh;
  Hde::Remeshing_result result;
};

Remeshing remesh(Mesh mesh, const std::size_t number_of_faces)
{
  Remeshing r;
  r.result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, Sphere_without_cap(),
                                                  params::number_of_target_faces(number_of_faces).relative_sigma(0.05));
  r.mesh = mesh;
  return r;
}

std::size_t number_off_zero_set(const Mesh& mesh)
{
  std::size_t number = 0;
  for (const auto v : mesh.vertices())
    number += std::abs(Sphere_without_cap()(mesh.point(v))) <= 1e-8 * bounding_box_diagonal(mesh) ? 0 : 1;
  return number;
}

double longest_edge(const Mesh& mesh)
{
  double longest = 0;
  for (const auto e : mesh.edges())
    longest =
        (std::max)(longest, std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
  return longest;
}

// with the normals of the input, which follow the mesh, the cap is remeshed as the rest is: whichever way the mesh looks
void test_orientations()
{
  const Mesh outward = icosphere(4); // 5,120 faces
  Mesh inward = outward;
  CGAL::Polygon_mesh_processing::reverse_face_orientations(inward);
  for (const std::size_t wanted : {1000, 5000})
  {
    const Remeshing out = remesh(outward, wanted), in = remesh(inward, wanted);
    for (const Remeshing& r : {out, in})
    {
      std::cout << wanted << " asked: " << r.mesh.number_of_faces() << " faces, longest edge " << longest_edge(r.mesh) << ", "
                << r.result.number_of_unprojected_vertices << " of " << r.mesh.number_of_vertices() << " vertices on the input"
                << std::endl;
      remeshing_checks::check_number_of_faces(r.mesh, wanted);
      CHECK(CGAL::is_valid_polygon_mesh(r.mesh));
      CHECK(r.result.number_of_unprojected_vertices == number_off_zero_set(r.mesh));
      CHECK(r.result.number_of_unprojected_vertices > 0);
    }
    CHECK_CLOSE(longest_edge(out.mesh), longest_edge(in.mesh), 0.2 * longest_edge(out.mesh));
  }
}

int main()
{
  test_orientations();
  return check_summary();
}
