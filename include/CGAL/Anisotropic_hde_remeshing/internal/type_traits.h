// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_TYPE_TRAITS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_TYPE_TRAITS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// Tells ranges, of points or of faces, from meshes, by their iterator: boost::graph_traits of a type that is no graph is a hard
// error.
template <typename T, typename = void>
struct Is_range : std::false_type
{
};
template <typename T>
struct Is_range<T, std::void_t<typename T::const_iterator>> : std::true_type
{
};

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_TYPE_TRAITS_H
