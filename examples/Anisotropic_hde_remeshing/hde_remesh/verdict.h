// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_VERDICT_H
#define HDE_REMESH_VERDICT_H

#include "Report.h"

#include <string>
#include <vector>

namespace hde_remesh {

// a line of the verdict: a few words, and what is to be said of them
struct Verdict_line
{
  std::string name, text;
};

// What came out: the first thing to read on the terminal, and on the page of --report in the same words. Lengths are in D. The warnings
// are the last lines, one at least.
std::vector<Verdict_line> verdict(const Report& report);

} // namespace hde_remesh

#endif // HDE_REMESH_VERDICT_H
