// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers
#include "build_function.h"
#include "Named_kernel.h"
#include "kernels.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace hde_remesh {

namespace {

std::vector<Named_kernel> all_kernels()
{
  std::vector<Named_kernel> result = global_kernels();
  for (const Named_kernel& kernel : compact_kernels())
    result.push_back(kernel);
  return result;
}

Named_kernel kernel_of(const std::string& name)
{
  for (const Named_kernel& kernel : all_kernels())
    if (kernel.name == name)
      return kernel;
  throw std::logic_error("no kernel has the name " + name);
}

} // namespace

std::vector<std::string> names_of_kernels()
{
  std::vector<std::string> result;
  for (const Named_kernel& kernel : all_kernels())
    result.push_back(kernel.name);
  return result;
}

bool has_shape(const std::string& kernel) { return kernel_of(kernel).has_shape; }

Built_function build_function(const Mesh& mesh, const Options& options, Progress& progress)
{
  return kernel_of(options.kernel).build(mesh, options, progress);
}

} // namespace hde_remesh
