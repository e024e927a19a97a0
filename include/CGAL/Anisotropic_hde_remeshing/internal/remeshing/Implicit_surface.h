// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_IMPLICIT_SURFACE_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_IMPLICIT_SURFACE_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Jet.h>

#include <CGAL/number_utils.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// A model of ImplicitFunctionWithGradient in plain numbers. Where the model computes value and gradient in one call, that
// call is used.
template <typename Function>
class Implicit_surface
{
  typedef typename Function::Point_3 Point_3;

  template <typename F, typename = void>
  struct Has_value_and_gradient : std::false_type
  {};
  template <typename F>
  struct Has_value_and_gradient<
      F, std::void_t<decltype(std::declval<const F&>().value_and_gradient(std::declval<const Point_3&>()))>>
    : std::true_type
  {};

public:
  explicit Implicit_surface(const Function& function) : m_function(function) {}

  Value_and_gradient operator()(const Vector& p) const
  {
    const Point_3 point(p[0], p[1], p[2]);
    Value_and_gradient result;
    if constexpr (Has_value_and_gradient<Function>::value)
    {
      const auto pair = m_function.value_and_gradient(point);
      assign(pair.first, pair.second, result);
    }
    else
      assign(m_function(point), m_function.gradient(point), result);
    return result;
  }

private:
  template <typename FT, typename Vector_3>
  static void assign(const FT& value, const Vector_3& gradient, Value_and_gradient& result)
  {
    result.value = CGAL::to_double(value);
    result.gradient =
        Vector(CGAL::to_double(gradient.x()), CGAL::to_double(gradient.y()), CGAL::to_double(gradient.z()));
  }

  const Function& m_function;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_REMESHING_IMPLICIT_SURFACE_H
