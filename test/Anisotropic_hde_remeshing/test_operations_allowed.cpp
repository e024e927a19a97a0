// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The names that switch parts of CGAL's isotropic_remeshing off do so here, too: do_split, do_collapse, do_flip,
// collapse_constraints, relax_constraints. With their defaults they change nothing.

#include "remeshing_checks.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef std::array<double, 3> Coordinates;

Coordinates coordinates(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

// --- do_split, do_collapse, do_flip ---

template <typename Parameters>
Hde::Remeshing_result remesh(const std::string& name, const Mesh& input, const Parameters& np, std::size_t& number_of_faces)
{
  Mesh mesh = input;
  const Hde::Remeshing_result result = CGAL::anisotropic_hde_remeshing<Tag>(mesh, np);
  check_same_topology(input, mesh);
  number_of_faces = mesh.number_of_faces();
  std::cout << name << ": " << number_of_faces << " faces, " << result.number_of_splits << " splits, "
            << result.number_of_collapses << " contractions, " << result.number_of_flips << " flips" << std::endl;
  return result;
}

// number of faces asked for: fewer, which is by measured error without these names, as many, and more
void test_operations()
{
  const Mesh input = ellipsoid(3);
  const std::size_t n = input.number_of_faces();
  for (const std::size_t wanted : {n / 3, n, 3 * n})
  {
    const auto np = params::number_of_target_faces(wanted).number_of_iterations(4);
    std::size_t number_of_faces = 0;
    Hde::Remeshing_result result = remesh("no splits", input, np.do_split(false), number_of_faces);
    CHECK(result.number_of_splits == 0 && result.number_of_flips > 0);
    CHECK(number_of_faces <= n && (wanted > n || std::abs(double(number_of_faces) - double(wanted)) < 0.1 * double(n)));

    result = remesh("no contractions", input, np.do_collapse(false), number_of_faces);
    CHECK(result.number_of_collapses == 0 && result.number_of_flips > 0);
    CHECK(number_of_faces >= n && (wanted <= n || number_of_faces > 2 * n));

    result = remesh("no flips", input, np.do_flip(false), number_of_faces);
    CHECK(result.number_of_flips == 0 && result.number_of_splits + result.number_of_collapses > 0);

    result = remesh("smoothing only", input, np.do_split(false).do_collapse(false).do_flip(false), number_of_faces);
    CHECK(result.number_of_splits + result.number_of_collapses + result.number_of_flips == 0 && number_of_faces == n);
  }
}

// an error that would be kept by splits: the search for it ends
void test_error_without_splits()
{
  std::size_t number_of_faces = 0;
  const Mesh input = ellipsoid(2);
  const Hde::Remeshing_result result = remesh(
      "an error without splits", input,
      params::relative_approximation_error(1e-4).embedding(Hde::Curvature_metric(2)).number_of_iterations(3).do_split(false),
      number_of_faces);
  CHECK(result.number_of_splits == 0 && number_of_faces <= input.number_of_faces());
  CHECK(result.approximation_error > 1e-4 * bounding_box_diagonal(input));
}

void test_defaults()
{
  const Mesh input = ellipsoid(3);
  for (const std::size_t wanted : {400, 2000})
  {
    Mesh mesh = input, same = input;
    const auto np = params::number_of_target_faces(wanted).number_of_iterations(2);
    CGAL::anisotropic_hde_remeshing<Tag>(mesh, np);
    CGAL::anisotropic_hde_remeshing<Tag>(
        same, np.do_split(true).do_collapse(true).do_flip(true).collapse_constraints(true).relax_constraints(true));
    CHECK(digest(mesh) == digest(same));
  }
  Mesh mesh = input;
  const auto by_error = params::number_of_target_faces(400).remeshing_scheme(Hde::Remeshing_scheme::MEASURED_ERROR);
  CHECK(contains(invalid_argument_message([&] { CGAL::anisotropic_hde_remeshing<Tag>(mesh, by_error.do_flip(false)); }),
                 "remeshing_scheme is MEASURED_ERROR"));
  CHECK(digest(mesh) == digest(input));
}

// --- collapse_constraints, relax_constraints ---

struct Curve_vertices
{
  std::set<Coordinates> points;
  Curve_vertices(const Mesh& mesh, const Mesh::Property_map<Mesh::Edge_index, bool>& is_constrained)
  {
    for (const Mesh::Edge_index e : mesh.edges())
      if (is_constrained[e] || mesh.is_border(e))
        for (int i = 0; i < 2; ++i)
          points.insert(coordinates(mesh.point(mesh.vertex(e, i))));
  }
  std::size_t number_of_missing_in(const Curve_vertices& other) const
  {
    std::size_t number = 0;
    for (const Coordinates& p : points)
      number += other.points.count(p) == 0 ? 1 : 0;
    return number;
  }
};

// how many vertices of the curves are gone, and how many there are more
template <typename Call>
std::array<long, 2> changes_of_curves(const std::string& name, const Call& call)
{
  Mesh mesh = hills(24);
  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  for (const Mesh::Edge_index e : mesh.edges())
    is_constrained[e] =
        std::abs(mesh.point(mesh.vertex(e, 0)).x() - 1) < 1e-9 && std::abs(mesh.point(mesh.vertex(e, 1)).x() - 1) < 1e-9;
  const Mesh input = mesh;
  const Curve_vertices before(mesh, is_constrained);
  call(mesh, is_constrained);
  check_same_topology(input, mesh);
  const Curve_vertices after(mesh, is_constrained);
  const long missing = long(before.number_of_missing_in(after)), more = long(after.points.size()) - long(before.points.size());
  std::cout << name << ": " << before.points.size() << " vertices on curves, " << missing << " gone, " << more << " more"
            << std::endl;
  return {missing, more};
}

void test_curves()
{
  typedef Mesh::Property_map<Mesh::Edge_index, bool> Constrained;
  for (const std::size_t wanted : {600, 1152})
  {
    const auto np = params::number_of_target_faces(wanted).sigma(0.05);
    const auto changes = [&](const std::string& name, const bool collapse, const bool relax)
    {
      return changes_of_curves(
          name,
          [&](Mesh& mesh, const Constrained& is_constrained)
          {
            CGAL::anisotropic_hde_remeshing<Tag>(
                mesh, Hills_function(),
                np.edge_is_constrained_map(is_constrained).collapse_constraints(collapse).relax_constraints(relax));
          });
    };
    const std::array<long, 2> none = changes("neither", false, false), relaxed = changes("relaxed", false, true),
                              collapsed = changes("contracted", true, false);
    CHECK(none[0] == 0);
    CHECK(relaxed[0] > 20 && relaxed[1] >= 0);
    CHECK(wanted > 600 || collapsed[1] < 0);
    // what is not contracted stays where it was: the input's, or in the middle of an edge that was split
    CHECK(collapsed[0] < relaxed[0] || collapsed[1] < 0);
  }
  const auto by_error = params::number_of_target_faces(300);
  const std::array<long, 2> kept =
      changes_of_curves("by measured error, none contracted",
                        [&](Mesh& mesh, const Constrained& is_constrained) {
                          CGAL::anisotropic_hde_remeshing<Tag>(
                              mesh, by_error.edge_is_constrained_map(is_constrained).collapse_constraints(false));
                        });
  CHECK(kept[0] == 0 && kept[1] == 0);
  const std::array<long, 2> contracted =
      changes_of_curves("by measured error", [&](Mesh& mesh, const Constrained& is_constrained)
                        { CGAL::anisotropic_hde_remeshing<Tag>(mesh, by_error.edge_is_constrained_map(is_constrained)); });
  CHECK(contracted[1] < 0);
}

int main()
{
  test_operations();
  test_error_without_splits();
  test_defaults();
  test_curves();
  return check_summary();
}
