// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Vertices that all move at once: moves that fold a face, or make an edge bad, are taken back, with those to which this does the same
// in turn, and no others.

#include "check.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/guards/Simultaneous_moves.h>

#include <CGAL/tags.h>

#include <vector>

namespace internal = CGAL::Anisotropic_hde_remeshing::internal;
using internal::Vector;
using internal::Vertex_index;

struct Nothing
{
};
typedef internal::Working_mesh<Nothing> Working_mesh;
typedef Working_mesh::Vertex Vertex;

// the vertices of a grid of n by n squares in the plane, each cut in two triangles
std::vector<Vertex_index> make_grid(const int n, Working_mesh& mesh)
{
  std::vector<Vertex_index> vertices;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
    {
      Vertex state;
      state.point = Vector(x, y, 0);
      state.normal = Vector(0, 0, 1);
      vertices.push_back(mesh.add_vertex(state));
    }
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
    {
      const auto v = [&](const int dx, const int dy) { return vertices[std::size_t((y + dy) * (n + 1) + x + dx)]; };
      mesh.add_face(v(0, 0), v(1, 0), v(1, 1));
      mesh.add_face(v(0, 0), v(1, 1), v(0, 1));
    }
  return vertices;
}

template <typename ConcurrencyTag>
void test_moves()
{
  const int n = 8;
  Working_mesh mesh;
  const std::vector<Vertex_index> vertices = make_grid(n, mesh);
  const auto at = [&](const int x, const int y) { return vertices[std::size_t(y * (n + 1) + x)]; };
  internal::Interruption never;

  // three neighbours move two units to the right: the first two keep their distance, the third folds the faces before it;
  // without it the second does, and without that the first. One elsewhere moves a little, and one is not chosen.
  internal::Simultaneous_moves<Working_mesh> moves(mesh);
  moves.propose<ConcurrencyTag>([&](const Vertex_index v) { return v != at(6, 6); },
                                [&](const Vertex_index v, Vertex& state, Working_mesh::Sides&)
                                {
                                  for (const int x : {1, 2, 3})
                                    if (v == at(x, 3))
                                      state.point[0] += 2;
                                  if (v == at(6, 1) || v == at(6, 6))
                                    state.point[0] += 0.25;
                                  return state.point != mesh.point(v).point;
                                },
                                never);
  CHECK(moves.is_moved(at(1, 3)) && moves.is_moved(at(3, 3)) && moves.is_moved(at(6, 1)));
  CHECK(!moves.is_moved(at(6, 6)) && !moves.is_moved(at(0, 0)));
  CHECK(moves.revert_folds<ConcurrencyTag>(never) == 3);
  for (const int x : {1, 2, 3})
    CHECK(!moves.is_moved(at(x, 3)) && moves.state(at(x, 3)).point == mesh.point(at(x, 3)).point);
  CHECK(moves.is_moved(at(6, 1)) && moves.state(at(6, 1)).point == Vector(6.25, 1, 0));

  // all together they fold nothing
  internal::Simultaneous_moves<Working_mesh> shift(mesh);
  shift.propose<ConcurrencyTag>([](Vertex_index) { return true; },
                                [](Vertex_index, Vertex& state, Working_mesh::Sides&)
                                {
                                  state.point[0] += 2;
                                  return true;
                                },
                                never);
  CHECK(shift.template revert_folds<ConcurrencyTag>(never) == 0);

  // two neighbours onto one point, where their faces have no height left, whether there are normals or not
  for (const internal::Fold_test test : {internal::Fold_test::EDGES, internal::Fold_test::NORMALS_AND_EDGES})
  {
    internal::Simultaneous_moves<Working_mesh> meeting(mesh);
    meeting.propose<ConcurrencyTag>([&](const Vertex_index v) { return v == at(3, 3) || v == at(4, 3) || v == at(6, 6); },
                                    [](Vertex_index, Vertex& state, Working_mesh::Sides&)
                                    {
                                      state.point[0] = state.point[0] < 5 ? 3.5 : 6.25;
                                      return true;
                                    },
                                    never);
    CHECK(meeting.template revert_folds<ConcurrencyTag>(never, test) == 2);
    CHECK(!meeting.is_moved(at(3, 3)) && !meeting.is_moved(at(4, 3)) && meeting.is_moved(at(6, 6)));
  }
}

// along a row, whose edges must not become longer than 1.5
template <typename ConcurrencyTag>
void test_edges()
{
  const int n = 8;
  Working_mesh mesh;
  const std::vector<Vertex_index> vertices = make_grid(n, mesh);
  const auto at = [&](const int x) { return vertices[std::size_t(3 * (n + 1) + x)]; };
  internal::Interruption never;

  // The first two move apart, each no further than it may while the other is at rest; the third may only follow the second. The
  // last one does no harm.
  internal::Simultaneous_moves<Working_mesh> moves(mesh);
  moves.propose<ConcurrencyTag>([&](const Vertex_index v) { return v == at(2) || v == at(3) || v == at(4) || v == at(6); },
                                [&](const Vertex_index v, Vertex& state, Working_mesh::Sides&)
                                {
                                  state.point[0] += v == at(2) ? -0.4 : v == at(4) ? 0.8 : 0.4;
                                  return true;
                                },
                                never);
  moves.revert_edges<ConcurrencyTag>(
      [&](const internal::Edge_index e)
      {
        const Vector &p = moves.state(mesh.vertex(e, 0)).point, &q = moves.state(mesh.vertex(e, 1)).point;
        return p[1] == 3 && q[1] == 3 && (p - q).norm() > 1.5;
      },
      never);
  CHECK(!moves.is_moved(at(2)) && !moves.is_moved(at(3)) && !moves.is_moved(at(4)));
  CHECK(moves.is_moved(at(6)));
}

int main()
{
  test_moves<CGAL::Sequential_tag>();
  test_edges<CGAL::Sequential_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  test_moves<CGAL::Parallel_tag>();
  test_edges<CGAL::Parallel_tag>();
#endif
  return check_summary();
}
