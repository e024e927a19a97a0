// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Shows the progress, and stops the remeshing after half a second: the mesh is valid then, and on the surface, if not yet as
// uniform as it would be.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <chrono>
#include <iostream>

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Sphere
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  FT operator()(const Point_3& p) const { return (p - CGAL::ORIGIN).squared_length() - 1; }
  Vector_3 gradient(const Point_3& p) const { return 2 * (p - CGAL::ORIGIN); }
};

// hides the members that it needs; all of them are called from the thread that remeshes
class Patience : public Hde::Remeshing_visitor
{
public:
  void progress(const double share) { std::cout << int(100 * share) << "% " << std::flush; }

  bool go_further() { return std::chrono::steady_clock::now() < m_end; }

private:
  std::chrono::steady_clock::time_point m_end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
};

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);

  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing(
      mesh, Sphere(), params::number_of_target_faces(200000).number_of_iterations(1000).visitor(Patience()));

  std::cout << "\n"
            << (result.was_stopped ? "stopped after " : "done after ") << result.number_of_iterations
            << " iterations: " << mesh.number_of_faces() << " faces, a " << (CGAL::is_valid_polygon_mesh(mesh) ? "" : "not ")
            << "valid mesh" << std::endl;
  return CGAL::is_valid_polygon_mesh(mesh) ? 0 : 1;
}
