// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_VTP_FILE_H
#define HDE_REMESH_VTP_FILE_H

#include "Soup.h"

#include <iosfwd>

namespace hde_remesh {

// VTK's XML format of polygons, with the arrays; ParaView reads it. Doubles are read back as they were.
void write_vtp(const Soup& soup, std::ostream& stream);

} // namespace hde_remesh

#endif // HDE_REMESH_VTP_FILE_H
