// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_EVALUATION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_EVALUATION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>

#include <CGAL/number_utils.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

template <typename Function, typename = void>
struct Has_joint_evaluation : std::false_type
{
};

template <typename Function>
struct Has_joint_evaluation<Function, std::void_t<decltype(std::declval<const Function&>().value_and_gradient(
                                          std::declval<const typename Function::Point_3&>()))>> : std::true_type
{
};

// value and gradient of any model of `ImplicitFunctionWithGradient`, in one call where it has one for both
template <typename Function>
Value_and_gradient value_and_gradient_of(const Function& function, const Vector& p)
{
  const typename Function::Point_3 point(p.x(), p.y(), p.z());
  const auto convert = [](const auto& value, const auto& g) {
    return Value_and_gradient{{to_double(value)}, Vector(to_double(g.x()), to_double(g.y()), to_double(g.z()))};
  };
  if constexpr (Has_joint_evaluation<Function>::value)
  {
    const auto both = function.value_and_gradient(point);
    return convert(both.first, both.second);
  }
  else
    return convert(function(point), function.gradient(point));
}

template <typename Function>
Vector gradient_of(const Function& function, const Vector& p)
{
  const auto g = function.gradient(typename Function::Point_3(p.x(), p.y(), p.z()));
  return Vector(to_double(g.x()), to_double(g.y()), to_double(g.z()));
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_FUNCTIONS_EVALUATION_H
