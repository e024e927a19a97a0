// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the package promises, on meshes that no surface reconstruction would make: a valid result or a refusal.

#include "awkward_shapes.h"
#include "check.h"
#include "polygon_soups.h"
#include "promises.h"

#include <CGAL/Rbf_implicit_function.h>

#include <cstddef>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, Tag> Function;
using promises::Kind;

struct Case
{
  double sigma;  // of the diagonal
  double factor; // to the number of faces
  bool has_self_intersection_tests;
};

// returns how many cases gave a mesh
int test_mesh(const std::string& name, const shapes::Mesh& mesh)
{
  std::optional<Function> function;
  try
  {
    function.emplace(mesh);
  }
  catch (const std::invalid_argument& refusal)
  {
    std::cout << name << ": " << refusal.what() << std::endl;
  }
  const double diagonal = mesh.number_of_faces() > 0 && promises::has_finite_points(mesh) ? promises::diagonal(mesh) : 1;
  int number_of_meshes = 0;
  for (const Case c : {Case{0, 0.5, false}, Case{0.05, 2, true}, Case{0.01, 1, true}})
  {
    const std::size_t n = std::size_t(c.factor * double(mesh.number_of_faces())) + 1;
    const promises::Outcome outcome =
        promises::outcome<Tag>(mesh, function, c.sigma * diagonal, n, c.has_self_intersection_tests);
    std::cout << name << ", sigma " << c.sigma << " D, " << mesh.number_of_faces() << " to " << n << " faces"
              << (c.has_self_intersection_tests ? ", tested: " : ": ") << (outcome.kind == Kind::VALID ? "valid" : outcome.text)
              << ", " << outcome.seconds << " s" << std::endl;
    CHECK(outcome.kind != Kind::BROKEN);
    number_of_meshes += outcome.kind == Kind::VALID ? 1 : 0;
  }
  return number_of_meshes;
}

int main()
{
  int number_of_meshes = 0;
  for (const auto& [name, make] : awkward_shapes::all())
  {
    const polygon_soups::Polygon_soup soup = polygon_soups::to_polygons(make());
    if (const std::optional<shapes::Mesh> mesh = polygon_soups::mesh_of(soup))
      number_of_meshes += test_mesh(name, *mesh);
    else if (const std::optional<shapes::Mesh> mended = polygon_soups::mesh_of(polygon_soups::repaired(soup)))
      number_of_meshes += test_mesh(name + ", repaired", *mended);
    else
      std::cout << name << ": no manifold mesh" << std::endl;
  }
  CHECK(number_of_meshes >= 40); // most are meshes, and not all is refused
  return check_summary();
}
