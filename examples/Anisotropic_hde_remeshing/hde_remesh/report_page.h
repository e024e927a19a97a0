// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_REPORT_PAGE_H
#define HDE_REMESH_REPORT_PAGE_H

#include "Page_figures.h"
#include "Report.h"

#include <string>

namespace hde_remesh {

// A page of HTML that needs no other file and no network: the table, histograms, and both meshes to be turned and looked into.
std::string report_page(const Report& report, const std::string& command_line, const Measured_elements& before,
                        const Measured_elements& after);

} // namespace hde_remesh

#endif // HDE_REMESH_REPORT_PAGE_H
