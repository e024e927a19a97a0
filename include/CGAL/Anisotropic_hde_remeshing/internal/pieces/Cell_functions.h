// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_FUNCTIONS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_FUNCTIONS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_function.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Cell_input.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/pieces/Mesh_of_piece.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Builds the functions of cells, and keeps those that were used last within a bound of memory. They are fixed by the input alone:
// it does not matter when they are built, nor how often.
template <typename ConcurrencyTag, typename FunctionParameters>
class Cell_functions
{
public:
  typedef Cell_function<ConcurrencyTag> Function;
  typedef typename Function::Function_of_cell Function_of_cell;

  Cell_functions(const Cell_tree& tree, const Input_of_cells& input, const FunctionParameters& np,
                 const std::size_t memory_bytes)
    : m_tree(tree), m_input(input), m_np(np), m_memory_bytes(memory_bytes)
  {
  }

  // the function in and near the boxes
  Function near(const std::vector<Space_box>& boxes)
  {
    std::vector<char> is_needed(m_tree.number_of_cells(), 0);
    for (const Space_box& box : boxes)
      m_tree.visit_cells(box, [&](const std::size_t cell) { is_needed[cell] = 1; });
    std::vector<std::shared_ptr<const Function_of_cell>> functions(m_tree.number_of_cells());
    for (std::size_t cell = 0; cell < functions.size(); ++cell)
      if (is_needed[cell])
        functions[cell] = function_of(cell);
    forget_oldest();
    return Function(m_tree, std::move(functions));
  }

  std::size_t number_of_built() const { return m_number_of_built; }
  double seconds() const { return m_timer.time(); }

private:
  struct Kept
  {
    std::shared_ptr<const Function_of_cell> function;
    std::uint64_t last_use;
  };

  std::shared_ptr<const Function_of_cell> function_of(const std::size_t cell)
  {
    Kept& kept = m_kept[cell];
    kept.last_use = ++m_uses;
    if (!kept.function)
    {
      m_timer.start();
      Mesh_of_piece region(m_input(cell, cell + 1).faces);
      kept.function = std::make_shared<const Function_of_cell>(region.mesh(), m_np);
      ++m_number_of_built;
      m_timer.stop();
    }
    return kept.function;
  }

  // those of the region at hand stay in memory as long as it uses them
  void forget_oldest()
  {
    std::size_t bytes = 0;
    std::map<std::uint64_t, std::size_t> by_use;
    for (const auto& cell : m_kept)
    {
      bytes += cell.second.function->diagnostics().memory_bytes;
      by_use[cell.second.last_use] = cell.first;
    }
    for (const auto& oldest : by_use)
    {
      if (bytes <= m_memory_bytes)
        break;
      bytes -= m_kept[oldest.second].function->diagnostics().memory_bytes;
      m_kept.erase(oldest.second);
    }
  }

  const Cell_tree& m_tree;
  const Input_of_cells& m_input;
  const FunctionParameters m_np;
  const std::size_t m_memory_bytes;
  std::map<std::size_t, Kept> m_kept;
  std::uint64_t m_uses = 0;
  std::size_t m_number_of_built = 0;
  Real_timer m_timer;
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PIECES_CELL_FUNCTIONS_H
