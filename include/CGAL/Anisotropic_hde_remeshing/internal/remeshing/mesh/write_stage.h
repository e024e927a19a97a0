// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_WRITE_STAGE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_WRITE_STAGE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#ifdef CGAL_AHR_WRITE_STAGES
#  include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>

#  include <atomic>
#  include <fstream>
#  include <string>
#  include <vector>
#endif

// A look inside while it runs. Define CGAL_AHR_WRITE_STAGES as a string, the beginning of the names of files. Then each stage
// writes the working mesh with its states to the next file, such as stage_007_iteration_1_split.vtk, for ParaView or f3d.

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

#ifdef CGAL_AHR_WRITE_STAGES

// Writes the mesh in VTK's legacy format, in the unit of the working mesh. The figures of vertices: on a curve, fixed, on the
// input, on a crease, and the normal. Those of faces: the region and the face of the input.
template <typename Mesh>
void write_stage(const Mesh& mesh, const std::string& name)
{
  static std::atomic<unsigned int> number{0};
  std::string digits = std::to_string(number++);
  digits.insert(0, digits.size() < 3 ? 3 - digits.size() : 0, '0');
  std::ofstream out(std::string(CGAL_AHR_WRITE_STAGES) + "_" + digits + "_" + name + ".vtk");
  out.precision(17);
  std::vector<std::size_t> numbers(vertex_capacity(mesh), 0);
  std::size_t n = 0;
  out << "# vtk DataFile Version 3.0\n"
      << name << "\nASCII\nDATASET POLYDATA\nPOINTS " << mesh.number_of_vertices() << " double\n";
  for (const Vertex_index v : mesh.vertices())
  {
    numbers[v] = n++;
    out << mesh.point(v).point.transpose() << '\n';
  }
  out << "POLYGONS " << mesh.number_of_faces() << ' ' << 4 * mesh.number_of_faces() << '\n';
  for (const Face_index f : mesh.faces())
  {
    const Triangle t(mesh.halfedge(f), mesh);
    out << "3 " << numbers[t.a] << ' ' << numbers[t.b] << ' ' << numbers[t.c] << '\n';
  }
  const auto write_figures = [&](const char* figure, const auto& elements, const auto& value)
  {
    out << "SCALARS " << figure << " double 1\nLOOKUP_TABLE default\n";
    for (const auto element : elements)
      out << double(value(element)) << '\n';
  };
  out << "POINT_DATA " << mesh.number_of_vertices() << '\n';
  write_figures("is_on_curve", mesh.vertices(), [&](const Vertex_index v) { return mesh.point(v).is_on_curve; });
  write_figures("is_fixed", mesh.vertices(), [&](const Vertex_index v) { return mesh.point(v).is_fixed; });
  write_figures("is_on_input", mesh.vertices(), [&](const Vertex_index v) { return mesh.point(v).is_on_input; });
  write_figures("is_on_crease", mesh.vertices(), [&](const Vertex_index v) { return mesh.point(v).is_on_crease; });
  out << "NORMALS normal double\n";
  for (const Vertex_index v : mesh.vertices())
    out << mesh.point(v).normal.transpose() << '\n';
  out << "CELL_DATA " << mesh.number_of_faces() << '\n';
  write_figures("region", mesh.faces(), [&](const Face_index f) { return mesh.region(mesh.halfedge(f)); });
  write_figures("input_face", mesh.faces(), [&](const Face_index f) { return mesh.input_face(f); });
}

#else

template <typename Mesh>
void write_stage(const Mesh&, const char*)
{
}

#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_MESH_WRITE_STAGE_H
