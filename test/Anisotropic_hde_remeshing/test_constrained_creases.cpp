// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Constrained edges and patches without a sharp angle, as CGAL's isotropic_remeshing is called: where they are sharp, the surface has
// a function for each region between them; where they are not, it is smooth as before.

#include "remeshing_checks.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/regions/keep_sharp_curves.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace shapes;
using namespace remeshing_checks;

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Parallel_if_available_tag Tag;
typedef CGAL::Rbf_implicit_function<Kernel, CGAL::Polyharmonic_rbf, Tag> Function;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Constrained;

Constrained constrained_of(Mesh& mesh) { return mesh.add_property_map<Mesh::Edge_index, bool>("e:constrained", false).first; }

Constrained sharp_edges_of(Mesh& mesh)
{
  Constrained result = constrained_of(mesh);
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 60, result);
  return result;
}

// the side of a cube that a face is on
std::string side_of(const Mesh& mesh, const Mesh::Face_index f)
{
  const Vector_3 n = CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh);
  return std::abs(n.x()) > 0.9   ? (n.x() > 0 ? "right" : "left")
         : std::abs(n.y()) > 0.9 ? (n.y() > 0 ? "back" : "front")
         : n.z() > 0             ? "top"
                                 : "bottom";
}

// the largest distance of the points of a mesh, the middles of its edges among them, from the boundary of the unit cube
double distance_to_cube(const Mesh& mesh)
{
  const auto distance = [](const Point_3& p)
  {
    double outside = 0, inside = 1e300;
    for (int i = 0; i < 3; ++i)
    {
      outside = (std::max)({outside, -p[i], p[i] - 1});
      inside = (std::min)({inside, std::abs(p[i]), std::abs(1 - p[i])});
    }
    return (std::max)(outside, inside);
  };
  double largest = 0;
  for (const Mesh::Edge_index e : mesh.edges())
  {
    const Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    largest = (std::max)({largest, distance(p), distance(q), distance(CGAL::midpoint(p, q))});
  }
  return largest;
}

const auto np = params::number_of_target_faces(1500).relative_sigma(0.05).number_of_iterations(5);

void test_cube()
{
  const Mesh input = cube(8);
  CHECK(distance_to_cube(input) < 1e-12);
  const auto check = [&](const std::string& name, const std::size_t number_of_regions, const auto& remesh)
  {
    Mesh mesh = input;
    const Hde::Remeshing_result result = remesh(mesh);
    check_same_topology(input, mesh);
    const double distance = distance_to_cube(mesh);
    std::cout << name << ": " << mesh.number_of_faces() << " faces, " << result.number_of_regions << " regions, " << distance
              << " off the cube" << std::endl;
    CHECK(result.number_of_regions == number_of_regions);
    CHECK(number_of_regions == 6 ? distance < 1e-9 : distance > 1e-3); // one function rounds the cube, inside of a face, too
    return mesh;
  };
  check("sharp edges", 6,
        [](Mesh& mesh)
        { return CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.edge_is_constrained_map(sharp_edges_of(mesh))); });
  const Mesh with_patches = check("patches", 6,
                                  [](Mesh& mesh)
                                  {
                                    auto patch = mesh.add_property_map<Mesh::Face_index, std::string>("f:patch").first;
                                    for (const Mesh::Face_index f : mesh.faces())
                                      patch[f] = side_of(mesh, f);
                                    const Hde::Remeshing_result result =
                                        CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.face_patch_map(patch));
                                    std::size_t number_of_wrong = 0;
                                    for (const Mesh::Face_index f : mesh.faces())
                                      number_of_wrong += patch[f] != side_of(mesh, f) ? 1 : 0;
                                    CHECK(number_of_wrong == 0);
                                    return result;
                                  });
  check("a range", 6,
        [](Mesh& mesh)
        {
          std::vector<Mesh::Face_index> range;
          for (const Mesh::Face_index f : mesh.faces())
            if (mesh.point(mesh.target(mesh.halfedge(f))).z() > 0.4)
              range.push_back(f);
          return CGAL::anisotropic_hde_remeshing<Tag>(range, mesh, np.edge_is_constrained_map(sharp_edges_of(mesh)));
        });
  // a sharp edge that separates nothing, and normals of the caller's, leave the surface smooth
  check("one edge", 1,
        [](Mesh& mesh)
        {
          Constrained is_constrained = sharp_edges_of(mesh);
          for (const Mesh::Edge_index e : mesh.edges())
            for (int i = 0; i < 2; ++i)
              is_constrained[e] =
                  is_constrained[e] && mesh.point(mesh.vertex(e, i)).x() == 0 && mesh.point(mesh.vertex(e, i)).y() == 0;
          return CGAL::anisotropic_hde_remeshing<Tag>(mesh, np.edge_is_constrained_map(is_constrained));
        });
  check("normals", 1,
        [](Mesh& mesh)
        {
          auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector_3>("v:normal").first;
          CGAL::Polygon_mesh_processing::compute_vertex_normals(mesh, normals);
          return CGAL::anisotropic_hde_remeshing<Tag>(
              mesh, np.edge_is_constrained_map(sharp_edges_of(mesh)).vertex_normal_map(normals));
        });
}

// lines and patches on a smooth surface: the same as with one smooth function
void test_smooth()
{
  const Mesh input = ellipsoid(3);
  const auto remesh = [&](const bool has_function)
  {
    Mesh mesh = input;
    Constrained is_constrained = constrained_of(mesh);
    auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
    for (const Mesh::Edge_index e : mesh.edges())
      is_constrained[e] =
          std::abs(mesh.point(mesh.vertex(e, 0)).z()) < 1e-9 && std::abs(mesh.point(mesh.vertex(e, 1)).z()) < 1e-9;
    for (const Mesh::Face_index f : mesh.faces())
      patch[f] = mesh.point(mesh.target(mesh.halfedge(f))).z() > 2 ? 1 : 0;
    const auto constrained = np.edge_is_constrained_map(is_constrained).face_patch_map(patch);
    const Hde::Remeshing_result result = has_function ? CGAL::anisotropic_hde_remeshing<Tag>(mesh, Function(input), constrained)
                                                      : CGAL::anisotropic_hde_remeshing<Tag>(mesh, constrained);
    CHECK(result.number_of_regions == 1);
    CHECK(result.curves_after.number_of_curves >= 2);
    return digest(mesh);
  };
  CHECK(remesh(false) == remesh(true));
}

// A ridge along a grid whose slope falls linearly to a tenth: sharp where the slope is more than tan(20 degrees), .364.
void test_fading_ridge()
{
  for (const double slope : {1., 0.5}) // sharp along .7 and .3 of the ridge
    for (const bool is_alone : {true, false})
    {
      Mesh mesh;
      const unsigned int n = 20;
      CGAL::make_grid(
          n, n, mesh,
          [&](const std::size_t i, const std::size_t j)
          {
            const double x = double(i) / (n / 2) - 1, y = double(j) / n;
            return Point_3(x, y, -std::abs(x) * slope * (1 - 0.9 * y));
          },
          true);
      Constrained is_marked = constrained_of(mesh);
      const auto on = [&](const Mesh::Edge_index e, const int axis, const double at)
      {
        return std::abs(mesh.point(mesh.vertex(e, 0))[axis] - at) < 1e-9 &&
               std::abs(mesh.point(mesh.vertex(e, 1))[axis] - at) < 1e-9;
      };
      std::size_t number_of_marked = 0, number_of_kept = 0;
      for (const Mesh::Edge_index e : mesh.edges())
      {
        // across the ridge goes a flat line, which cuts it in two curves
        is_marked[e] = on(e, 0, 0) || (!is_alone && on(e, 1, 0.5));
        number_of_marked += is_marked[e] ? 1 : 0;
      }
      CHECK(number_of_marked == (is_alone ? n : 2 * n));
      const bool is_any = Hde::internal::keep_sharp_curves(mesh, mesh.points(), 40, is_marked);
      for (const Mesh::Edge_index e : mesh.edges())
        number_of_kept += is_marked[e] ? 1 : 0;
      std::cout << "ridge of slope " << slope << ": " << number_of_kept << " of " << number_of_marked << std::endl;
      CHECK(is_any == (number_of_kept > 0));
      // alone, all or nothing; cut in the middle, the halves are sharp along 1 and .4, .6 and 0 of their lengths
      CHECK(number_of_kept == (is_alone ? (slope == 1 ? n : 0) : n / 2));
    }
}

int main()
{
  test_cube();
  test_smooth();
  test_fading_ridge();
  return check_summary();
}
