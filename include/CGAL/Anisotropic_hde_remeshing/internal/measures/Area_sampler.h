// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_AREA_SAMPLER_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_AREA_SAMPLER_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parameters/check_parameters.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {
namespace internal {

// `number_of_points_on_faces`
template <typename NamedParameters>
std::size_t number_of_samples_parameter(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::number_of_points_on_faces_t>::value)
    return 200000;
  else
    return checked_count("number_of_points_on_faces", parameters::get_parameter(np, internal_np::number_of_points_on_faces));
}

// The i-th of n points spread evenly over the area of a mesh. There are no random numbers: the points are the same on every
// machine, and any thread can ask for any of them.
class Area_sampler
{
public:
  Area_sampler(const Measured_mesh& mesh, const std::size_t number_of_samples)
    : m_mesh(mesh), m_number_of_samples(mesh.faces.empty() ? 0 : number_of_samples)
  {
    double area = 0;
    m_areas_up_to.reserve(mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      m_areas_up_to.push_back(area += mesh.normal(f).norm());
  }

  std::size_t size() const { return m_number_of_samples; }

  Vector operator()(const std::size_t i) const
  {
    // The points are stratified over the area. Inside the faces they are a two-dimensional Kronecker sequence. Its steps are
    // the powers of the root of x^3 = x + 1, which spread the points best.
    const double step_u = 0.75487766624669276, step_v = 0.56984029099805327;
    double integer_part;
    double u = std::modf(0.5 + static_cast<double>(i) * step_u, &integer_part);
    double v = std::modf(0.5 + static_cast<double>(i) * step_v, &integer_part);
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    const std::array<std::size_t, 3>& vertices = m_mesh.faces[face(i)];
    const Vector& origin = m_mesh.points[vertices[0]];
    return origin + u * (m_mesh.points[vertices[1]] - origin) + v * (m_mesh.points[vertices[2]] - origin);
  }

  // the face on which the point lies
  std::size_t face(const std::size_t i) const
  {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(m_number_of_samples);
    if (!(m_areas_up_to.back() > 0)) // all faces degenerate: one after the other
      return static_cast<std::size_t>(share * static_cast<double>(m_areas_up_to.size()));
    const auto found = std::upper_bound(m_areas_up_to.begin(), m_areas_up_to.end(), share * m_areas_up_to.back());
    return (std::min)(static_cast<std::size_t>(found - m_areas_up_to.begin()), m_areas_up_to.size() - 1);
  }

private:
  const Measured_mesh& m_mesh;
  std::size_t m_number_of_samples;
  std::vector<double> m_areas_up_to;
};

struct Rms_and_max
{
  double rms = 0;
  double max = 0;
};

// of `distance(i)` for i in [0, n). The distances are computed in parallel and added in order, so the sum does not depend on
// the threads.
template <typename ConcurrencyTag, typename Distance>
Rms_and_max rms_and_max(const std::size_t n, const Distance& distance)
{
  std::vector<double> distances(n);
  parallel_for<ConcurrencyTag>(n, [&](const std::size_t i) { distances[i] = distance(i); });
  Rms_and_max result;
  for (const double d : distances)
    if (!(d <= result.max) && !std::isnan(result.max)) // std::max would lose a distance that is no number
      result.max = d;
  if (result.max == 0 || !std::isfinite(result.max))
  {
    result.rms = result.max;
    return result;
  }
  double sum = 0; // of squares relative to the largest, so that no unit of length makes them vanish
  for (const double d : distances)
    sum += (d / result.max) * (d / result.max);
  result.rms = result.max * std::sqrt(sum / static_cast<double>(n));
  return result;
}

} // namespace internal
} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_INTERNAL_MEASURES_AREA_SAMPLER_H
