// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_SIZE_LIMITS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_SIZE_LIMITS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/text_of_number.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// What the indices have room for. The functions take numbers, so tests need no meshes of this size.

// the largest number of faces that can be asked for
constexpr std::size_t largest_number_of_faces = 500000000;

// of a Surface_mesh. Its indices have 32 bits, and the last index means none.
constexpr std::size_t largest_number_of_halfedges = 4294967294u;

// of a mesh that is read or written
inline void check_number_of_halfedges(const std::size_t number)
{
  if (number > largest_number_of_halfedges)
    throw std::length_error("a mesh of " + std::to_string(number) + " halfedges is too large: its indices have room for " +
                            std::to_string(largest_number_of_halfedges));
}

// how many edges can still be split; a split adds at most six halfedges
inline double room_for_splits(const std::size_t number_of_halfedges)
{
  return double((largest_number_of_halfedges -
                 (number_of_halfedges < largest_number_of_halfedges ? number_of_halfedges : largest_number_of_halfedges)) /
                6);
}

// The largest number of faces whose vertices can be fitted. Before equal entries are added up, the sparse matrix has nine for
// each face, counted by an int.
constexpr std::size_t largest_number_of_fitted_faces = std::size_t((std::numeric_limits<int>::max)()) / 9;

inline void check_number_of_fitted_faces(const double number)
{
  if (!(number <= double(largest_number_of_fitted_faces)))
    throw std::length_error("fit_to_surface is for at most " + std::to_string(largest_number_of_fitted_faces) + " faces, not " +
                            text_of_number(number));
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_SIZE_LIMITS_H
