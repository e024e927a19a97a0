// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_PIECES_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_PIECES_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A smooth part of the surface. It has the number of a piece of the function, and is in the zero set of this piece. A smooth
// surface is one region, 0.
typedef std::uint32_t Region;

// The functions below make all functions look piecewise. A model of `PiecewiseImplicitFunction` has its pieces. A model of
// `ImplicitFunctionWithGradient` has one piece, itself.
template <typename Function, typename = void>
struct Pieces
{
  typedef Function Piece;
  static std::size_t number(const Function&) { return 1; }
  static const Piece& piece(const Function& function, std::size_t) { return function; }
};

template <typename Function>
struct Pieces<Function, std::void_t<decltype(std::declval<const Function&>().number_of_pieces()),
                                    decltype(std::declval<const Function&>().piece(std::size_t(0)))>>
{
  typedef std::decay_t<decltype(std::declval<const Function&>().piece(std::size_t(0)))> Piece;
  static std::size_t number(const Function& function) { return function.number_of_pieces(); }
  static const Piece& piece(const Function& function, const std::size_t i) { return function.piece(i); }
};

template <typename Function>
using Piece_of = typename Pieces<Function>::Piece;

template <typename Function>
constexpr bool is_piecewise = !std::is_same<Piece_of<Function>, Function>::value;

template <typename Function>
std::size_t number_of_pieces(const Function& function)
{
  return Pieces<Function>::number(function);
}

template <typename Function>
const Piece_of<Function>& piece(const Function& function, const Region region)
{
  return Pieces<Function>::piece(function, region);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_PIECES_H
