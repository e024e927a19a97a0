// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Remeshes a surface with sharp edges whose smooth pieces are functions of one's own: a can, from 144 triangles to 4,000.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/anisotropic_hde_remeshing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

enum Piece_number : std::size_t
{
  SIDE,
  BOTTOM,
  TOP
};

// All pieces have one type: negative inside, with gradients that point outward.
struct Piece
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  Piece_number number;

  FT operator()(const Point_3& p) const
  {
    if (number == SIDE)
      return std::hypot(p.x(), p.y()) - 1;
    return number == TOP ? p.z() - 2 : -p.z();
  }
  Vector_3 gradient(const Point_3& p) const
  {
    if (number == SIDE)
      return Vector_3(p.x(), p.y(), 0) / std::hypot(p.x(), p.y());
    return Vector_3(0, 0, number == TOP ? 1 : -1);
  }
};

// the cylinder of radius 1 from z = 0 to z = 2: a model of `PiecewiseImplicitFunction`
struct Can
{
  std::array<Piece, 3> pieces = {{{SIDE}, {BOTTOM}, {TOP}}};

  std::size_t number_of_pieces() const { return pieces.size(); }
  const Piece& piece(const std::size_t i) const { return pieces[i]; }
};

// a prism near the can; the map tells the pieces of its faces
template <typename PatchMap>
void add_prism(const int sides, const int rows, Mesh& mesh, const PatchMap patch)
{
  const auto vertex = [&](const int i, const int row) { return Mesh::Vertex_index(row * sides + i % sides); };
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2 * CGAL_PI * i / sides;
      mesh.add_vertex(Kernel::Point_3(std::cos(angle), std::sin(angle), 2. * row / rows));
    }
  const auto bottom = mesh.add_vertex(Kernel::Point_3(0, 0, 0)), top = mesh.add_vertex(Kernel::Point_3(0, 0, 2));
  for (int i = 0; i < sides; ++i)
  {
    patch[mesh.add_face(vertex(i + 1, 0), vertex(i, 0), bottom)] = BOTTOM;
    patch[mesh.add_face(vertex(i, rows), vertex(i + 1, rows), top)] = TOP;
    for (int row = 0; row < rows; ++row)
    {
      patch[mesh.add_face(vertex(i, row), vertex(i + 1, row), vertex(i + 1, row + 1))] = SIDE;
      patch[mesh.add_face(vertex(i, row), vertex(i + 1, row + 1), vertex(i, row + 1))] = SIDE;
    }
  }
}

int main()
{
  Mesh mesh;
  const auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", SIDE).first;
  add_prism(12, 5, mesh, patch);

  const Can can;
  CGAL::anisotropic_hde_remeshing<CGAL::Parallel_if_available_tag>(
      mesh, can, params::sigma(0.5).number_of_target_faces(4000).face_patch_map(patch));

  // the map holds for the new faces; their vertices are on their piece, and on both where two pieces meet
  double largest = 0;
  for (const Mesh::Face_index f : mesh.faces())
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      largest = (std::max)(largest, std::abs(can.piece(patch[f])(mesh.point(v))));
  std::cout << mesh.number_of_faces() << " faces, written to can.off; the functions at their vertices: at most " << largest
            << std::endl;
  return CGAL::IO::write_polygon_mesh("can.off", mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
