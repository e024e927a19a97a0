// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// The creases of a mesh, and the regions between them.

#include "creases.h"

#include <CGAL/Anisotropic_hde_remeshing/Surface_regions.h>

namespace hde_remesh {

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

void find_creases(Mesh& mesh, const Options& options)
{
  const Creases creases = add_creases(mesh);
  if (options.sharp)
    CGAL::Anisotropic_hde_remeshing::detect_surface_regions(mesh, creases.is_crease, creases.region,
                                                            params::sharp_angle(*options.sharp));
}

} // namespace hde_remesh
