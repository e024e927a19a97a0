// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_MAKE_IMPLICIT_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_MAKE_IMPLICIT_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Argument_of.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/type_traits.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

namespace internal {

// the gradient by central differences
template <typename GeomTraits, typename Function>
class Gradient_by_differences
{
  typedef typename GeomTraits::Point_3 Point_3;

  static constexpr double size_of_details = 0.01; // over that of the surface

public:
  explicit Gradient_by_differences(const double size) : m_size(checked_positive("the size of the surface", size)) {}

  typename GeomTraits::Vector_3 operator()(const Function& f, const Point_3& p) const
  {
    const std::array<double, 3> x{{to_double(p.x()), to_double(p.y()), to_double(p.z())}};
    const double h = step((std::max)({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}));
    std::array<double, 3> g{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::array<double, 3> above = x, below = x;
      above[i] += h;
      below[i] -= h;
      const auto difference = f(Point_3(above[0], above[1], above[2])) - f(Point_3(below[0], below[1], below[2]));
      g[i] = to_double(difference) / (above[i] - below[i]); // the step is rounded, too
    }
    return typename GeomTraits::Vector_3(g[0], g[1], g[2]);
  }

private:
  // Points are rounded by epsilon times the largest coordinate, which the step divides; the curvature of the function at its
  // details gives an error of the square of the step. This is where both are alike.
  double step(const double largest_coordinate) const
  {
    const double details = size_of_details * m_size;
    return std::cbrt(std::numeric_limits<double>::epsilon() * (std::max)(largest_coordinate, m_size) * details * details);
  }

  double m_size;
};

// the gradient of the caller
template <typename GeomTraits, typename Gradient>
class Gradient_of_caller
{
public:
  explicit Gradient_of_caller(Gradient gradient) : m_gradient(std::move(gradient)) {}

  template <typename Function>
  typename GeomTraits::Vector_3 operator()(const Function&, const typename GeomTraits::Point_3& p) const
  {
    return m_gradient(p);
  }

private:
  Gradient m_gradient;
};

// the kernel that is given, or that of the points that the function takes; `void` if neither is known
template <typename GeomTraits, typename Function, typename = void>
struct Kernel_of_function
{
  typedef void type;
};
template <typename GeomTraits, typename Function>
struct Kernel_of_function<GeomTraits, Function, std::enable_if_t<!std::is_void<GeomTraits>::value>>
{
  typedef GeomTraits type;
};
template <typename Function>
struct Kernel_of_function<void, Function, std::enable_if_t<Has_coordinates<typename Argument_of<Function>::type>::value>>
{
  typedef typename Kernel_traits<typename Argument_of<Function>::type>::Kernel type;
};

// whether a function of points of the kernel returns a number; if not, an error of the compiler says what is wrong
template <typename GeomTraits, typename Function>
constexpr bool accepts_callable()
{
  constexpr bool has_kernel = !std::is_void<GeomTraits>::value;
  static_assert(has_kernel, "the function must take one point of a kernel by a call operator that is const and no template; "
                            "for others the kernel is given: make_implicit_function<Kernel>(f)");
  if constexpr (has_kernel)
  {
    typedef typename GeomTraits::Point_3 Point_3;
    constexpr bool is_callable = std::is_invocable<const Function&, const Point_3&>::value;
    static_assert(is_callable, "the function must take a point of the kernel and be callable when const");
    if constexpr (is_callable)
    {
      constexpr bool returns_number = is_number<std::decay_t<std::invoke_result_t<const Function&, const Point_3&>>>;
      static_assert(returns_number, "the function must return a number");
      return returns_number;
    }
  }
  return false;
}

} // namespace internal

/*!
\ingroup PkgAnisotropicHdeRemeshingImplicit

A function of the user's as an implicit function, made by `make_implicit_function()`.

\tparam GeomTraits a kernel
\tparam Function a function object that takes a point and returns a number
\tparam Gradient tells the gradient

\cgalModels{ImplicitFunctionWithGradient}
*/
template <typename GeomTraits, typename Function, typename Gradient>
class Implicit_function_of_callable
{
public:
  typedef GeomTraits Geom_traits;
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Point_3 Point_3;
  typedef typename GeomTraits::Vector_3 Vector_3;
  typedef Point_3 Point; ///< as the concept `ImplicitFunction` calls it

  Implicit_function_of_callable(Function function, Gradient gradient)
    : m_function(std::move(function)), m_gradient(std::move(gradient))
  {
  }

  /// the value at `p`
  FT operator()(const Point_3& p) const { return FT(m_function(p)); }

  /// the gradient at `p`
  Vector_3 gradient(const Point_3& p) const { return m_gradient(m_function, p); }

private:
  Function m_function;
  Gradient m_gradient;
};

/*!
\ingroup PkgAnisotropicHdeRemeshingImplicit

makes an implicit function of a lambda or any other function, whose gradient is found by central differences:

\code{.cpp}
const auto ellipsoid = [](const Kernel::Point_3& p) { return p.x() * p.x() + p.y() * p.y() / 4 + p.z() * p.z() / 25 - 1; };
CGAL::anisotropic_hde_remeshing(mesh, Hde::make_implicit_function(ellipsoid, 10));
\endcode

A gradient takes six evaluations of `f`, which must be smooth and exact to rounding. The step of the differences is
\f$ h = (\epsilon c\, (0.01\, s)^2)^{1/3} \f$, with the size \f$ s \f$, the larger one \f$ c \f$ of \f$ s \f$ and the largest coordinate of
the point, and the rounding \f$ \epsilon = 2.2 \cdot 10^{-16} \f$: 2.8e-7 of the size where the surface is not far from the origin.
The gradient is then exact to about nine digits if the function varies over a hundredth of the size, and to about eight for a
thousandth. Where \f$ c \f$ is a thousand times the size, these are eight and six. At an edge of the function, such as that of a minimum
of two, it is between the gradients of both sides.

\tparam GeomTraits a kernel. Without it, it is that of the points that `f` takes.
\tparam Function a function, or an object whose call operator is const, that takes a point and returns a number. If its call operator is
        a template, as that of a generic lambda, `GeomTraits` must be given. It is copied, and called concurrently unless the
        remeshing is sequential.

\param f negative inside, zero on the surface, positive outside
\param size about the size of the surface, such as the diagonal of its bounding box, in the unit of the coordinates. It may well be ten
       times too large or too small. The default is good to five digits for surfaces of a size from 0.01 to 10,000.

\throw std::invalid_argument if `size` is not finite and positive
*/
template <typename GeomTraits = void, typename Function>
auto make_implicit_function(Function f, const double size = 1)
{
  typedef typename internal::Kernel_of_function<GeomTraits, Function>::type Kernel;
  constexpr bool is_accepted = internal::accepts_callable<Kernel, Function>();
  if constexpr (is_accepted)
  {
    typedef internal::Gradient_by_differences<Kernel, Function> Gradient;
    return Implicit_function_of_callable<Kernel, Function, Gradient>(std::move(f), Gradient(size));
  }
}

/*!
\ingroup PkgAnisotropicHdeRemeshingImplicit

makes an implicit function of a callable and its gradient.

\tparam GeomTraits as above
\tparam Function as above
\tparam Gradient as `Function`, but returns a vector of the kernel

\param f negative inside, zero on the surface, positive outside
\param gradient its gradient, outward, of any positive length
*/
#ifdef DOXYGEN_RUNNING
template <typename GeomTraits = void, typename Function, typename Gradient>
#else
template <typename GeomTraits = void, typename Function, typename Gradient,
          typename = std::enable_if_t<!internal::is_number<Gradient>>>
#endif
auto make_implicit_function(Function f, Gradient gradient)
{
  typedef typename internal::Kernel_of_function<GeomTraits, Function>::type Kernel;
  constexpr bool is_accepted = internal::accepts_callable<Kernel, Function>();
  if constexpr (is_accepted)
  {
    constexpr bool has_gradient =
        std::is_invocable_r<typename Kernel::Vector_3, const Gradient&, const typename Kernel::Point_3&>::value;
    static_assert(has_gradient, "the gradient must take a point of the kernel and return a vector of it");
    if constexpr (has_gradient)
    {
      typedef internal::Gradient_of_caller<Kernel, Gradient> Gradient_of_caller;
      return Implicit_function_of_callable<Kernel, Function, Gradient_of_caller>(std::move(f),
                                                                                 Gradient_of_caller(std::move(gradient)));
    }
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_MAKE_IMPLICIT_FUNCTION_H
