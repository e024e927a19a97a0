// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The section on the sign.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_SIGN_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_SIGN_H

#include "Pseudonormal_distance.h"
#include "Table.h"
#include "common.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

struct Sign_count
{
  std::size_t number_of_points = 0, number_of_wrong = 0;

  void add(const bool is_right)
  {
    ++number_of_points;
    number_of_wrong += is_right ? 0 : 1;
  }
  std::string percentage() const
  {
    return number_of_points == 0 ? "-" : text(100 * double(number_of_wrong) / double(number_of_points)) + "%";
  }
};

// At random points of the faces, by area, moved before and behind by a quarter to twice the mean edge h of the face. Only
// those count whose closest face is as far, in its own h, and is not reached at the boundary, where there is no sign.
inline Sign_count signs_near(const Rbf_function& function, const Mesh& mesh, const std::size_t number_of_points)
{
  const Pseudonormal_distance exact(mesh);
  const std::vector<double> areas = exact.areas();
  std::mt19937_64 random(1);
  std::discrete_distribution<std::size_t> random_face(areas.begin(), areas.end());
  std::uniform_real_distribution<double> random_number(0, 1);
  Sign_count count;
  for (std::size_t i = 0; i < number_of_points; ++i)
  {
    const std::size_t face = random_face(random);
    const double root = std::sqrt(random_number(random)), share = random_number(random);
    const double height = exact.edge_length(face) * (0.25 + 1.75 * random_number(random));
    const Point_3 p =
        exact.point(face, root * (1 - share), root * share) + (i % 2 == 0 ? height : -height) * exact.normal(face);
    const Pseudonormal_distance::Answer answer = exact(p);
    const double distance = std::abs(answer.distance), h = exact.edge_length(answer.face);
    if (!answer.is_on_boundary && distance >= 0.25 * h && distance <= 2 * h)
      count.add((function(p) > 0) == (answer.distance > 0));
  }
  return count;
}

// At random points of the bounding box, a tenth of the diagonal larger on all sides, but for those nearer than h/4 to their
// closest face; only of a closed mesh. The side is exact, and none of the pseudonormals'.
inline Sign_count signs_in_box(const Rbf_function& function, const Mesh& mesh, const std::size_t number_of_points)
{
  Sign_count count;
  if (!CGAL::is_closed(mesh))
    return count;
  const Pseudonormal_distance distance(mesh);
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side_of_mesh(mesh);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double margin = 0.1 * bounding_box_diagonal(mesh);
  std::mt19937_64 random(1);
  const auto coordinate = [&](const int axis)
  { return std::uniform_real_distribution<double>(box.min(axis) - margin, box.max(axis) + margin)(random); };
  for (std::size_t i = 0; i < number_of_points; ++i)
  {
    const double x = coordinate(0), y = coordinate(1), z = coordinate(2);
    const Point_3 p(x, y, z);
    const Pseudonormal_distance::Answer answer = distance(p);
    if (std::abs(answer.distance) >= 0.25 * distance.edge_length(answer.face))
      count.add((function(p) < 0) == (side_of_mesh(p) == CGAL::ON_BOUNDED_SIDE));
  }
  return count;
}

// --- (e) ---

inline void run_sign_section(const std::vector<Input>& inputs)
{
  Table table("(e) sign: at points h/4 to 2h away, and in the whole box of closed meshes at points h/4 away and farther");
  table.add("mesh", "points", "wrong", "share", "asked", "points in box", "wrong", "share", "patches", "fallback",
            "failed checks");
  for (const Input& input : inputs)
  {
    const Rbf_function function(input.mesh);
    const Sign_count near = signs_near(function, input.mesh, 200000), box = signs_in_box(function, input.mesh, 50000);
    const Hde::Rbf_diagnostics& diagnostics = function.diagnostics();
    table.add(input.name, near.number_of_points, near.number_of_wrong, near.percentage(),
              input.name == "camel.off" ? "0.2%" : "0.01%", box.number_of_points, box.number_of_wrong, box.percentage(),
              diagnostics.number_of_patches, diagnostics.patches_on_fallback, diagnostics.number_of_failed_checks);
  }
  table.print();
}

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_IMPLICIT_FUNCTION_SIGN_H
