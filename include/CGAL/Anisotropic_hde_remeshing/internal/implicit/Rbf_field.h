// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_FIELD_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_FIELD_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/Rbf_diagnostics.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/Jet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Vector.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Surface_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/interpolation_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/Interruption.h>
#include <CGAL/Radial_basis_functions.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

template <typename RadialFunction, typename ConcurrencyTag>
class Patchwise_interpolant;
template <typename Interpolant>
class Unbounded_interpolant;

// The function of `Rbf_implicit_function` in plain numbers, whatever mesh or points it is of: the patchwise interpolant, closed where
// data are missing, and what the construction tells. Of the caller's types it has the radial function only. The
// members are in Rbf_field_impl.h, which is not needed where they are compiled already.
template <typename RadialFunction, typename ConcurrencyTag>
class Rbf_field
{
#if defined(CGAL_AHR_WITH_SHARED_INSTANTIATIONS) && !defined(CGAL_AHR_WITH_OTHER_TYPES)
  static_assert(std::is_same<RadialFunction, Polyharmonic_rbf>::value,
                "with shared instantiations, kernels other than Polyharmonic_rbf need CGAL_AHR_WITH_OTHER_TYPES");
#endif
  typedef Patchwise_interpolant<RadialFunction, ConcurrencyTag> Interpolant;

public:
  // `timer` has run since the input was read. Throws Interrupted, and std::invalid_argument if no function can be built.
  Rbf_field(Surface_sample sample, Interpolation_parameters parameters, const RadialFunction& function, const Real_timer& timer,
            Interruption& interruption);
  ~Rbf_field();
  Rbf_field(const Rbf_field&) = delete;
  Rbf_field& operator=(const Rbf_field&) = delete;

  // at a point in the unit of the coordinates; the value and derivatives are in that of the sample
  template <int order>
  Jet<order> evaluate(const Vector& point) const;

  // the distance to the nearest point that was given, in the unit of the coordinates
  double distance_to_data(const Vector& point) const;

  // the number of the patch in whose cell the point is
  std::size_t patch(const Vector& point) const;

  // the unit of the coordinates in that of the sample
  double scale() const { return m_normalization.scale; }

  // of a sphere that contains the zero set
  const Vector& centre() const { return m_normalization.centre; }
  double radius() const;

  const Rbf_diagnostics& diagnostics() const { return m_diagnostics; }

private:
  void complete_diagnostics(const Surface_sample& sample, double noise, double input_seconds);

  std::unique_ptr<const Unbounded_interpolant<Interpolant>> m_interpolant;
  Rbf_diagnostics m_diagnostics;
  Normalization m_normalization;
};

template <typename RadialFunction, typename ConcurrencyTag>
Value_and_gradient value_and_gradient_of(const Rbf_field<RadialFunction, ConcurrencyTag>& field, const Vector& point)
{
  Value_and_gradient result = field.template evaluate<1>(point);
  result.value /= field.scale();
  return result;
}

#ifdef CGAL_AHR_WITH_SHARED_INSTANTIATIONS // cmake/Shared_compilation.cmake: compiled once for the package's own programs
#  define CGAL_AHR_FIELD(EXTERN, RadialFunction, ConcurrencyTag)                                                               \
    EXTERN template class Rbf_field<RadialFunction, ConcurrencyTag>;                                                           \
    EXTERN template Jet<0> Rbf_field<RadialFunction, ConcurrencyTag>::evaluate<0>(const Vector&) const;                        \
    EXTERN template Jet<1> Rbf_field<RadialFunction, ConcurrencyTag>::evaluate<1>(const Vector&) const;                        \
    EXTERN template Jet<2> Rbf_field<RadialFunction, ConcurrencyTag>::evaluate<2>(const Vector&) const
CGAL_AHR_FIELD(extern, Polyharmonic_rbf, Sequential_tag);
#  ifdef CGAL_LINKED_WITH_TBB
CGAL_AHR_FIELD(extern, Polyharmonic_rbf, Parallel_tag);
#  endif
#endif

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#if !defined(CGAL_AHR_WITH_SHARED_INSTANTIATIONS) || defined(CGAL_AHR_WITH_OTHER_TYPES)
#  include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field_impl.h>
#endif

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_FIELD_H
