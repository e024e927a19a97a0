// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Nothing is lost where lengths in an embedding lead: fingers that are thinner than the edges are long stay, whatever the
// embedding and the scheme. Where nothing can be lost, the faces are shaped as ever.

#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/Curvature_metric.h>
#include <CGAL/Anisotropic_hde_remeshing/Normal_embedding.h>
#include <CGAL/Rbf_implicit_function.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;

const double height = 0.8, width = 0.12; // of a finger; the width is an angle
const std::size_t number_of_faces = 600; // on the sphere that is a length of .25

std::vector<Vector_3> directions()
{
  std::vector<Vector_3> result;
  for (const double x : {-1., 1.})
    for (const double y : {-1., 1.})
      for (const double z : {-1., 1.})
        result.push_back(Vector_3(x, y, z) / std::sqrt(3.));
  return result;
}

// a sphere with eight fingers
Mesh sphere_with_fingers()
{
  Mesh mesh = icosphere(6);
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    double radius = 1;
    for (const Vector_3& d : directions())
    {
      const double angle = std::acos((std::min)((mesh.point(v) - CGAL::ORIGIN) * d, 1.));
      radius += height * std::exp(-std::pow(angle / width, 4));
    }
    mesh.point(v) = CGAL::ORIGIN + radius * (mesh.point(v) - CGAL::ORIGIN);
  }
  return mesh;
}

// how much of the worst finger is left, over its height
double least_finger(const Mesh& mesh)
{
  double least = 2;
  for (const Vector_3& d : directions())
  {
    double most = 0;
    for (const Mesh::Vertex_index v : mesh.vertices())
      most = (std::max)(most, (mesh.point(v) - CGAL::ORIGIN) * d);
    least = (std::min)(least, (most - 1) / height);
  }
  return least;
}

template <typename Function, typename NamedParameters>
void check_fingers(const std::string& name, const Function& function, const NamedParameters& np)
{
  const Mesh input = sphere_with_fingers();
  Mesh mesh = input;
  const Hde::Remeshing_result result =
      CGAL::anisotropic_hde_remeshing<Tag>(mesh, function, np.number_of_target_faces(number_of_faces));
  std::cout << name << ": " << mesh.number_of_faces() << " faces, fingers " << least_finger(mesh) << ", length "
            << result.target_edge_length << std::endl;
  check_same_topology(input, mesh);
  CHECK(least_finger(mesh) > 0.8);
  CHECK(std::abs(double(mesh.number_of_faces()) - double(number_of_faces)) <= 0.02 * double(number_of_faces));
}

int main()
{
  const CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> function(sphere_with_fingers());
  check_fingers("sigma", function, params::relative_sigma(0.02));
  check_fingers("lengths in space", function, params::embedding(Hde::Normal_embedding(0)));
  check_fingers("the paper's scheme", function, params::remeshing_scheme(Hde::Remeshing_scheme::PAPER).relative_sigma(0.02));
  check_fingers("metric", function, params::embedding(Hde::Curvature_metric(2)));
  return check_summary();
}
