// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_MESH_OF_PIECE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_MESH_OF_PIECE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Piece_faces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Disjoint_sets.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The faces of a piece as a mesh that the remesher takes. Behind each seam is one more face, a flap, that is not to be remeshed.
// So the remesher keeps the seams: it takes them for the border of a range of faces. A vertex in which several fans of
// faces touch, as a piece may have it though the whole mesh has not, becomes one vertex for each fan. All its copies are on
// seams, so they stay where they are and keep the name.
class Mesh_of_piece
{
public:
  typedef Simple_cartesian<double> Kernel;
  typedef Surface_mesh<Kernel::Point_3> Mesh;

private:
  typedef Mesh::Vertex_index Vertex;
  typedef Mesh::Face_index Face;
  static constexpr Vertex_name no_name = (std::numeric_limits<Vertex_name>::max)();

public:
  explicit Mesh_of_piece(const Piece_faces& faces)
    : m_names(m_mesh.add_property_map<Vertex, Vertex_name>("v:name_in_pieces", no_name).first),
      m_seams(m_mesh.add_property_map<Face, std::uint32_t>("f:seam", no_seam).first),
      m_seams_of_input(faces.seams)
  {
    const std::vector<Vertex> vertex_of_corner = add_vertices(faces);
    for (std::size_t f = 0; f < faces.faces.size(); ++f)
    {
      const std::array<Vertex, 3> v{{vertex_of_corner[3 * f], vertex_of_corner[3 * f + 1], vertex_of_corner[3 * f + 2]}};
      m_range.push_back(add_face(v, faces, f));
    }
    for (std::size_t i = 0; i < faces.seams.size(); ++i)
      add_flap(faces, i, vertex_of_corner);
  }

  Mesh& mesh() { return m_mesh; }

  // the faces that are to be remeshed
  const std::vector<Face>& range() const { return m_range; }

  // The faces as they are now, without the flaps. New vertices get names of the piece or region `maker`.
  Piece_faces faces(const std::uint32_t maker) const
  {
    Piece_faces result;
    std::vector<std::uint32_t> index(m_mesh.num_vertices(), Piece_faces::nobody), face_index(m_mesh.num_faces(), 0);
    Vertex_name next_name = (Vertex_name(maker) + 1) << bits_of_number;
    for (const Face f : m_mesh.faces())
    {
      if (m_seams[f] != no_seam)
        continue;
      std::array<std::uint32_t, 3> corners{};
      std::size_t k = 0;
      for (const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
      {
        if (index[v] == Piece_faces::nobody)
        {
          index[v] = std::uint32_t(result.names.size());
          result.names.push_back(m_names[v] == no_name ? next_name++ : m_names[v]);
          const Kernel::Point_3& p = m_mesh.point(v);
          result.points.emplace_back(p.x(), p.y(), p.z());
        }
        corners[k++] = index[v];
      }
      face_index[f] = std::uint32_t(result.faces.size());
      result.faces.push_back(corners);
    }
    for (const Face f : m_mesh.faces())
      if (m_seams[f] != no_seam)
        result.seams.push_back(seam_at_flap(f, result, index, face_index));
    return result;
  }

private:
  static constexpr std::uint32_t no_seam = (std::numeric_limits<std::uint32_t>::max)();

  // The corners of faces that are around one vertex in one fan become one vertex of the mesh.
  std::vector<Vertex> add_vertices(const Piece_faces& faces)
  {
    const Edge_table table(faces);
    Disjoint_sets fans(3 * faces.faces.size());
    for (std::size_t f = 0; f < faces.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        if (const Edge_table::Place* across = table.find(faces.name(f, k + 1), faces.name(f, k)))
        {
          fans.union_set(3 * f + k, 3 * across->face + (across->corner + 1) % 3);
          fans.union_set(3 * f + (k + 1) % 3, 3 * across->face + across->corner);
        }
    std::vector<Vertex> vertex_of_set(3 * faces.faces.size(), Mesh::null_vertex()), result;
    for (std::size_t i = 0; i < 3 * faces.faces.size(); ++i)
    {
      Vertex& v = vertex_of_set[fans.find_set(i)];
      if (v == Mesh::null_vertex())
      {
        const Vector& p = faces.point(i / 3, i % 3);
        v = m_mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
        m_names[v] = faces.name(i / 3, i % 3);
      }
      result.push_back(v);
    }
    return result;
  }

  Face add_face(const std::array<Vertex, 3>& v, const Piece_faces& faces, const std::size_t f)
  {
    const Face added = m_mesh.add_face(v[0], v[1], v[2]);
    if (added == Mesh::null_face())
      throw std::invalid_argument("the face of the vertices " + std::to_string(faces.name(f, 0)) + ", " +
                                  std::to_string(faces.name(f, 1)) + " and " + std::to_string(faces.name(f, 2)) +
                                  " is on a non-manifold edge or vertex");
    return added;
  }

  // The third point of a flap is a vertex of its own, so that the mesh is manifold there, however many flaps meet. It is inside the
  // face behind the seam, halfway from the middle of the edge to the centre. So flaps of one face or of neighbours do not touch, and
  // the tests of intersections see them as part of that face.
  void add_flap(const Piece_faces& faces, const std::size_t seam_index, const std::vector<Vertex>& vertex_of_corner)
  {
    const Piece_faces::Seam& seam = faces.seams[seam_index];
    const Vertex from = vertex_of_corner[3 * seam.face + seam.corner],
                 to = vertex_of_corner[3 * seam.face + (seam.corner + 1) % 3];
    const Vector middle = (faces.point(seam.face, seam.corner) + faces.point(seam.face, seam.corner + 1)) / 2;
    const Vector inside = middle + (Vector(seam.apex[0], seam.apex[1], seam.apex[2]) - middle) / 6;
    const Vertex apex = m_mesh.add_vertex(Kernel::Point_3(inside.x(), inside.y(), inside.z()));
    m_seams[add_face({{to, from, apex}}, faces, seam.face)] = std::uint32_t(seam_index);
  }

  Piece_faces::Seam seam_at_flap(const Face flap, const Piece_faces& result, const std::vector<std::uint32_t>& index,
                                 const std::vector<std::uint32_t>& face_index) const
  {
    for (const Mesh::Halfedge_index h : m_mesh.halfedges_around_face(m_mesh.halfedge(flap)))
    {
      const Mesh::Halfedge_index g = m_mesh.opposite(h);
      if (m_mesh.is_border(g))
        continue;
      Piece_faces::Seam seam = m_seams_of_input[m_seams[flap]];
      seam.face = face_index[m_mesh.face(g)];
      seam.corner = 0;
      while (result.faces[seam.face][seam.corner] != index[m_mesh.source(g)])
        ++seam.corner;
      return seam;
    }
    throw std::logic_error("a seam has been lost");
  }

  Mesh m_mesh;
  Mesh::Property_map<Vertex, Vertex_name> m_names;
  Mesh::Property_map<Face, std::uint32_t> m_seams; // of flaps: which seam of the input
  std::vector<Piece_faces::Seam> m_seams_of_input;
  std::vector<Face> m_range;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_MESH_OF_PIECE_H
