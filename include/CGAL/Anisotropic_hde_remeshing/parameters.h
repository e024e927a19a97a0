// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/Named_parameters.h>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

// Each name in internal/parameters/named_parameter_table.h has a function here.
namespace parameters {

/*!
\ingroup PkgAnisotropicHdeRemeshingParameters

begins with parameters of \cgal: `begin_with(points.parameters()).number_of_patches(500)`. A sequence of \cgal's own functions
cannot be continued with names of this package otherwise.

\return the same parameters, which can be continued with all names of this package
*/
#ifdef DOXYGEN_RUNNING
template <typename NamedParameters>
unspecified_type begin_with(const NamedParameters& np)
#else
template <typename T, typename Tag, typename Base>
internal::Named_parameters<T, Tag, Base> begin_with(const Named_function_parameters<T, Tag, Base>& np)
#endif
{
  return internal::named_parameters(np);
}

typedef internal::Named_parameters<bool, internal_np::all_default_t> Default_named_parameters;

/*!
\ingroup PkgAnisotropicHdeRemeshingParameters

\brief begins without a parameter: all have their defaults. The sequence can be continued with all names of this package.
*/
inline Default_named_parameters default_values() { return CGAL::parameters::default_values(); }

#ifndef DOXYGEN_RUNNING // each function of the package documents the names that it reads

#  define CGAL_AHR_NAMED_PARAMETER(NAME, CONDITION, WORDS)                                                                     \
    template <typename K>                                                                                                      \
    internal::Named_parameters<K, internal_np::NAME##_t> NAME(const K& k)                                                      \
    {                                                                                                                          \
      return Named_function_parameters<K, internal_np::NAME##_t>(k);                                                           \
    }
#  define CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, TAG, CONDITION, WORDS)                                                        \
    template <typename K>                                                                                                      \
    auto NAME(const K& k)                                                                                                      \
    {                                                                                                                          \
      return internal::named_parameters(CGAL::parameters::NAME(k));                                                            \
    }
#  include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameter_table.h>

// what reads parameters is CGAL's
using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;
using CGAL::parameters::get_parameter_reference;
using CGAL::parameters::is_default_parameter;

#endif

} // namespace parameters
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_PARAMETERS_H
