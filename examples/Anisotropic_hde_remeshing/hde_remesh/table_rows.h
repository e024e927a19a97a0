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

#include <string>
#include <vector>

namespace hde_remesh {

// a row of the table, "-" where a mesh has no such figure
struct Table_row
{
  std::string name, before, after;
};

// The table of both meshes: the terminal and the page of --report show the same. All lengths are in D.
std::vector<Table_row> table_rows(const Report& report);

} // namespace hde_remesh

#endif // HDE_REMESH_TABLE_ROWS_H
