// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

#ifndef CGAL_ANISOTROPIC_HDE_REMESHING_APPROXIMATION_BOUNDS_H
#define CGAL_ANISOTROPIC_HDE_REMESHING_APPROXIMATION_BOUNDS_H

#include <CGAL/license/Anisotropic_hde_remeshing.h>

#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Curvature_by_differences.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/measures/Measured_mesh.h>
#include <CGAL/Anisotropic_hde_remeshing/internal/parallel/parallel.h>
#include <CGAL/Anisotropic_hde_remeshing/parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Anisotropic_hde_remeshing {

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

the least distances to a smooth surface that a triangle mesh can have, asymptotically for many faces. Divide the distances of a
mesh by these bounds to see how far the mesh is from the best one of its size. The quotient is its efficiency, 1 at best.
*/
struct Approximation_bounds
{
  std::size_t number_of_faces = 0; ///< the number to which the other members refer
  double rms_on_surface = 0;       ///< root mean square, with the vertices on the surface
  double rms_off_surface = 0;      ///< the same with the vertices wherever it is best
  double max_on_surface = 0;       ///< largest, with the vertices on the surface
  double max_off_surface = 0;      ///< the same with the vertices wherever it is best

  /// the same bounds for another number of faces: they are inversely proportional to it
  Approximation_bounds for_number_of_faces(const std::size_t n) const
  {
    const double factor = n > 0 ? double(number_of_faces) / double(n) : 0.;
    return Approximation_bounds{n, factor * rms_on_surface, factor * rms_off_surface, factor * max_on_surface,
                                factor * max_off_surface};
  }
};

/*!
\ingroup PkgAnisotropicHdeRemeshingMeasures

integrates the bounds over a mesh near the zero set of `f`, for its number of faces \f$ F \f$. For another number of faces see
`Approximation_bounds::for_number_of_faces()`. \f$ A \f$ is the area and \f$ K \f$ the Gauss curvature (Fejes Toth 1948; Gruber
1993).
- The bound of the root mean square is \f$ (\int (c^2 |K|)^{1/3} dA)^{3/2} / (F \sqrt A) \f$. \f$ c \f$ is \f$ 0.2981 \f$ where
  \f$ K > 0 \f$, or \f$ 0.0745 \f$ there if vertices may leave the surface. It is \f$ 0.1054 \f$ where \f$ K < 0 \f$.
- The bound of the largest distance is \f$ \int g \sqrt{|K|}\, dA / F \f$. \f$ g \f$ is \f$ 2 / (3 \sqrt 3) \f$ where
  \f$ K > 0 \f$, or half of it there if vertices may leave the surface. It is \f$ 1 / (2 \sqrt 5) \f$ where \f$ K < 0 \f$.

Each face counts with the curvature at its centroid.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: how the gradients are computed
\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `FaceListGraph`
\tparam Function a model of `ImplicitFunctionWithGradient`, or of `PiecewiseImplicitFunction`, which needs `face_patch_map`; its
        curvatures are taken from differences of its gradient
\tparam NamedParameters a sequence of named parameters

\param tmesh a triangle mesh
\param f the implicit function
\param np optional named parameters: `vertex_point_map` and `geom_traits`

\throw std::invalid_argument if a face of `tmesh` is not a triangle, or a coordinate is not finite
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Function,
          typename NamedParameters = parameters::Default_named_parameters>
Approximation_bounds approximation_bounds(const TriangleMesh& tmesh, const Function& f,
                                          const NamedParameters& np = parameters::default_values())
{
  if constexpr (!internal::accepts_measurement<TriangleMesh, Function, NamedParameters>())
    return Approximation_bounds();
  else
  {
    static constexpr double relative_step = 1e-3; // of the shortest edge
    static constexpr double elliptic = 0.298142, elliptic_off_surface = 0.0745356, hyperbolic = 0.1054;
    static constexpr double elliptic_max = 0.3849002, hyperbolic_max = 0.2236068;

    const internal::Measured_mesh mesh = internal::read_measured_mesh_of(f, tmesh, np);
    const std::size_t n = mesh.faces.size();
    std::vector<double> areas(n, 0.), gauss_curvatures(n, 0.);
    internal::parallel_for<ConcurrencyTag>(
        n,
        [&](const std::size_t i)
        {
          const internal::Vector &a = mesh.points[mesh.faces[i][0]], &b = mesh.points[mesh.faces[i][1]],
                                 &c = mesh.points[mesh.faces[i][2]];
          areas[i] = 0.5 * mesh.normal(i).norm();
          if (mesh.is_degenerate[i])
            return;
          const double step =
              relative_step * std::sqrt((std::min)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
          const internal::Curvature_by_differences curvature(internal::piece(f, mesh.face_regions[i]), (a + b + c) / 3, step);
          gauss_curvatures[i] = curvature.flatter * curvature.steeper;
        });

    double area = 0;
    Approximation_bounds integrals;
    for (std::size_t i = 0; i < n; ++i)
    {
      const double gauss = gauss_curvatures[i], absolute = std::abs(gauss);
      const auto add_rms = [&](double& sum, const double c) { sum += areas[i] * std::cbrt(c * c * absolute); };
      area += areas[i];
      add_rms(integrals.rms_on_surface, gauss > 0 ? elliptic : hyperbolic);
      add_rms(integrals.rms_off_surface, gauss > 0 ? elliptic_off_surface : hyperbolic);
      const double root = areas[i] * std::sqrt(absolute);
      integrals.max_on_surface += root * (gauss > 0 ? elliptic_max : hyperbolic_max);
      integrals.max_off_surface += root * (gauss > 0 ? elliptic_max / 2 : hyperbolic_max);
    }
    Approximation_bounds result;
    result.number_of_faces = n;
    if (n == 0 || !(area > 0))
      return result;
    const auto rms = [&](const double integral) { return integral * std::sqrt(integral / area) / double(n); };
    result.rms_on_surface = rms(integrals.rms_on_surface);
    result.rms_off_surface = rms(integrals.rms_off_surface);
    result.max_on_surface = integrals.max_on_surface / double(n);
    result.max_off_surface = integrals.max_off_surface / double(n);
    return result;
  }
}

} // namespace Anisotropic_hde_remeshing
} // namespace CGAL

#endif // CGAL_ANISOTROPIC_HDE_REMESHING_APPROXIMATION_BOUNDS_H
