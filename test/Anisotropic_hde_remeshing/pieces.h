// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What the tests of remeshing in pieces share: meshes as input in shares.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PIECES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PIECES_H

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Input_shares.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Joined_numbers.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Pieces_remesher.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace pieces {

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
typedef CGAL::Parallel_if_available_tag Concurrency_tag;

template <typename Mesh>
internal::Shares_of_soup shares_of(const Mesh& mesh, const std::size_t faces_of_share)
{
  std::vector<internal::Vector> points;
  std::vector<internal::Shares_of_soup::Triangle> triangles;
  for (const auto v : mesh.vertices())
    points.push_back(internal::to_vector(mesh.point(v)));
  for (const auto f : mesh.faces())
  {
    internal::Shares_of_soup::Triangle triangle{};
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangle[k++] = v;
    triangles.push_back(triangle);
  }
  return internal::Shares_of_soup(std::move(points), std::move(triangles), faces_of_share);
}

struct Remeshed
{
  internal::Pieces_result result;
  std::vector<internal::Vector> points;
  std::vector<internal::Shares_of_soup::Triangle> faces;

  bool operator==(const Remeshed& other) const { return points == other.points && faces == other.faces; }

  template <typename Mesh>
  Mesh mesh() const
  {
    Mesh mesh;
    std::vector<typename Mesh::Vertex_index> vertices;
    for (const internal::Vector& p : points)
      vertices.push_back(mesh.add_vertex(typename Mesh::Point(p.x(), p.y(), p.z())));
    for (const auto& face : faces)
      if (mesh.add_face(vertices[face[0]], vertices[face[1]], vertices[face[2]]) == Mesh::null_face())
        throw std::logic_error("the joined mesh is not manifold");
    return mesh;
  }
};

inline Remeshed remesh(const internal::Input_shares& shares, internal::Task_team& team, internal::Piece_store& store,
                       const internal::Pieces_request& request)
{
  namespace params = CGAL::Anisotropic_hde_remeshing::parameters;
  const auto np = params::number_of_iterations(10);
  const auto np_of_function = params::close_holes(false);
  typedef internal::Pieces_remesher<Concurrency_tag, std::decay_t<decltype(np)>, std::decay_t<decltype(np_of_function)>>
      Remesher;
  Remeshed remeshed;
  remeshed.result = Remesher(shares, team, store, request, np, np_of_function)();
  const internal::Joined_numbers numbers(remeshed.result.counts);
  for (std::size_t i = 0; i < remeshed.result.holders.size(); ++i)
  {
    const auto part = numbers.part(i, internal::from_bytes<internal::Piece_faces>(store.get(remeshed.result.holders[i])));
    remeshed.points.insert(remeshed.points.end(), part.points.begin(), part.points.end());
    for (const auto& face : part.faces)
      remeshed.faces.push_back({std::size_t(face[0]), std::size_t(face[1]), std::size_t(face[2])});
  }
  return remeshed;
}

inline Remeshed remesh(const internal::Input_shares& shares, const internal::Pieces_request& request)
{
  internal::Team_of_one team;
  internal::Memory_store store;
  return remesh(shares, team, store, request);
}

} // namespace pieces

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PIECES_H
