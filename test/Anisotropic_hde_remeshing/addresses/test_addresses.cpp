// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// A little of everything under AddressSanitizer and UBSan, which fail the test where memory is misused: awkward meshes, creases,
// constraints, patches, face ranges, measures. All with tests of self-intersection, as one remesher compiles sooner than two. More
// of the first and of constraints run there with scripts/run_tests.sh --all.

#include "../awkward_shapes.h"
#include "../check.h"
#include "../polygon_soups.h"
#include "../promises.h"

#include <CGAL/Rbf_implicit_function.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, Tag> Function;
typedef shapes::Mesh Mesh;

void test_awkward_shape(const shapes::Soup& soup)
{
  const std::optional<Mesh> mesh = polygon_soups::mesh_of(polygon_soups::repaired(polygon_soups::to_polygons(soup)));
  if (!CHECK(mesh.has_value()))
    return;
  const std::optional<Function> function(*mesh);
  const double sigma = 0.03 * promises::diagonal(*mesh);
  for (const bool has_tests : {false, true})
  {
    const promises::Outcome outcome =
        promises::outcome<Tag>(*mesh, function, sigma, mesh->number_of_faces() / 2 + 50, has_tests);
    std::cout << mesh->number_of_faces() << " faces: " << outcome.text << " " << outcome.seconds << " s" << std::endl;
    CHECK(outcome.kind == promises::Kind::VALID);
  }
}

// the creases of a cube; one face more is a patch of its own, one edge more constrained
void test_creases()
{
  Mesh mesh = shapes::cube(4);
  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  patch[*mesh.faces().begin()] = 1;
  CGAL::anisotropic_hde_remeshing<Tag>(mesh, params::sharp_angle(40)
                                                 .number_of_target_faces(400)
                                                 .number_of_iterations(3)
                                                 .do_self_intersection_tests(true)
                                                 .edge_is_constrained_map(is_constrained)
                                                 .face_patch_map(patch));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
  CHECK(CGAL::is_closed(mesh));
  std::size_t number_of_creases = 0;
  for (const Mesh::Edge_index e : mesh.edges())
    number_of_creases += is_constrained[e] ? 1 : 0;
  CHECK(number_of_creases >= 12);
}

// vertices stay, and the faces outside a range
void test_face_range()
{
  Mesh mesh = shapes::hills(12);
  auto is_constrained = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_constrained", false).first;
  is_constrained[*mesh.vertices().begin()] = true;
  const auto all = mesh.faces();
  const std::vector<Mesh::Face_index> range(all.begin(), all.begin() + 150);
  CGAL::anisotropic_hde_remeshing<Tag>(
      range, mesh, shapes::Hills_function(),
      params::number_of_target_faces(400).number_of_iterations(3).do_self_intersection_tests(true).vertex_is_constrained_map(
          is_constrained));
  CHECK(CGAL::is_valid_polygon_mesh(mesh));
}

int main()
{
  test_awkward_shape(awkward_shapes::plate(6, 1e-3));
  test_awkward_shape(awkward_shapes::twisted_strip(30, 2));
  test_awkward_shape(awkward_shapes::needles(12, 1e3));
  test_awkward_shape(awkward_shapes::fan(60));
  test_creases();
  test_face_range();
  return check_summary();
}
