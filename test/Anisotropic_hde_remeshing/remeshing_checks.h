// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What every remeshed mesh must be, whatever the surface and the parameters.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_REMESHING_CHECKS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_REMESHING_CHECKS_H

#include "check.h"
#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/quality_measures.h>
#include <CGAL/Anisotropic_hde_remeshing/zero_set_measures.h>
#include <CGAL/anisotropic_hde_remeshing.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <iterator>
#include <map>
#include <string>

namespace remeshing_checks {

namespace Hde = CGAL::Anisotropic_hde_remeshing;
namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

// what the package promises for smooth surfaces
struct Bounds
{
  double least_share_of_lengths = 0.99; // of the 6D lengths within [0.7, 1.41] of the target length
  double least_mean_angle = 52;         // mean of the smallest 6D angles, in degrees
  double largest_distance = 1e-9;       // of the vertices inside to the zero set, over the diagonal
};

// A grid of right triangles is a state of rest for local operations wherever it has the length already: all valences are six,
// every vertex is the centroid of its surroundings, the angles are 45 degrees and the diagonals 1.32 times the length.
inline Bounds bounds_for_grids()
{
  Bounds bounds;
  bounds.least_share_of_lengths = 0.98;
  bounds.least_mean_angle = 48;
  return bounds;
}

// closed or open as before, valid, neither folded nor intersecting itself, vertices on the zero set
template <typename TriangleMesh, typename Function>
void check_validity(const std::string& name, const TriangleMesh& before, const TriangleMesh& after, const Function& function,
                    const double largest_distance = 1e-9)
{
  CHECK(CGAL::is_valid_polygon_mesh(after));
  CHECK(CGAL::is_triangle_mesh(after));
  const Hde::Topology_measures old_topology = Hde::measure_topology(before), topology = Hde::measure_topology(after);
  CHECK(topology.number_of_isolated_vertices == 0);
  CHECK(topology.number_of_components == old_topology.number_of_components);
  CHECK(topology.number_of_boundary_loops == old_topology.number_of_boundary_loops);
  CHECK(topology.euler_characteristic == old_topology.euler_characteristic);
  const Hde::Embedding_measures embedding = Hde::measure_embedding(after, function);
  CHECK(embedding.number_of_folded_faces == 0);
  CHECK(Hde::measure_shape(after).number_of_degenerate_faces == 0);
  CHECK(!CGAL::Polygon_mesh_processing::does_self_intersect(after));
  const Hde::Zero_set_measures distance =
      Hde::measure_distance_to_zero_set(after, function, params::number_of_points_on_faces(1000));
  CHECK(distance.interior_vertex_max <= largest_distance * shapes::bounding_box_diagonal(before));
  std::cout << name << ": " << topology.number_of_faces << " faces, folds " << embedding.number_of_folded_faces
            << ", vertices/D " << distance.interior_vertex_max / shapes::bounding_box_diagonal(before) << std::endl;
}

// uniform and isotropic in the embedding
template <typename TriangleMesh, typename Function>
void check_quality(const TriangleMesh& mesh, const Function& function, const Hde::Remeshing_result& result,
                   const Bounds& bounds = Bounds())
{
  const Hde::Embedding_measures measures =
      Hde::measure_embedding(mesh, function, params::sigma(result.sigma).target_edge_length(result.target_edge_length));
  std::cout << "  lengths " << measures.share_within_sqrt_2 << ", mean/l "
            << measures.edge_length_mean / result.target_edge_length << ", angle " << measures.minimum_angle_mean << " / "
            << measures.minimum_angle_least << std::endl;
  CHECK(measures.share_within_sqrt_2 >= bounds.least_share_of_lengths);
  CHECK(measures.minimum_angle_mean >= bounds.least_mean_angle);
  CHECK_CLOSE(measures.edge_length_mean, result.target_edge_length, 0.1 * result.target_edge_length);
}

// without those that are marked as removed
template <typename TriangleMesh>
std::size_t number_of_faces_of(const TriangleMesh& mesh)
{
  return std::size_t(std::distance(faces(mesh).begin(), faces(mesh).end()));
}

// to one per cent, and to a split, which makes two faces
template <typename TriangleMesh>
void check_number_of_faces(const TriangleMesh& mesh, const std::size_t wanted)
{
  CHECK_CLOSE(number_of_faces_of(mesh), wanted, (std::max)(0.01 * double(wanted), 2.));
}

// a number that differs, but for a chance of 1e-19, if a bit of a coordinate or an index of the faces does
template <typename TriangleMesh>
std::uint64_t digest(const TriangleMesh& mesh)
{
  std::uint64_t hash = 14695981039346656037u; // of Fowler, Noll and Vo
  const auto add = [&hash](const std::uint64_t bits)
  {
    for (int shift = 0; shift < 64; shift += 8)
      hash = (hash ^ ((bits >> shift) & 255)) * 1099511628211u;
  };
  const auto vpm = get(CGAL::vertex_point, mesh);
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::uint64_t> indices;
  for (const auto v : vertices(mesh))
  {
    indices.emplace(v, indices.size());
    for (int i = 0; i < 3; ++i)
    {
      const double coordinate = get(vpm, v)[i];
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      add(bits);
    }
  }
  for (const auto f : faces(mesh))
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      add(indices.at(v));
  return hash;
}

// the topology of the input, without degenerate faces and new folds
template <typename TriangleMesh>
void check_same_topology(const TriangleMesh& before, const TriangleMesh& after)
{
  CHECK(CGAL::is_valid_polygon_mesh(after));
  CHECK(CGAL::is_triangle_mesh(after));
  const Hde::Topology_measures old_topology = Hde::measure_topology(before), topology = Hde::measure_topology(after);
  CHECK(topology.number_of_components == old_topology.number_of_components);
  CHECK(topology.number_of_boundary_loops == old_topology.number_of_boundary_loops);
  CHECK(topology.euler_characteristic == old_topology.euler_characteristic);
  const Hde::Shape_measures shape = Hde::measure_shape(after);
  CHECK(shape.number_of_degenerate_faces == 0);
  CHECK(shape.number_of_folded_edges <= Hde::measure_shape(before).number_of_folded_edges);
}

// Stops the remeshing after more and more questions. Whenever it stops, the mesh has the topology of the input;
// `check(result, mesh)` checks more.
template <typename TriangleMesh, typename Remesh, typename Check>
void check_stopping(const TriangleMesh& input, const std::size_t largest, const std::size_t step, const Remesh& remesh,
                    const Check& check)
{
  struct Stopping_visitor : Hde::Remeshing_visitor
  {
    std::size_t questions = 0, last = 0;
    bool go_further() { return ++questions < last; }
  };
  std::size_t number_of_results = 0;
  for (std::size_t last = 1; last < largest; last += step)
  {
    Stopping_visitor visitor;
    visitor.last = last;
    TriangleMesh mesh = input;
    const Hde::Remeshing_result result = remesh(mesh, visitor);
    check_same_topology(input, mesh);
    number_of_results += result.was_stopped ? 1 : 0;
    check(result, mesh);
  }
  CHECK(number_of_results > 2);
}

} // namespace remeshing_checks

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_REMESHING_CHECKS_H
