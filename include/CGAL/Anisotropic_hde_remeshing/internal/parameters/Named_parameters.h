// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

// The tags of the named parameters. CGAL's are found here, too. If CGAL has a tag of the same name, the package's hides it.
namespace internal_np {

using namespace CGAL::internal_np;

#define CGAL_AHR_NAMED_PARAMETER(NAME, CONDITION, WORDS) enum NAME##_t{NAME};
#define CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, TAG, CONDITION, WORDS)
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameter_table.h>

} // namespace internal_np

namespace internal {

template <typename T, typename Tag, typename Base>
std::true_type named_parameters_test(const Named_function_parameters<T, Tag, Base>*);
std::false_type named_parameters_test(...);

// whether a type is one of named parameters, CGAL's or the package's
template <typename T>
constexpr bool is_named_parameters = decltype(named_parameters_test(std::declval<T*>()))::value;

template <typename T, typename Tag, typename Base>
struct Named_parameters;

// the same parameters, to be continued with names of the package
template <typename T, typename Tag, typename Base>
Named_parameters<T, Tag, Base> named_parameters(const Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}

// CGAL's named parameters with a function for each name of the package. CGAL's own names that the package reads have functions
// here, too: those of CGAL return a class without the package's names. The values are kept as CGAL keeps them. So this class has
// no data, and CGAL's get_parameter() reads it.
template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Named_parameters : Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base> Of_cgal;

  Named_parameters(const Of_cgal& np) : Of_cgal(np) {}

#define CGAL_AHR_NAMED_PARAMETER(NAME, CONDITION, WORDS)                                                                       \
  template <typename K>                                                                                                        \
  Named_parameters<K, internal_np::NAME##_t, Of_cgal> NAME(const K& k) const                                                   \
  {                                                                                                                            \
    return Named_function_parameters<K, internal_np::NAME##_t, Of_cgal>(k, *this);                                             \
  }
#define CGAL_AHR_NAMED_PARAMETER_OF_CGAL(NAME, TAG, CONDITION, WORDS)                                                          \
  template <typename K>                                                                                                        \
  auto NAME(const K& k) const                                                                                                  \
  {                                                                                                                            \
    return named_parameters(Of_cgal::NAME(k));                                                                                 \
  }
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/named_parameter_table.h>
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
