// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_BUILD_FUNCTION_WITH_H
#define HDE_REMESH_BUILD_FUNCTION_WITH_H

#include "build_function.h"

#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Rbf_implicit_function.h>

#include <cstddef>
#include <type_traits>

namespace hde_remesh {

// The kernel is a type, and each is compiled by itself: in two files, so that none takes long.
Built_function build_with_global_kernel(const Mesh& mesh, const Options& options);
Built_function build_with_compact_kernel(const Mesh& mesh, const Options& options);

template <typename RadialFunction>
RadialFunction radial_function(const Options& o)
{
  if constexpr (std::is_constructible_v<RadialFunction, double>)
    return o.shape ? RadialFunction(*o.shape) : RadialFunction();
  else
    return RadialFunction();
}

template <typename RadialFunction>
Built_function build_with(const Mesh& mesh, const Options& o)
{
  typedef CGAL::Rbf_implicit_function<Kernel, RadialFunction> Function;
  // what the library has where nothing is given
  const CGAL::Anisotropic_hde_remeshing::internal::Interpolation_parameters defaults;
  const auto np =
      CGAL::parameters::vertex_point_map(mesh.points())
          .radial_function(radial_function<RadialFunction>(o))
          .number_of_patches(o.patches ? static_cast<std::size_t>(*o.patches) : defaults.patches_of(mesh.number_of_vertices()))
          .patch_overlap(o.overlap.value_or(defaults.patch_overlap))
          .smoothing(o.smoothing.value_or(defaults.smoothing));
  const Function function = o.offset ? Function(mesh, np.offset_distance(*o.offset)) : Function(mesh, np);
  return Built_function{Function_view::of(function), RadialFunction::name(), function.diagnostics()};
}

} // namespace hde_remesh

#endif // HDE_REMESH_BUILD_FUNCTION_WITH_H
