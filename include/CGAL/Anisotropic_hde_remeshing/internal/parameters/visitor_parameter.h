// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_VISITOR_PARAMETER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_VISITOR_PARAMETER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Remeshing_visitor.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// The type of the caller's visitor: a reference if it is given by std::ref(), otherwise CGAL's copy of it. Without one it is a
// reference to the one that does nothing.
template <typename NamedParameters>
using Visitor_parameter =
    typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Remeshing_visitor>::reference;

// `nobody` hears if no visitor is given
template <typename NamedParameters>
Visitor_parameter<NamedParameters> visitor_parameter(const NamedParameters& np, Remeshing_visitor& nobody)
{
  return parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor), nobody);
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_VISITOR_PARAMETER_H
