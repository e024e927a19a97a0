// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_TABLE_ROWS_H
#define HDE_REMESH_TABLE_ROWS_H

#include "Report.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hde_remesh {

// a row of the table, "-" where a mesh has no such figure
struct Table_row
{
  std::string name, before, after;
  int rank = 0; // 1 is the most important one, 0 is one for --details only
};

// The table of both meshes: the terminal and the page of --report show the same. All lengths are in D.
std::vector<Table_row> table_rows(const Report& report);

// at most `number` rows of these: the most important ones, in their order
std::vector<Table_row> most_important_rows(const std::vector<Table_row>& rows, std::size_t number);

} // namespace hde_remesh

#endif // HDE_REMESH_TABLE_ROWS_H
