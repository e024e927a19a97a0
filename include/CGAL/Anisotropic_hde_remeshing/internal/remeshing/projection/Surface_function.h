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
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The caller's function without its type. The remesher is no template of that type, so it is compiled once for all functions,
// which takes half a minute. A call through a pointer takes nanoseconds, an evaluation of radial basis functions microseconds.
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

    Value_and_gradient operator()(const Vector& p) const { return m_evaluate(m_function, p); }

  private:
    template <typename Function>
    static Value_and_gradient evaluate(const void* function, const Vector& p)
    {
      return value_and_gradient_of(*static_cast<const Function*>(function), p);
    }

    const void* m_function;
    Value_and_gradient (*m_evaluate)(const void*, const Vector&);
  };

  // keeps references to the pieces of the function
  template <typename Function>
  explicit Surface_function(const Function& function) : m_is_piecewise(internal::is_piecewise<Function>)
  {
    for (std::size_t i = 0; i < internal::number_of_pieces(function); ++i)
      m_pieces.emplace_back(internal::piece(function, Region(i)));
  }

  // whether the function is meant to have sharp edges
  bool is_piecewise() const { return m_is_piecewise; }

  std::size_t number_of_pieces() const { return m_pieces.size(); }
  const Piece& piece(const std::size_t i) const { return m_pieces[i]; }

private:
  std::vector<Piece> m_pieces;
  bool m_is_piecewise;
};

inline Value_and_gradient value_and_gradient_of(const Surface_function::Piece& piece, const Vector& p) { return piece(p); }

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_PROJECTION_SURFACE_FUNCTION_H
