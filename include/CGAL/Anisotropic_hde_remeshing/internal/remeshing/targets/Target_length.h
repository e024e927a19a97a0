// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_TARGET_LENGTH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_TARGET_LENGTH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/Working_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/mesh/embedded_triangle.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The edge length and the number of faces to aim at. The caller gives one of them. The other follows from the area A of the
// mesh in the embedding: N equilateral triangles of the edge length l fill it, so A = N sqrt(3)/4 l^2. The area is computed
// anew in every iteration, because the area of a noisy surface grows with the number of vertices that see the noise.
class Target_length
{
public:
  static Target_length of_length(const double length) { return Target_length(length, 0, true); }

  static Target_length of_number_of_faces(const std::size_t number_of_faces)
  {
    return Target_length(0, double(number_of_faces), false);
  }

  bool is_length_given() const { return m_is_length_given; }

  double length() const { return m_length; }

  double number_of_faces() const { return m_number_of_faces; }

  // the number asked for, or that of equilateral triangles of the length that fill the area in space
  double number_of_faces_over(const double area) const
  {
    return m_is_length_given ? area / (0.25 * std::sqrt(3.) * m_length * m_length) : m_number_of_faces;
  }

  // aims at another number of faces; `update()` makes the length follow
  void set_number_of_faces(const double number_of_faces) { m_number_of_faces = number_of_faces; }

  template <typename ConcurrencyTag, typename Mesh, typename Embedding>
  void update(const Mesh& mesh, const Embedding& embedding)
  {
    const double equilateral_area = 0.25 * std::sqrt(3.);
    if (m_is_length_given)
      m_number_of_faces = area<ConcurrencyTag>(mesh, embedding) / (equilateral_area * m_length * m_length);
    else
      m_length = std::sqrt(area<ConcurrencyTag>(mesh, embedding) / (equilateral_area * m_number_of_faces));
  }

private:
  Target_length(const double length, const double number_of_faces, const bool is_length_given)
    : m_length(length), m_number_of_faces(number_of_faces), m_is_length_given(is_length_given)
  {
  }

  // the area of the faces in the embedding
  template <typename ConcurrencyTag, typename Mesh, typename Embedding>
  static double area(const Mesh& mesh, const Embedding& embedding)
  {
    return parallel_sum<ConcurrencyTag>(face_capacity(mesh),
                                        [&](const std::size_t i)
                                        {
                                          const Face_index f(static_cast<Face_index::size_type>(i));
                                          return mesh.is_removed(f) ? 0. : area_of_face(f, mesh, embedding);
                                        });
  }

  template <typename Mesh, typename Embedding>
  static double area_of_face(const Face_index f, const Mesh& mesh, const Embedding& embedding)
  {
    const Corners<Mesh> t(mesh.halfedge(f), mesh);
    return Embedded_triangle::area(embedding.squared_length(t.a, t.b), embedding.squared_length(t.b, t.c),
                                   embedding.squared_length(t.c, t.a));
  }

  double m_length;
  double m_number_of_faces;
  bool m_is_length_given;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGETS_TARGET_LENGTH_H
