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

} // namespace pieces

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_TEST_PIECES_H
