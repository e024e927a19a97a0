// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef HDE_REMESH_BUILD_FUNCTION_WITH_H
#define HDE_REMESH_BUILD_FUNCTION_WITH_H

#include "Named_kernel.h"
#include "build_function.h"

#include <CGAL/Piecewise_rbf_implicit_function.h>
#include <CGAL/Radial_basis_functions.h>
#include <CGAL/Rbf_implicit_function.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace hde_remesh {

namespace params = CGAL::Anisotropic_hde_remeshing::parameters;

template <typename RadialFunction>
RadialFunction radial_function(const Options& o)
{
  if constexpr (std::is_constructible_v<RadialFunction, double>)
    return o.shape ? RadialFunction(*o.shape) : RadialFunction();
  else
    return RadialFunction();
}

// Whether nothing is asked of the function. Then long and exact facets are the surface. The scheme of the paper has its function.
inline bool leaves_function_open(const Options& o) { return o.scheme != "paper" && !is_function_asked_for(o); }

template <typename RadialFunction, typename NamedParameters>
Built_function build_with_parameters(const Mesh& mesh, const Options& o, const NamedParameters& np)
{
  Built_function result;
  result.kernel = RadialFunction::name();
  namespace Hde_internal = CGAL::Anisotropic_hde_remeshing::internal;
  const bool has_long_facets = Hde_internal::has_long_facets(faces(mesh), mesh, mesh.points());
  if (o.sharp || (has_long_facets && leaves_function_open(o)))
  {
    const CGAL::Piecewise_rbf_implicit_function<Kernel, RadialFunction, CGAL::Parallel_if_available_tag> function(
        mesh, creases_of(mesh).region, Hde_internal::keep_long_facets(np, has_long_facets));
    result.function = Function_view::of_pieces(function);
    result.pieces = function.diagnostics();
  }
  else
  {
    const CGAL::Rbf_implicit_function<Kernel, RadialFunction, CGAL::Parallel_if_available_tag> function(mesh, np);
    result.function = Function_view::of(function);
    result.rbf = function.diagnostics();
  }
  return result;
}

template <typename RadialFunction>
Built_function build_with(const Mesh& mesh, const Options& o, Progress& progress)
{
  // what the library has where nothing is given
  const CGAL::Anisotropic_hde_remeshing::internal::Interpolation_parameters defaults;
  const auto np = params::vertex_point_map(mesh.points())
                      .radial_function(radial_function<RadialFunction>(o))
                      .patch_overlap(o.overlap.value_or(defaults.patch_overlap))
                      .smoothing(o.automatic_smoothing ? CGAL::Anisotropic_hde_remeshing::AUTOMATIC_SMOOTHING
                                                       : CGAL::Anisotropic_hde_remeshing::Smoothing(o.smoothing.value_or(0)))
                      .points_on_facets(!o.vertices_only)
                      .detect_edges(!o.smooth_edges)
                      .close_holes(false) // remeshing does not leave the input
                      .visitor(Progress_visitor(progress));
  // how many points there will be, and with them patches, is not known here
  const auto with_patches = [&](const auto& others)
  {
    return o.patches
               ? build_with_parameters<RadialFunction>(mesh, o, others.number_of_patches(static_cast<std::size_t>(*o.patches)))
               : build_with_parameters<RadialFunction>(mesh, o, others);
  };
  return o.offset ? with_patches(np.offset_distance(*o.offset)) : with_patches(np);
}

template <typename RadialFunction>
Named_kernel named_kernel(const char* name)
{
  return {name, std::is_constructible_v<RadialFunction, double>, &build_with<RadialFunction>};
}

} // namespace hde_remesh

#endif // HDE_REMESH_BUILD_FUNCTION_WITH_H
