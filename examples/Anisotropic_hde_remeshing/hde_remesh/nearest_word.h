// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_NEAREST_WORD_H
#define HDE_REMESH_NEAREST_WORD_H

#include <string>
#include <vector>

namespace hde_remesh {

// The number of letters that are to be inserted, left out, replaced, or exchanged with the next one, so that one word becomes the
// other.
std::size_t edit_distance(const std::string& first, const std::string& second);

// The word that was meant: the only one that begins so, or the nearest one, if no more than a third of its letters differ. Else empty.
std::string nearest_word(const std::string& word, const std::vector<std::string>& words);

} // namespace hde_remesh

#endif // HDE_REMESH_NEAREST_WORD_H
