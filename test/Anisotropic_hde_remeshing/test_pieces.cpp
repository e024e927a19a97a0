// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshing in pieces, in one process: the topology stays, seams cannot be told from the rest, and the result depends on the pieces
// alone.

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/Rbf_implicit_function.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include "check.h"
#include "pieces.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace internal = pieces::internal;

namespace {

internal::Pieces_request request_for(const shapes::Mesh& mesh, const double share_of_faces, const std::size_t number_of_pieces)
{
  internal::Pieces_request request;
  request.sigma = 0.02 * internal::diagonal_of(PMP::bbox(mesh));
  request.number_of_target_faces = share_of_faces * double(mesh.number_of_faces());
  request.faces_of_piece = mesh.number_of_faces() / number_of_pieces + 200; // the halves are not equal to a face
  request.faces_of_cell = request.faces_of_piece;
  return request;
}

// The joined mesh is valid, and has the topology of the input. So do the sums over the pieces, which do not see the whole.
shapes::Mesh check_topology(const shapes::Mesh& mesh, const pieces::Remeshed& remeshed)
{
  const internal::Joint_topology &before = remeshed.result.before, &after = remeshed.result.after;
  CHECK(remeshed.result.number_of_pieces > 2);
  CHECK(before.is_joined && after.is_joined);
  const shapes::Mesh result = remeshed.mesh<shapes::Mesh>();
  CHECK(result.is_valid());
  CHECK(!PMP::does_self_intersect(result));
  const Hde::Topology_measures of_input = Hde::measure_topology(mesh), of_result = Hde::measure_topology(result);
  CHECK(of_result.number_of_isolated_vertices == 0);
  CHECK(of_result.number_of_components == of_input.number_of_components);
  CHECK(of_result.number_of_boundary_loops == of_input.number_of_boundary_loops);
  CHECK(of_result.euler_characteristic == of_input.euler_characteristic);
  for (const auto& sums_and_measures : {std::make_pair(before, of_input), std::make_pair(after, of_result)})
  {
    const internal::Joint_topology& sums = sums_and_measures.first;
    const Hde::Topology_measures& measures = sums_and_measures.second;
    CHECK(sums.number_of_vertices == measures.number_of_vertices);
    CHECK(sums.number_of_faces == measures.number_of_faces);
    CHECK(sums.number_of_boundary_edges == measures.number_of_boundary_edges);
    CHECK(sums.number_of_components == measures.number_of_components);
    CHECK(sums.number_of_boundary_loops == measures.number_of_boundary_loops);
    CHECK(sums.euler_characteristic == measures.euler_characteristic);
  }
  return result;
}

void check_number(const pieces::Remeshed& remeshed, const internal::Pieces_request& request, const double tolerance)
{
  CHECK_CLOSE(double(remeshed.faces.size()) / request.number_of_target_faces, 1, tolerance);
}

void test_closed()
{
  const shapes::Mesh mesh = shapes::torus(160, 64);
  const internal::Pieces_request request = request_for(mesh, 0.5, 8);
  const pieces::Remeshed remeshed = pieces::remesh(pieces::shares_of(mesh, 5000), request);
  CHECK(remeshed.result.number_of_bands > 0);
  const shapes::Mesh result = check_topology(mesh, remeshed);
  check_number(remeshed, request, 0.03);
  const auto measures =
      Hde::measure_embedding<pieces::Concurrency_tag>(result, shapes::Torus_function(), params::sigma(request.sigma));
  CHECK(measures.number_of_folded_faces == 0);
  CHECK(measures.minimum_angle_mean > 52);
}

// Pieces of one row of triangles have no face that is in no band.
void test_pieces_without_rest()
{
  const shapes::Mesh mesh = shapes::torus(48, 24);
  internal::Pieces_request request = request_for(mesh, 0.7, 16);
  request.faces_of_piece = 80;
  const pieces::Remeshed remeshed = pieces::remesh(pieces::shares_of(mesh, 1000), request);
  CHECK(remeshed.result.number_of_pieces > 20);
  check_topology(mesh, remeshed);
}

void test_boundary_loops()
{
  shapes::Mesh mesh = shapes::torus(160, 64);
  // five triangles far from each other become holes
  std::vector<shapes::Mesh::Face_index> holes;
  for (std::size_t i = 0; i < 5; ++i)
    holes.push_back(shapes::Mesh::Face_index(shapes::Mesh::size_type(i * mesh.number_of_faces() / 5 + 17)));
  for (const auto f : holes)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  CHECK(Hde::measure_topology(mesh).number_of_boundary_loops == 5);
  check_topology(mesh, pieces::remesh(pieces::shares_of(mesh, 5000), request_for(mesh, 0.6, 6)));
  // long boundaries that seams cut
  const shapes::Mesh cylinder = shapes::cylinder(100, 50, 3);
  check_topology(cylinder, pieces::remesh(pieces::shares_of(cylinder, 4000), request_for(cylinder, 0.6, 6)));
}

void test_two_components()
{
  shapes::Mesh mesh = shapes::torus(80, 40);
  shapes::Mesh other = shapes::icosphere(4, 0.3);
  for (const auto v : other.vertices())
    other.point(v) = other.point(v) + shapes::Vector_3(0.2, 0.1, 0); // in the hole of the torus
  mesh.join(other);
  CHECK(Hde::measure_topology(mesh).number_of_components == 2);
  check_topology(mesh, pieces::remesh(pieces::shares_of(mesh, 2500), request_for(mesh, 0.5, 6)));
}

// a smooth function rounds them, but nothing breaks
void test_creases_across_seams()
{
  const shapes::Mesh mesh = shapes::cube(30);
  check_topology(mesh, pieces::remesh(pieces::shares_of(mesh, 5000), request_for(mesh, 0.4, 6)));
}

// the least and the mean of the 6D angles of the faces that satisfy a condition
struct Angles
{
  double least = 180, sum = 0;
  std::size_t number = 0;
  double mean() const { return sum / double(number); }
};

// The faces about old seams are those that the second and third round have made.
void test_quality_at_seams()
{
  shapes::Mesh mesh;
  CHECK(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/bunny00.off"), mesh));
  internal::Pieces_request request = request_for(mesh, 0.5, 8);
  const pieces::Remeshed remeshed = pieces::remesh(pieces::shares_of(mesh, 20000), request);
  CHECK(remeshed.result.number_of_bands > 8 && remeshed.result.number_of_corners > 4);
  const shapes::Mesh in_pieces = check_topology(mesh, remeshed);
  check_number(remeshed, request, 0.01);

  typedef CGAL::Rbf_implicit_function<shapes::Kernel, CGAL::Polyharmonic_rbf, pieces::Concurrency_tag> Function;
  const Function function(mesh, params::close_holes(false));
  shapes::Mesh serial = mesh;
  CGAL::anisotropic_hde_remeshing<pieces::Concurrency_tag>(
      serial, function, params::sigma(request.sigma).number_of_target_faces(std::size_t(request.number_of_target_faces)));
  const auto np = params::sigma(request.sigma);
  const auto a = Hde::measure_embedding<pieces::Concurrency_tag>(serial, function, np),
             b = Hde::measure_embedding<pieces::Concurrency_tag>(in_pieces, function, np);
  const auto rms_of = [&](const shapes::Mesh& m)
  { return Hde::measure_distance_to_zero_set<pieces::Concurrency_tag>(m, function).face_rms; };
  const double ratio_of_rms = rms_of(in_pieces) / rms_of(serial);
  std::cout << "serial and in pieces: mean angle " << a.minimum_angle_mean << ", " << b.minimum_angle_mean << "; least angle "
            << a.minimum_angle_least << ", " << b.minimum_angle_least << "; good lengths " << a.share_within_sqrt_2 << ", "
            << b.share_within_sqrt_2 << "; ratio of rms " << ratio_of_rms << std::endl;
  CHECK(b.number_of_folded_faces == 0);
  CHECK(b.minimum_angle_mean > 0.99 * a.minimum_angle_mean);
  CHECK(b.share_within_sqrt_2 > 0.99 * a.share_within_sqrt_2);
  CHECK(ratio_of_rms < 1.02);

  Angles at_seams, elsewhere;
  std::size_t face = 0;
  for (std::size_t holder = 0; holder < remeshed.result.holders.size(); ++holder)
    for (std::size_t k = 0; k < remeshed.result.counts[holder].number_of_faces; ++k, ++face)
    {
      const auto& f = remeshed.faces[face];
      std::array<double, 3> squared{};
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto point = [&](const std::size_t i)
        { return shapes::Point_3(remeshed.points[f[i]].x(), remeshed.points[f[i]].y(), remeshed.points[f[i]].z()); };
        const auto normal = [&](const std::size_t i) { return internal::to_vector(function.gradient(point(i))).normalized(); };
        squared[c] = (remeshed.points[f[c]] - remeshed.points[f[(c + 1) % 3]]).squaredNorm() +
                     request.sigma * request.sigma * (normal(c) - normal((c + 1) % 3)).squaredNorm();
      }
      const double angle =
          std::acos(internal::Embedded_triangle::largest_cosine(squared[0], squared[1], squared[2])) * 180 / shapes::pi;
      Angles& angles = holder < remeshed.result.number_of_pieces ? elsewhere : at_seams;
      angles.least = (std::min)(angles.least, angle);
      angles.sum += angle;
      ++angles.number;
    }
  std::cout << at_seams.number << " faces about seams: mean angle " << at_seams.mean() << ", least " << at_seams.least << "; "
            << elsewhere.number << " others: " << elsewhere.mean() << ", " << elsewhere.least << std::endl;
  CHECK(at_seams.mean() > 0.99 * elsewhere.mean());
}

// does the tasks in another order than they are numbered
class Team_in_reverse : public internal::Task_team
{
public:
  std::vector<internal::Bytes> run(const std::string&, const std::size_t number_of_tasks, const Task& task) override
  {
    std::vector<internal::Bytes> results(number_of_tasks);
    for (std::size_t i = number_of_tasks; i-- > 0;)
      results[i] = task(i);
    return results;
  }
};

void test_same_bytes()
{
  const shapes::Mesh mesh = shapes::cylinder(80, 40, 3);
  internal::Pieces_request request = request_for(mesh, 0.5, 5);
  request.faces_of_cell = request.faces_of_piece / 2;
  const auto shares = pieces::shares_of(mesh, 3000);
  const pieces::Remeshed remeshed = pieces::remesh(shares, request);
  CHECK(remeshed.result.number_of_cells > remeshed.result.number_of_pieces);

  Team_in_reverse reverse;
  const std::filesystem::path folder = "test_pieces_store";
  std::filesystem::remove_all(folder);
  internal::Folder_store files(folder);
  request.memory_of_functions = 1; // none is kept
  CHECK(pieces::remesh(shares, reverse, files, request) == remeshed);

  // a file that is cut off is told from a whole one
  const std::string key = remeshed.result.holders.front();
  std::filesystem::resize_file(folder / key, std::filesystem::file_size(folder / key) / 2);
  CHECK_THROWS(internal::from_bytes<internal::Piece_faces>(files.get(key)), std::runtime_error);
  CHECK_THROWS(files.get("no/such"), std::runtime_error);
  std::filesystem::remove_all(folder);
}

// Neighbours of very different sizes, one of which sticks out of the halo of the other's cell, are found, too.
void test_missed_seams()
{
  internal::Lone_edge a{3, 7, {{1, 2, 3}}}, b{7, 3, {{4, 5, 6}}}, boundary{8, 9, {{0, 0, 0}}};
  const auto missed = internal::missed_seams({{a, boundary}, {}, {b}});
  CHECK(missed[0].size() == 1 && missed[1].empty() && missed[2].size() == 1);
  CHECK(missed[0][0].other == 2 && missed[0][0].apex[0] == 4);
  CHECK(missed[2][0].other == 0 && missed[2][0].from == 7);
}

void test_wrong_input()
{
  const internal::Pieces_request request = request_for(shapes::cube(4), 0.5, 2);
  // three triangles on one edge
  const std::vector<internal::Vector> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, -1}};
  const internal::Shares_of_soup fan(points, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}, 2);
  CHECK_THROWS(pieces::remesh(fan, request), std::invalid_argument);
  CHECK_THROWS(pieces::remesh(internal::Shares_of_soup(points, {}, 2), request), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const internal::Shares_of_soup not_finite({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}}, 2);
  CHECK_THROWS(pieces::remesh(not_finite, request), std::invalid_argument);
}

} // namespace

int main()
{
  test_closed();
  test_pieces_without_rest();
  test_boundary_loops();
  test_two_components();
  test_creases_across_seams();
  test_quality_at_seams();
  test_same_bytes();
  test_missed_seams();
  test_wrong_input();
  return check_summary();
}
