// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
#ifndef HDE_REMESH_NAMED_KERNEL_H
#define HDE_REMESH_NAMED_KERNEL_H

#include "build_function.h"

#include <vector>

namespace hde_remesh {

struct Named_kernel
{
  const char* name;
  bool has_shape;
  Built_function (*build)(const Mesh& mesh, const Options& options, Progress& progress);
};

// A kernel is a type, and the function of each is compiled by itself: in two files, so that none takes long.
std::vector<Named_kernel> global_kernels();
std::vector<Named_kernel> compact_kernels();

} // namespace hde_remesh

#endif // HDE_REMESH_NAMED_KERNEL_H
