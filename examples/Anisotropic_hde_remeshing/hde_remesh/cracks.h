// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// Cracks: pairs of boundary edges that would be one, had their points not been rounded, or written, differently.

#ifndef HDE_REMESH_CRACKS_H
#define HDE_REMESH_CRACKS_H

#include "Soup.h"

#include <cstddef>
#include <optional>

namespace hde_remesh {

// which edges may be one
enum class Orientation
{
  OPPOSITE, // as in a mesh whose faces are oriented alike
  ANY       // as in one that is oriented later
};

// Makes points one that are no further apart than `tolerance`, where this makes one of two boundary edges. Nothing becomes worse: no
// face loses a corner, no edge gets more than two faces, and no sheets meet in a point that did not. The first of the points stays.
// Returns how many are gone.
std::size_t close_cracks(Soup& soup, double tolerance, Orientation orientation);

// How wide cracks are, if there are some, none wider than `tolerance`, and the mesh is closed but for them.
std::optional<double> width_of_cracks(const Soup& soup, double tolerance);

} // namespace hde_remesh

#endif // HDE_REMESH_CRACKS_H
