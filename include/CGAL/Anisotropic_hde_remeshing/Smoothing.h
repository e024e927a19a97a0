// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_SMOOTHING_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_SMOOTHING_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/// \ingroup PkgAnisotropicHdeRemeshingImplicit
///
/// What the named parameter `smoothing` takes: a length, the standard deviation of the noise of the points, or
/// `AUTOMATIC_SMOOTHING`. A number will do for a length. This type is for programs that choose between the two when they run.
class Smoothing
{
public:
  /// a length
  template <typename FT>
  explicit Smoothing(const FT& length) : m_length(CGAL::to_double(length)), m_is_automatic(false)
  {
  }

  /// the constant below
  static constexpr Smoothing automatic() { return Smoothing(); }

  bool is_automatic() const { return m_is_automatic; } ///< whether the noise is estimated
  double length() const { return m_length; }           ///< the standard deviation of the noise, if it is not

private:
  constexpr Smoothing() = default;

  double m_length = 0;
  bool m_is_automatic = true;
};

/// \ingroup PkgAnisotropicHdeRemeshingImplicit
///
/// for the named parameter `smoothing`: the noise is estimated from the points
inline constexpr Smoothing AUTOMATIC_SMOOTHING = Smoothing::automatic();

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_SMOOTHING_H
