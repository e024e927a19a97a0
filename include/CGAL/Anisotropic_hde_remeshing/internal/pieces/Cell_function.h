// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_FUNCTION_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_FUNCTION_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_tree.h>
#include <CGAL/Rbf_implicit_function.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The functions of the cells, blended to one that is twice continuously differentiable. It has the same bits at a place whoever asks,
// as long as the cells that count there are loaded. A model of `ImplicitFunctionWithGradient`. Where a cell is not loaded the value
// is not finite, and the remesher takes the input instead.
template <typename ConcurrencyTag>
class Cell_function
{
  typedef Simple_cartesian<double> Kernel;

public:
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Point_3 Point;
  typedef Kernel::Vector_3 Vector_3;
  typedef Rbf_implicit_function<Kernel, Polyharmonic_rbf, ConcurrencyTag> Function_of_cell;

  // `functions` has one for each cell of the tree, or none where it is not needed. The tree must live as long as this.
  Cell_function(const Cell_tree& tree, std::vector<std::shared_ptr<const Function_of_cell>> functions)
    : m_tree(&tree), m_functions(std::move(functions))
  {
  }

  FT operator()(const Point_3& p) const { return evaluate<1>(to_vector(p)).value; }
  Vector_3 gradient(const Point_3& p) const { return to_vector_3(evaluate<1>(to_vector(p)).gradient); }

  std::pair<FT, Vector_3> value_and_gradient(const Point_3& p) const
  {
    const Jet<1> jet = evaluate<1>(to_vector(p));
    return {jet.value, to_vector_3(jet.gradient)};
  }

  Matrix hessian(const Point_3& p) const { return evaluate<2>(to_vector(p)).hessian; }

private:
  template <int order>
  Jet<order> evaluate(const Vector& p) const
  {
    return m_tree->blend(p, [&](const std::size_t cell) { return jet_of_cell<order>(cell, p); });
  }

  template <int order>
  Jet<order> jet_of_cell(const std::size_t cell, const Vector& p) const
  {
    Jet<order> result;
    const Point_3 point(p.x(), p.y(), p.z());
    if (!m_functions[cell])
      result.value = std::numeric_limits<double>::quiet_NaN();
    else
    {
      const auto both = m_functions[cell]->value_and_gradient(point);
      result.value = both.first;
      result.gradient = to_vector(both.second);
      if constexpr (order >= 2)
        result.hessian = m_functions[cell]->hessian(point);
    }
    return result;
  }

  static Vector_3 to_vector_3(const Vector& v) { return Vector_3(v.x(), v.y(), v.z()); }

  const Cell_tree* m_tree;
  std::vector<std::shared_ptr<const Function_of_cell>> m_functions;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_FUNCTION_H
