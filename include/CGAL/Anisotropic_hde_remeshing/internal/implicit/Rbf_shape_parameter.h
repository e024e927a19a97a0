// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_SHAPE_PARAMETER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_SHAPE_PARAMETER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the width or the support radius of a kernel, and the inverse of its square in the unit of a patch
class Rbf_shape_parameter
{
public:
  // throws with this name unless the length is finite and positive
  Rbf_shape_parameter(const char* name, const double length, const bool is_in_coordinates)
    : m_length(checked_positive(name, length)), m_is_in_coordinates(is_in_coordinates), m_inverse_square(1. / (length * length))
  {
  }

  double length() const { return m_length; }

  // computes the parameter in the unit of a patch; `spacing` is the local spacing of the patch in the unit of the coordinates
  void set_unit(const double spacing)
  {
    m_inverse_square = 1. / (m_length * m_length);
    if (m_is_in_coordinates)
      m_inverse_square *= spacing * spacing;
  }

  double inverse_square() const { return m_inverse_square; }

private:
  double m_length;
  bool m_is_in_coordinates;
  double m_inverse_square;
};

// (x)_+ without a branch, for numbers and for arrays
template <class T>
T positive_part(const T& x)
{
  using std::abs;
  return 0.5 * (x + abs(x));
}

// Added to r^2 or r, they keep a logarithm or an inverse finite at a centre. The factors that it is multiplied by vanish there.
// They are so small that they change no digit elsewhere.
constexpr double smallest_squared_radius = (std::numeric_limits<double>::min)(), smallest_radius = 1.5e-154;

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_SHAPE_PARAMETER_H
