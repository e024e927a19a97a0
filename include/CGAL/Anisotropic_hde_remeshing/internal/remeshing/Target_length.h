// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGET_LENGTH_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGET_LENGTH_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/remeshing/Working_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The edge length to aim at in the embedding: the one of the caller, or the one that gives the caller's number of faces.
// The area in the embedding of a noisy surface grows with the number of vertices that see the noise, so that the length is
// corrected by the number of faces that it has given.
class Target_length
{
  // the area of a mesh over that of as many equilateral triangles of the target length, measured on smooth surfaces
  inline static const double area_ratio = getenv("AR")?atof(getenv("AR")):1.15;
  static constexpr double largest_correction = 1.5; // of the length, at once

public:
  static Target_length of_length(const double length) { return Target_length(length, 0); }

  template <typename Embedding>
  static Target_length of_number_of_faces(const std::size_t number_of_faces, const Working_mesh& mesh,
                                          const Embedding& embedding)
  {
    const double equilateral_area = area(mesh, embedding) * area_ratio / double(number_of_faces);
    return Target_length(std::sqrt(equilateral_area * 4 / std::sqrt(3.)), number_of_faces);
  }

  double length() const { return m_length; }

  bool is_number_of_faces() const { return m_number_of_faces > 0; }

  // corrects the length by the area of the mesh as it is now
  template <typename Embedding>
  void correct(const Working_mesh& mesh, const Embedding& embedding)
  {
    if (is_number_of_faces())
      *this = of_number_of_faces(m_number_of_faces, mesh, embedding);
  }

  // how many faces there are too many, negative if there are too few
  std::ptrdiff_t excess(const std::size_t number_of_faces) const
  {
    return is_number_of_faces() ? std::ptrdiff_t(number_of_faces) - std::ptrdiff_t(m_number_of_faces) : 0;
  }

public:
  Target_length(const double length, const std::size_t number_of_faces)
    : m_length(length), m_number_of_faces(number_of_faces)
  {
  }

  template <typename Embedding>
  static double area(const Working_mesh& mesh, const Embedding& embedding)
  {
    double sum = 0;
    for (const Face_index f : mesh.faces())
    {
      const Triangle t(mesh.halfedge(f), mesh);
      const double x = embedding.squared_length(mesh.point(t.a), mesh.point(t.b)),
                   y = embedding.squared_length(mesh.point(t.b), mesh.point(t.c)),
                   z = embedding.squared_length(mesh.point(t.c), mesh.point(t.a));
      sum += 0.25 * std::sqrt((std::max)(2 * (x * y + y * z + z * x) - (x * x + y * y + z * z), 0.));
    }
    return sum;
  }

  double m_length;
  std::size_t m_number_of_faces; // 0: the length is the caller's
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_TARGET_LENGTH_H
