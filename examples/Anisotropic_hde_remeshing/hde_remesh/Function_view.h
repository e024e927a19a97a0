// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_FUNCTION_VIEW_H
#define HDE_REMESH_FUNCTION_VIEW_H

#include "Soup.h"

#include <functional>
#include <utility>

namespace hde_remesh {

// Any implicit function behind one type, so that what measures it is compiled once for all kernels. A model of
// ImplicitFunctionWithGradient.
class Function_view
{
public:
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;

  Function_view() = default;

  // keeps a copy, which is cheap for the functions of the package
  template <typename Function>
  static Function_view of(const Function& function)
  {
    Function_view view;
    view.m_evaluate = [function](const Point_3& p) { return function.value_and_gradient(p); };
    return view;
  }

  FT operator()(const Point_3& p) const { return m_evaluate(p).first; }
  Vector_3 gradient(const Point_3& p) const { return m_evaluate(p).second; }
  std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const { return m_evaluate(p); }

private:
  std::function<std::pair<FT, Vector_3>(const Point_3&)> m_evaluate;
};

} // namespace hde_remesh

#endif // HDE_REMESH_FUNCTION_VIEW_H
