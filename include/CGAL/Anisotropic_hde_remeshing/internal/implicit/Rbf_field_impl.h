// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_FIELD_IMPL_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_FIELD_IMPL_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Facet_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Patchwise_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Point_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Rbf_field.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Signed_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/Unbounded_interpolant.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/complete_sample.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/implicit/shares_of_construction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// the signed distance to the input
inline std::shared_ptr<const Signed_distance> distance_to_input(const std::shared_ptr<const Surface_sample>& sample)
{
  if (sample->is_of_points)
    return std::make_shared<const Point_distance>(sample);
  return std::make_shared<const Facet_distance>(sample);
}

template <typename RadialFunction, typename ConcurrencyTag>
Rbf_field<RadialFunction, ConcurrencyTag>::Rbf_field(Surface_sample sample, Interpolation_parameters parameters,
                                                     const RadialFunction& function, const Real_timer& timer,
                                                     Interruption& interruption)
{
  complete_sample<ConcurrencyTag>(sample, parameters, interruption);
  interruption.report(share_of_sample);
  m_normalization = sample.normalization;
  const double input_seconds = timer.time();
  const auto shared_sample = std::make_shared<const Surface_sample>(std::move(sample));
  auto interpolant = std::make_unique<Unbounded_interpolant<Interpolant>>(std::make_unique<const Interpolant>(
      shared_sample, distance_to_input(shared_sample), parameters, function, m_normalization.scale, interruption));
  if (parameters.closes_holes)
    interpolant->close_holes(ConcurrencyTag(), interruption);
  m_interpolant = std::move(interpolant);
  m_diagnostics = m_interpolant->interpolant().diagnostics();
  complete_diagnostics(m_interpolant->interpolant().sample(), parameters.noise / m_normalization.scale, input_seconds);
  interruption.report(1);
}

template <typename RadialFunction, typename ConcurrencyTag>
Rbf_field<RadialFunction, ConcurrencyTag>::~Rbf_field() = default;

template <typename RadialFunction, typename ConcurrencyTag>
template <int order>
Jet<order> Rbf_field<RadialFunction, ConcurrencyTag>::evaluate(const Vector& point) const
{
  const Vector normalized = m_normalization(point);
  if (!std::isfinite(normalized.squaredNorm()) && !point.allFinite())
    throw std::invalid_argument("the implicit function is asked for a point whose coordinates are not finite");
  return m_interpolant->template evaluate<order>(normalized);
}

template <typename RadialFunction, typename ConcurrencyTag>
void Rbf_field<RadialFunction, ConcurrencyTag>::complete_diagnostics(const Surface_sample& sample, const double noise,
                                                                     const double input_seconds)
{
  m_diagnostics.noise = noise;
  m_diagnostics.number_of_holes = m_interpolant->number_of_holes();
  m_diagnostics.memory_bytes += m_interpolant->memory_bytes();
  m_diagnostics.median_spacing = median_spacing(sample) / m_normalization.scale;
  m_diagnostics.area = area(sample) / m_normalization.scale / m_normalization.scale;
  m_diagnostics.number_of_points = sample.size();
  m_diagnostics.number_of_points_on_facets = sample.number_of_points_on_facets;
  m_diagnostics.number_of_replaced_vertices = std::size_t(std::count(sample.data.begin(), sample.data.end(), Datum::NONE));
  m_diagnostics.number_of_points_on_edges =
      std::size_t(std::count(sample.is_on_edge.begin(), sample.is_on_edge.end(), char(1)));
  m_diagnostics.number_of_isolated_vertices = sample.number_of_isolated_vertices;
  m_diagnostics.number_of_duplicate_points = sample.number_of_duplicate_points;
  m_diagnostics.number_of_outliers = sample.number_of_outliers;
  m_diagnostics.number_of_wrong_normals = sample.number_of_wrong_normals;
  m_diagnostics.number_of_points_without_normal = std::size_t(
      std::count_if(sample.normals.begin(), sample.normals.end() - std::ptrdiff_t(sample.number_of_points_on_facets),
                    [](const Vector& normal) { return normal.isZero(0); }));
  m_diagnostics.worst_value_residual /= m_normalization.scale;
  m_diagnostics.input_seconds = input_seconds;
}

template <typename RadialFunction, typename ConcurrencyTag>
double Rbf_field<RadialFunction, ConcurrencyTag>::distance_to_data(const Vector& point) const
{
  return m_interpolant->distance_to_data(m_normalization(point)) / m_normalization.scale;
}

template <typename RadialFunction, typename ConcurrencyTag>
std::size_t Rbf_field<RadialFunction, ConcurrencyTag>::patch(const Vector& point) const
{
  return m_interpolant->interpolant().tree().leaf_at(m_normalization(point));
}

template <typename RadialFunction, typename ConcurrencyTag>
double Rbf_field<RadialFunction, ConcurrencyTag>::radius() const
{
  return m_interpolant->radius() / m_normalization.scale;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_IMPLICIT_RBF_FIELD_IMPL_H
