// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_FOREIGN_FILE_H
#define HDE_REMESH_FOREIGN_FILE_H

#include "Format.h"
#include "Text_reader.h"

#include <string>

namespace hde_remesh {

// Why a file of this format cannot be read: that it is empty, another kind of file, of no such kind, or cut off; else what the reader
// says.
std::string reason_of(const Unreadable& error, const std::string& text, Format format);

} // namespace hde_remesh

#endif // HDE_REMESH_FOREIGN_FILE_H
