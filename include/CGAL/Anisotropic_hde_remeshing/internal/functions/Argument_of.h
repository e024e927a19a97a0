// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_ARGUMENT_OF_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_ARGUMENT_OF_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The type of the only argument of a function, a function object or a lambda; `void` if it is a template or overloaded, or takes
// another number of arguments.
template <typename Class, typename Result, typename Argument>
std::decay_t<Argument> argument_of(Result (Class::*)(Argument) const);
template <typename Class, typename Result, typename Argument>
std::decay_t<Argument> argument_of(Result (Class::*)(Argument) const noexcept);

template <typename Callable, typename = void>
struct Argument_of
{
  typedef void type;
};
template <typename Callable>
struct Argument_of<Callable, std::void_t<decltype(argument_of(&Callable::operator()))>>
{
  typedef decltype(argument_of(&Callable::operator())) type;
};
template <typename Result, typename Argument>
struct Argument_of<Result (*)(Argument), void>
{
  typedef std::decay_t<Argument> type;
};
template <typename Result, typename Argument>
struct Argument_of<Result (*)(Argument) noexcept, void>
{
  typedef std::decay_t<Argument> type;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_ARGUMENT_OF_H
