// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACET_PLANES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACET_PLANES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Piecewise_rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/regions/Region_plane.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The function of a surface of exact facets, a model of `PiecewiseImplicitFunction`: the piece of each facet is the signed distance to
// its plane. Unlike `Piecewise_rbf_implicit_function`, it needs no more than a plane for each of what may be a million facets.
// Copies share the planes.
template <typename GeomTraits>
class Facet_planes
{
public:
  class Piece
  {
  public:
    typedef typename GeomTraits::FT FT;
    typedef typename GeomTraits::Point_3 Point_3;
    typedef typename GeomTraits::Vector_3 Vector_3;
    typedef Point_3 Point;

    explicit Piece(const Region_plane& plane) : m_plane(plane) {}

    FT operator()(const Point_3& p) const { return value_and_gradient(p).first; }
    Vector_3 gradient(const Point_3& p) const { return value_and_gradient(p).second; }
    std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
    {
      const Value_and_gradient at_p = m_plane(to_vector(p));
      return {FT(at_p.value), Vector_3(FT(at_p.gradient[0]), FT(at_p.gradient[1]), FT(at_p.gradient[2]))};
    }

  private:
    Region_plane m_plane;
  };

  explicit Facet_planes(const std::vector<Region_plane>& planes)
    : m_pieces(std::make_shared<const std::vector<Piece>>(planes.begin(), planes.end()))
  {
  }

  std::size_t number_of_pieces() const { return m_pieces->size(); }
  const Piece& piece(const std::size_t i) const { return (*m_pieces)[i]; }

  Piecewise_rbf_diagnostics diagnostics() const
  {
    Piecewise_rbf_diagnostics result;
    result.number_of_regions = result.number_of_planes = number_of_pieces();
    result.memory_bytes = number_of_pieces() * sizeof(Piece);
    return result;
  }

private:
  std::shared_ptr<const std::vector<Piece>> m_pieces;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REGIONS_FACET_PLANES_H
