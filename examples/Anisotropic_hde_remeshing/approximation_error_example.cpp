// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// As few triangles as keep a distance to the surface, and the distance that a given number of triangles can have: a torus.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/approximation_bounds.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Parallel_if_available_tag Tag;

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// the signed distance to a torus of radii 1 and 1/4
struct Torus
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.25; }
  Vector_3 gradient(const Point_3& p) const
  {
    const double r = std::hypot(p.x(), p.y()), d = std::hypot(r - 1, p.z());
    return Vector_3((r - 1) / d * p.x() / r, (r - 1) / d * p.y() / r, p.z() / d);
  }
};

Mesh coarse_torus(const std::size_t around, const std::size_t across)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j)
    {
      const double a = 2 * 3.14159265358979 * double(i) / double(around), b = 2 * 3.14159265358979 * double(j) / double(across);
      const double r = 1 + 0.25 * std::cos(b);
      v.push_back(mesh.add_vertex(Point_3(r * std::cos(a), r * std::sin(a), 0.25 * std::sin(b))));
    }
  const auto at = [&](const std::size_t i, const std::size_t j) { return v[i % around * across + j % across]; };
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

int main()
{
  // the largest distance
  Mesh mesh = coarse_torus(40, 12);
  const double error = 0.002;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, Torus(), params::approximation_error(error));
  std::cout << "distance below " << error << ": " << mesh.number_of_faces() << " faces; it is at most "
            << result.approximation_error << ", and no mesh of as many faces could be nearer than about "
            << Hde::approximation_bounds(mesh, Torus()).max_on_surface << std::endl;

  // the mean distance of as many faces: a metric of its own, and vertices off the surface
  Mesh fitted = coarse_torus(40, 12);
  CGAL::anisotropic_hde_remeshing<Tag>(
      fitted, Torus(),
      params::embedding(Hde::Curvature_metric(2)).number_of_target_faces(mesh.number_of_faces()).fit_to_surface(true));
  std::cout << "root mean square " << Hde::measure_distance_to_zero_set(mesh, Torus()).face_rms << ", fitted "
            << Hde::measure_distance_to_zero_set(fitted, Torus()).face_rms << std::endl;
  return result.approximation_error <= error ? 0 : 1;
}
