// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_LICENSE_ANISOTROPIC_HDE_REMESHING_H
#define CGAL_LICENSE_ANISOTROPIC_HDE_REMESHING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

// Unlike CGAL's own packages, this one has no commercial license: the macros only tell under which terms it is used.

#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("\nYou use the package Anisotropic_hde_remeshing under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#  error "You use the package Anisotropic_hde_remeshing under the terms of the GPLv3+. \
You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_ANISOTROPIC_HDE_REMESHING_H
