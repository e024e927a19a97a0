// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The caller's function without its type and in the unit of the working mesh. The remesher is no template of that type, so it
// is compiled once for all functions, which takes half a minute. A call through a pointer takes nanoseconds, an evaluation of
// radial basis functions microseconds. Behind this door nothing knows the caller's unit.
class Surface_function
{
public:
  // a reference to a piece of the function
  class Piece
  {
  public:
    template <typename Function>
    explicit Piece(const Function& function) : m_function(&function), m_evaluate(&evaluate<Function>)
    {
    }

    // `unit` is the unit of the points here, in the caller's
    void set_unit(const double unit) { m_unit = unit; }

    // The value is a length, so it has the unit of the points. It is not a number where the caller's point would overflow.
    Value_and_gradient operator()(const Vector& p) const
    {
      const Vector point = m_unit * p;
      if (!point.allFinite())
      {
        Value_and_gradient none;
        none.value = std::numeric_limits<double>::quiet_NaN();
        return none;
      }
      Value_and_gradient result = m_evaluate(m_function, point);
      result.value /= m_unit;
      return result;
    }

  private:
    template <typename Function>
    static Value_and_gradient evaluate(const void* function, const Vector& p)
    {
      return value_and_gradient_of(*static_cast<const Function*>(function), p);
    }

    const void* m_function;
    Value_and_gradient (*m_evaluate)(const void*, const Vector&);
    double m_unit = 1;
  };

  // none, where the facets of the input are the surface
  Surface_function() = default;

  // keeps references to the pieces of the function
  template <typename Function>
  explicit Surface_function(const Function& function) : m_is_piecewise(internal::is_piecewise<Function>)
  {
    for (std::size_t i = 0; i < internal::number_of_pieces(function); ++i)
      m_pieces.emplace_back(internal::piece(function, Region(i)));
  }

  // the same for points in `unit`, which is in the caller's
  Surface_function in_unit(const double unit) const
  {
    Surface_function result = *this;
    for (Piece& piece : result.m_pieces)
      piece.set_unit(unit);
    return result;
  }

  // whether the function is meant to have sharp edges
  bool is_piecewise() const { return m_is_piecewise; }

  std::size_t number_of_pieces() const { return m_pieces.size(); }
  const Piece& piece(const std::size_t i) const { return m_pieces[i]; }

private:
  std::vector<Piece> m_pieces;
  bool m_is_piecewise = false;
};

inline Value_and_gradient value_and_gradient_of(const Surface_function::Piece& piece, const Vector& p) { return piece(p); }

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_FUNCTION_H
