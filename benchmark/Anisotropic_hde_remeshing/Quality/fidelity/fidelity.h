// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// How far a surface of triangles and the zero set of a function are apart, by true distances in both senses.

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FIDELITY_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FIDELITY_H

#include "shapes.h"

#include <CGAL/Anisotropic_hde_remeshing/internal/functions/evaluation.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/functions/pieces.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/geometry/Closest_facet.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Area_sampler.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Zero_set_distance.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace fidelity {

using namespace CGAL::Anisotropic_hde_remeshing::internal;
typedef CGAL::Parallel_if_available_tag Tag;

struct Summary
{
  double rms = 0, of_999 = 0, max = 0; // root mean square, 99.9%, largest
  double share_of_worst = 0;           // of the worst 1% in the sum of squares
  std::size_t lost = 0;                // points from which no way leads to the zero set; they do not count above
};

inline Summary summarise(std::vector<double> distances)
{
  Summary result;
  const auto end = std::partition(distances.begin(), distances.end(), [](const double d) { return std::isfinite(d); });
  result.lost = std::size_t(distances.end() - end);
  distances.erase(end, distances.end());
  if (distances.empty())
    return result;
  std::sort(distances.begin(), distances.end());
  double sum = 0, sum_of_worst = 0;
  for (std::size_t k = 0; k < distances.size(); ++k)
  {
    sum += distances[k] * distances[k];
    if (k >= distances.size() - distances.size() / 100)
      sum_of_worst += distances[k] * distances[k];
  }
  result.rms = std::sqrt(sum / double(distances.size()));
  result.of_999 = distances[std::size_t(0.999 * double(distances.size()))];
  result.max = distances.back();
  result.share_of_worst = sum > 0 ? sum_of_worst / sum : 0;
  return result;
}

// Points of a mesh spread evenly over its area, and the points of the zero set to which the gradient leads from them.
class Walked_samples
{
public:
  template <typename Function, typename NamedParameters>
  Walked_samples(const shapes::Mesh& mesh, const Function& f, const std::size_t n, const NamedParameters& np)
  {
    const Measured_mesh measured = read_measured_mesh_of(f, mesh, np);
    const Area_sampler sampler(measured, n);
    points.resize(sampler.size());
    feet.resize(sampler.size());
    distances.resize(sampler.size());
    size = measured.diagonal();
    parallel_for<Tag>(sampler.size(),
                      [&](const std::size_t i)
                      {
                        const auto& function = piece(f, measured.face_regions[sampler.face(i)]);
                        points[i] = sampler(i);
                        distances[i] = zero_set_distance(function, size)(points[i]);
                        feet[i] = foot(function, points[i]);
                      });
  }

  std::vector<Vector> points, feet; // a foot is not finite where none is found
  std::vector<double> distances;    // from the points to the zero set, infinite likewise
  double size = 0;

private:
  template <typename Function>
  Vector foot(const Function& f, Vector q) const
  {
    for (int step = 0; step < 30; ++step)
    {
      const Value_and_gradient at_q = value_and_gradient_of(f, q);
      const double squared_slope = at_q.gradient.squaredNorm();
      if (!(squared_slope > 0) || !std::isfinite(at_q.value))
        break;
      Vector way = at_q.value / squared_slope * at_q.gradient;
      const double length = way.norm(), longest = 0.05 * size;
      q -= length > longest ? Vector(longest / length * way) : way;
      if (length < 1e-9 * size)
        return q;
    }
    return Vector::Constant((std::numeric_limits<double>::infinity)());
  }
};

// the distances of points to the facets of a mesh
class Distance_to_mesh
{
public:
  explicit Distance_to_mesh(const shapes::Mesh& mesh)
    : m_mesh(read_measured_mesh(mesh, CGAL::parameters::default_values())), m_closest(m_mesh.points, m_mesh.faces)
  {
  }

  std::vector<double> operator()(const std::vector<Vector>& points) const
  {
    std::vector<double> result(points.size());
    parallel_for<Tag>(points.size(),
                      [&](const std::size_t i)
                      {
                        result[i] = points[i].allFinite() ? (m_closest(points[i]).point - points[i]).norm()
                                                          : (std::numeric_limits<double>::infinity)();
                      });
    return result;
  }

private:
  const Measured_mesh m_mesh;
  const Closest_facet m_closest;
};

} // namespace fidelity

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_BENCHMARK_FIDELITY_H
