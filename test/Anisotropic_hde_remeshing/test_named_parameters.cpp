// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The package's named parameters beside CGAL's, after a header of CGAL's that includes the list first.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameters.h>

#include "check.h"

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace parameters = CGAL::parameters;
namespace internal_np = CGAL::internal_np;

template <typename NamedParameters, typename Tag>
double value(const NamedParameters& np, Tag tag)
{
  return parameters::choose_parameter(parameters::get_parameter(np, tag), -1.0);
}

template <typename NamedParameters>
void check_values(const NamedParameters& np)
{
  CHECK(value(np, internal_np::sigma) == 2.0);
  CHECK(value(np, internal_np::target_edge_length) == 0.25);
  CHECK(value(np, internal_np::collapse_ratio) == 0.75);
  CHECK(value(np, internal_np::offset_distance) == -1.0); // not given
  CHECK(parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), 1u) == 7u);
}

void check_any_order()
{
  check_values(parameters::sigma(2.0).number_of_iterations(7u).target_edge_length(0.25).collapse_ratio(0.75));
  check_values(parameters::number_of_iterations(7u).collapse_ratio(0.75).target_edge_length(0.25).sigma(2.0));
}

void check_every_name()
{
  const auto np = parameters::sigma(1.0)
                      .target_edge_length(2.0)
                      .number_of_target_faces(3.0)
                      .smoothing_ratio(4.0)
                      .collapse_ratio(5.0)
                      .split_ratio(6.0)
                      .remeshing_scheme(7.0)
                      .radial_function(8.0)
                      .number_of_patches(9.0)
                      .patch_overlap(10.0)
                      .offset_distance(11.0);
  CHECK(value(np, internal_np::sigma) == 1.0);
  CHECK(value(np, internal_np::target_edge_length) == 2.0);
  CHECK(value(np, internal_np::number_of_target_faces) == 3.0);
  CHECK(value(np, internal_np::smoothing_ratio) == 4.0);
  CHECK(value(np, internal_np::collapse_ratio) == 5.0);
  CHECK(value(np, internal_np::split_ratio) == 6.0);
  CHECK(value(np, internal_np::remeshing_scheme) == 7.0);
  CHECK(value(np, internal_np::radial_function) == 8.0);
  CHECK(value(np, internal_np::number_of_patches) == 9.0);
  CHECK(value(np, internal_np::patch_overlap) == 10.0);
  CHECK(value(np, internal_np::offset_distance) == 11.0);
}

// CGAL's own helper finds its map among the package's names.
void check_property_map()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 0, 1),
                         mesh);
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3> moved =
      mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:moved", Kernel::Point_3(5, 5, 5)).first;
  const auto np = parameters::sigma(2.0).vertex_point_map(moved).number_of_patches(3);
  const auto found = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                  get_property_map(CGAL::vertex_point, mesh));
  CHECK(get(found, *mesh.vertices().begin()) == Kernel::Point_3(5, 5, 5));
}

int main()
{
  check_any_order();
  check_every_name();
  check_property_map();
  return check_summary();
}
